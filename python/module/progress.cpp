#include "progress.hpp"

#include "arguments.hpp"

namespace lineatlas::python {

Asked::Asked(py::object callable) : callable_(std::move(callable)) {
    if (!callable_.is_none() && PyCallable_Check(callable_.ptr()) == 0)
        throw wrong_argument("progress", "a function of the share that is done", callable_);
}

Progress Asked::progress() {
    return [this](float done) { return ask(done); };
}

bool Asked::ask(float done) {
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() == 0) {
        if (callable_.is_none()) return true;
        const auto answer = py::reinterpret_steal<py::object>(
            PyObject_CallFunction(callable_.ptr(), "d", static_cast<double>(done)));
        if (answer) return answer.ptr() != Py_False;
    }
    PyErr_Fetch(&type_, &value_, &trace_);
    return false;
}

void Asked::raise() const {
    if (type_ == nullptr) return;
    PyErr_Restore(type_, value_, trace_);
    throw py::error_already_set();
}

} // namespace lineatlas::python
