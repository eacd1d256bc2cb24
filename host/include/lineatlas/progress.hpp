#pragma once

#include <functional>

#include "lineatlas/error.hpp"
#include "lineatlas/export.hpp"

/// @file
/// The progress of a call that takes long, and how it is stopped.
/// @code{.cpp}
/// try {
///     extract_lines(mesh, {}, [&](float done) { return show(done), !stop; });
/// } catch (const Cancelled&) { // the program said stop
/// }
/// @endcode

namespace lineatlas {

/// A function that a long call calls with the share of its work that is done, from 0 to 1. The
/// share never falls, and the last one is 1. The function returns whether to go on: after false the
/// call throws Cancelled and has no result. It runs on the thread of the call, between steps of the
/// work, and must not throw. Empty: no progress is reported.
using Progress = std::function<bool(float done)>;

/// A call was stopped by its Progress.
class LINEATLAS_API Cancelled : public Error {
  public:
    using Error::Error;
};

} // namespace lineatlas
