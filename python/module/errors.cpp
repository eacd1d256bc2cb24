#include <algorithm>
#include <exception>
#include <string>
#include <string_view>

#include "arguments.hpp"
#include "bindings.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/progress.hpp"
#include "style/member_names.hpp"

namespace lineatlas::python {
namespace {

namespace py = pybind11;

/// The exception types. They live as long as the interpreter, so their references are never
/// released.
struct ErrorTypes {
    PyObject* error = nullptr;
    PyObject* usage = nullptr;
    PyObject* file = nullptr;
    PyObject* device = nullptr;
    PyObject* mismatch = nullptr;
    PyObject* cancelled = nullptr;
};
ErrorTypes types;

PyObject* make_type(py::module_& module, const char* name, const char* doc,
                    const py::tuple& bases) {
    const std::string full_name = std::string{"lineatlas."} + name;
    PyObject* type = PyErr_NewExceptionWithDoc(full_name.c_str(), doc, bases.ptr(), nullptr);
    if (type == nullptr) throw py::error_already_set();
    module.attr(name) = py::handle(type);
    return type;
}

/// The Python name of a setting or argument.
std::string called(const std::string& key) {
    if (key == "tile") return "`lineatlas draw --tile`"; // there is none in Python
    std::string name = key;
    std::ranges::replace(name, '-', '_');
    return name;
}

void raise(PyObject* type, const Error& error) {
    PyErr_SetObject(type, readable(with_members_called(error.what(), called)).ptr());
}

void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const UsageError& error) {
        raise(types.usage, error);
    } catch (const FileError& error) {
        raise(types.file, error);
    } catch (const DeviceError& error) {
        raise(types.device, error);
    } catch (const MismatchError& error) {
        raise(types.mismatch, error);
    } catch (const Cancelled& error) {
        raise(types.cancelled, error);
    } catch (const Error& error) {
        raise(types.error, error);
    }
}

} // namespace

void bind_errors(py::module_& module) {
    const auto both = [](PyObject* builtin) {
        return py::make_tuple(py::handle(types.error), py::handle(builtin));
    };
    types.error = make_type(module, "Error", "Base of all that lineatlas raises on purpose.",
                            py::make_tuple(py::handle(PyExc_Exception)));
    types.usage =
        make_type(module, "UsageError", "Something asked for does not exist or makes no sense.",
                  both(PyExc_ValueError));
    types.file = make_type(module, "FileError",
                           "A file can't be read or written, or holds something else than it says.",
                           both(PyExc_OSError));
    types.device =
        make_type(module, "DeviceError", "The machine can't do it; the message says what helps.",
                  both(PyExc_RuntimeError));
    types.mismatch =
        make_type(module, "MismatchError", "Two compute backends disagree where they must not.",
                  both(PyExc_RuntimeError));
    types.cancelled = make_type(module, "Cancelled", "A call was stopped by its `progress`.",
                                py::make_tuple(py::handle(types.error)));
    py::register_exception_translator(&translate);
}

} // namespace lineatlas::python
