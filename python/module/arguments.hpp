#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include <pybind11/pybind11.h>

// Arguments whose errors are a TypeError of one line with the argument's name, instead of
// pybind11's list of signatures. Also values as text for people.
namespace lineatlas::python {

namespace py = pybind11;

/// A text as a parameter of a template.
template <std::size_t size>
struct Text {
    char letters[size];
    constexpr Text(const char (&text)[size]) { std::copy_n(text, size, letters); }
};

/// A parameter of a bound function. `wanted` names the values that it takes.
template <class T, Text name, Text wanted>
struct Argument {
    T value{};
    operator const T&() const { return value; }
    const T& operator*() const { return value; }
    const T* operator->() const { return &value; }
};

template <Text name>
using Flag = Argument<bool, name, "True or False">;
template <Text name>
using Word = Argument<std::string, name, "text">;
template <Text name>
using Real = Argument<float, name, "a number">;

/// Text that may hold bytes of a file or of its name, as a Python string. Bytes that are not UTF-8
/// become escapes such as `\x80`.
py::str readable(std::string_view text);

/// A value as text for people: its repr() if that is short, else its type.
std::string shown(py::handle value);

/// The TypeError for an argument of the wrong type.
py::type_error wrong_argument(std::string_view name, std::string_view wanted, py::handle given);

} // namespace lineatlas::python

namespace pybind11::detail {

template <class T, lineatlas::python::Text argument, lineatlas::python::Text wanted>
struct type_caster<lineatlas::python::Argument<T, argument, wanted>> {
    using Own = lineatlas::python::Argument<T, argument, wanted>;
    PYBIND11_TYPE_CASTER(Own, make_caster<T>::name);

    bool load(handle given, bool convert) {
        make_caster<T> inner;
        if (!inner.load(given, convert))
            throw lineatlas::python::wrong_argument(argument.letters, wanted.letters, given);
        value.value = cast_op<T>(std::move(inner));
        return true;
    }
};

} // namespace pybind11::detail
