#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include <pybind11/pybind11.h>

// Arguments that say what is wrong with them: a TypeError of one line with the argument's name, in
// place of pybind11's list of signatures. And text for people.
namespace lineatlas::python {

namespace py = pybind11;

/// A text as a parameter of a template.
template <std::size_t size>
struct Text {
    char letters[size];
    constexpr Text(const char (&text)[size]) { std::copy_n(text, size, letters); }
};

/// A parameter called `name` of a bound function, which must be `wanted`.
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

/// Text of a file, or with a file's name in it, whose bytes need not be UTF-8: those that are not
/// become `\x80`.
py::str readable(std::string_view text);

/// A value for people: as Python writes it if that is short, else its type.
std::string shown(py::handle value);

/// The TypeError of an argument that is not what is wanted.
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
