#pragma once

#include <functional>

#include "lineatlas/error.hpp"
#include "lineatlas/export.hpp"

namespace lineatlas {

/// Told by a call that may take long how much of it is done, as a share from 0 to 1 that never
/// falls; the last one is 1. Returns whether to go on: after false the call throws Cancelled, and
/// what it was to make is not made. Runs on the thread of the call, between steps of its work, and
/// must not throw. Empty: nobody asks.
using Progress = std::function<bool(float done)>;

/// A call was stopped by its Progress.
class LINEATLAS_API Cancelled : public Error {
  public:
    using Error::Error;
};

} // namespace lineatlas
