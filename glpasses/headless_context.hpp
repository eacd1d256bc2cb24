#pragma once

#include <memory>

namespace lineatlas::gl {

/// A GL 4.5 core context without a window or a display server (EGL surfaceless), current on the
/// thread that made it until it is destroyed or another is made current there.
class HeadlessContext {
  public:
    /// Throws DeviceError if EGL or GL 4.5 is missing; the message says which package to install.
    HeadlessContext();
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    /// On this thread; it must be current on no other. Throws DeviceError.
    void make_current();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Makes the EGL context that is current on this thread, or none, current again at its end.
class CurrentContextKeeper {
  public:
    CurrentContextKeeper();
    ~CurrentContextKeeper();
    CurrentContextKeeper(const CurrentContextKeeper&) = delete;
    CurrentContextKeeper& operator=(const CurrentContextKeeper&) = delete;

  private:
    unsigned api_; ///< that of EGL's calls on this thread
    void* display_;
    void* context_;
    void* draw_;
    void* read_;
};

} // namespace lineatlas::gl
