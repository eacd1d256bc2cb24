#include "arguments.hpp"

namespace lineatlas::python {

py::str readable(std::string_view text) {
    PyObject* decoded = PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()),
                                             "backslashreplace");
    if (decoded == nullptr) throw py::error_already_set();
    return py::reinterpret_steal<py::str>(decoded);
}

std::string shown(py::handle value) {
    constexpr std::size_t longest = 60;
    const auto text = py::reinterpret_steal<py::object>(PyObject_ASCII(value.ptr()));
    if (!text) PyErr_Clear();
    const std::string written = text ? text.cast<std::string>() : "";
    if (!written.empty() && written.size() <= longest && written.find('\n') == std::string::npos)
        return written;
    return "a value of type " + std::string{Py_TYPE(value.ptr())->tp_name};
}

py::type_error wrong_argument(std::string_view name, std::string_view wanted, py::handle given) {
    const std::string called{name};
    if (PyUnicode_Check(given.ptr()) && PyUnicode_AsUTF8(given.ptr()) == nullptr) {
        PyErr_Clear();
        return py::type_error(called + ": the text " + shown(given) +
                              " has a surrogate without its pair, which cannot be encoded");
    }
    return py::type_error(called + " must be " + std::string{wanted} + ", not " + shown(given));
}

} // namespace lineatlas::python
