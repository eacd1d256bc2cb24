#pragma once

#include <utility>

#include <pybind11/pybind11.h>

#include "lineatlas/progress.hpp"
#include "process.hpp"

namespace lineatlas::python {

/// Asks Python while a call works without the interpreter's lock. It checks for Ctrl-C, and calls a
/// callable, if one is given, with the share that is done.
class Asked {
  public:
    /// Throws TypeError unless `callable` is None or callable.
    explicit Asked(pybind11::object callable);

    Progress progress();
    /// Call it after Cancelled. Rethrows the exception of Ctrl-C or of the callable, if there is
    /// one.
    void raise() const;

  private:
    bool ask(float done);

    pybind11::object callable_;
    PyObject *type_ = nullptr, *value_ = nullptr, *trace_ = nullptr; ///< the raised exception
};

/// Runs `action(progress)` without the interpreter's lock and returns its result.
template <class Action>
auto released(const pybind11::object& callable, const Action& action) {
    Asked asked{callable};
    try {
        const Released lock_released;
        return action(asked.progress());
    } catch (const Cancelled&) {
        asked.raise();
        throw;
    }
}

} // namespace lineatlas::python
