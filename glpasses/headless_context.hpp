#pragma once

#include "lineatlas/headless.hpp"

namespace lineatlas::gl {

using lineatlas::HeadlessContext;

/// Keeps the EGL context that is current on this thread, or none, and makes it current again at its
/// end.
class CurrentContextKeeper {
  public:
    CurrentContextKeeper();
    ~CurrentContextKeeper();
    CurrentContextKeeper(const CurrentContextKeeper&) = delete;
    CurrentContextKeeper& operator=(const CurrentContextKeeper&) = delete;

  private:
    unsigned api_; ///< the API that EGL's calls on this thread refer to
    void* display_;
    void* context_;
    void* draw_;
    void* read_;
};

} // namespace lineatlas::gl
