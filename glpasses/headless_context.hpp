#pragma once

#include <memory>

namespace lineatlas::gl {

/// A GL 4.5 core context without a window or a display server (EGL surfaceless), current on the
/// thread that made it until it is destroyed.
class HeadlessContext {
  public:
    /// Throws DeviceError if EGL or GL 4.5 is missing; the message says which package to install.
    HeadlessContext();
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace lineatlas::gl
