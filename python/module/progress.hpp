#pragma once

#include <utility>

#include <pybind11/pybind11.h>

#include "lineatlas/progress.hpp"
#include "process.hpp"

namespace lineatlas::python {

/// What Python is asked while a call works without the interpreter's lock: whether the person has
/// pressed Ctrl-C, and a callable, if there is one, with the share that is done.
class Asked {
  public:
    /// Throws TypeError for what is neither None nor callable.
    explicit Asked(pybind11::object callable);

    Progress progress();
    /// After Cancelled: throws what Ctrl-C or the callable has raised, if that was the reason.
    void raise() const;

  private:
    bool ask(float done);

    pybind11::object callable_;
    PyObject *type_ = nullptr, *value_ = nullptr, *trace_ = nullptr; ///< raised
};

/// Works without the interpreter's lock; `action(progress)` gives the result.
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
