#pragma once

#include <memory>

#include "lineatlas/export.hpp"

/// @file
/// A GL context without a window.
/// @code{.cpp}
/// HeadlessContext context; // current from here on
/// Renderer offscreen;      // in this context; draw into a framebuffer of your own
/// @endcode

namespace lineatlas {

/// A GL 4.5 core context without a window or a display server (EGL surfaceless). It is current on
/// the thread that made it until it is destroyed or another context is made current there. It has
/// no framebuffer of its own.
class LINEATLAS_API HeadlessContext {
  public:
    /// Throws DeviceError if EGL or GL 4.5 is missing; the message says which package to install.
    HeadlessContext();
    /// If another context is current, it stays current.
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    /// Makes the context current on this thread; it must be current on no other. Throws
    /// DeviceError.
    void make_current();

  private:
    struct LINEATLAS_LOCAL State;
    std::unique_ptr<State> state_;
};

} // namespace lineatlas
