#include <algorithm>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "bindings.hpp"

namespace lineatlas::python {
namespace {

namespace py = pybind11;

/// The type of METH_FASTCALL functions with keywords. Python itself names it since version 3.13.
using FastCall = PyObject* (*)(PyObject*, PyObject* const*, Py_ssize_t, PyObject*);

/// pybind11's dispatchers of all functions. Version 3.0.2 and later use the second one.
PyCFunctionWithKeywords call = nullptr;
FastCall call_fast = nullptr;

const py::detail::function_record* record_in(PyObject* self) {
    if (self == nullptr) return nullptr;
#if PYBIND11_VERSION_MAJOR >= 3 // which keeps records in objects of its own type
    return py::detail::function_record_ptr_from_PyObject(self);
#else
    if (!PyCapsule_CheckExact(self)) return nullptr;
    return static_cast<const py::detail::function_record*>(
        PyCapsule_GetPointer(self, PyCapsule_GetName(self)));
#endif
}

std::vector<std::string> names_of(const py::detail::function_record& function) {
    std::vector<std::string> names;
    for (const py::detail::argument_record& argument : function.args) {
        const std::string_view name = argument.name != nullptr ? argument.name : "";
        if (!name.empty() && name != "self") names.emplace_back(name);
    }
    return names;
}

/// The function behind an attribute of the module or of a class; null if pybind11 did not make it.
PyCFunctionObject* function_behind(py::handle attribute) {
    PyObject* object = attribute.ptr();
    if (PyInstanceMethod_Check(object)) object = PyInstanceMethod_GET_FUNCTION(object);
    return PyCFunction_Check(object) ? reinterpret_cast<PyCFunctionObject*>(object) : nullptr;
}

std::string list_of(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list.empty() ? "none" : list;
}

/// The name most similar to an unknown name; empty if none is similar.
std::string nearest(const std::string& name, const std::vector<std::string>& names) {
    py::list known;
    for (const std::string& each : names) known.append(each);
    const py::list like = py::module_::import("difflib").attr("get_close_matches")(name, known, 1);
    return like.empty() ? "" : like[0].cast<std::string>();
}

/// The message for an unknown argument. It names the most similar argument of the function or of
/// its class's constructor; if there is none, all arguments of the function.
std::string message(const py::detail::function_record& function, const std::string& unknown) {
    const bool makes = std::string_view{function.name} == "__init__";
    const auto name =
        makes ? function.scope.attr("__name__").cast<std::string>() : std::string{function.name};
    const std::string start = name + "() has no argument \"" + unknown + "\"; ";
    const std::vector<std::string> own = names_of(function);
    std::vector<std::string> names = own;
    if (!makes && py::isinstance<py::type>(function.scope)) {
        const PyCFunctionObject* maker = function_behind(py::getattr(function.scope, "__init__"));
        if (const auto* made_by = maker != nullptr ? record_in(maker->m_self) : nullptr)
            for (const std::string& each : names_of(*made_by)) names.push_back(each);
    }
    const std::string near = nearest(unknown, names);
    if (near.empty()) return start + "it has " + list_of(own);
    const std::string meant = start + "did you mean \"" + near + '"';
    if (std::find(own.begin(), own.end(), near) != own.end()) return meant + "?";
    return meant + " of " + function.scope.attr("__name__").cast<std::string>() + "()?";
}

/// The first unknown name in `named`, a dictionary or a tuple of names; empty if all are known.
std::string unknown_in(const py::detail::function_record& function, PyObject* named) {
    if (named == nullptr || function.has_kwargs || function.next != nullptr) return {};
    const std::vector<std::string> names = names_of(function);
    for (const py::handle key : py::reinterpret_borrow<py::object>(named)) {
        const auto name = key.cast<std::string>();
        if (std::find(names.begin(), names.end(), name) == names.end()) return name;
    }
    return {};
}

/// The result of a call. Replaces an error by one that names the argument.
PyObject* in_words(PyObject* self, PyObject* named, PyObject* result) {
    const auto* function = record_in(self);
    if (result != nullptr || function == nullptr || PyErr_ExceptionMatches(PyExc_TypeError) == 0)
        return result;
    PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
    PyErr_Fetch(&type, &value, &trace);
    std::string words;
    try {
        const std::string unknown = unknown_in(*function, named);
        if (!unknown.empty()) words = message(*function, unknown);
    } catch (const std::exception&) {
        words.clear(); // keeps pybind11's own message
    }
    if (words.empty()) {
        PyErr_Restore(type, value, trace);
        return nullptr;
    }
    for (PyObject* each : {type, value, trace}) Py_XDECREF(each);
    PyErr_SetString(PyExc_TypeError, words.c_str());
    return nullptr;
}

PyObject* call_in_words(PyObject* self, PyObject* arguments, PyObject* named) {
    return in_words(self, named, call(self, arguments, named));
}

PyObject* call_fast_in_words(PyObject* self, PyObject* const* arguments, Py_ssize_t count,
                             PyObject* names) {
    return in_words(self, names, call_fast(self, arguments, count, names));
}

template <class Call>
PyCFunction untyped(Call one) {
    return reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(one));
}

/// Replaces a function's dispatcher by `own` and stores the old one in `before`.
template <class Call>
void replace(PyMethodDef& method, Call own, Call& before) {
    if (method.ml_meth == untyped(own)) return;
    before = reinterpret_cast<Call>(reinterpret_cast<void (*)()>(method.ml_meth));
    method.ml_meth = untyped(own);
}

void name_in(const py::dict& attributes) {
    for (const auto& [name, attribute] : attributes) {
        PyCFunctionObject* function = function_behind(attribute);
        if (function == nullptr || record_in(function->m_self) == nullptr) continue;
        if ((function->m_ml->ml_flags & METH_FASTCALL) != 0)
            replace(*function->m_ml, FastCall{call_fast_in_words}, call_fast);
        else
            replace(*function->m_ml, PyCFunctionWithKeywords{call_in_words}, call);
    }
}

} // namespace

void name_unknown_arguments(py::module_& module) {
    const py::dict attributes = module.attr("__dict__");
    name_in(attributes);
    for (const auto& [name, attribute] : attributes)
        if (py::isinstance<py::type>(attribute))
            name_in(py::dict(py::getattr(attribute, "__dict__")));
}

} // namespace lineatlas::python
