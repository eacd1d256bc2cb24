#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

// Converts NumPy arrays to the library's tables and back. A wrong type raises TypeError, a wrong
// shape or value UsageError. Both name the argument.
namespace lineatlas::python {

namespace py = pybind11;

using Triple = std::array<float, 3>;

inline glm::vec3 vector_of(const Triple& values) {
    return {values[0], values[1], values[2]};
}
inline std::tuple<float, float, float> tuple_of(glm::vec3 vector) {
    return {vector.x, vector.y, vector.z};
}

/// Rows of three numbers that are finite as floats, from any real type and memory order.
std::vector<glm::vec3> points_from(py::handle object, const char* name);
/// The same rows as doubles, with all their digits.
std::vector<glm::dvec3> exact_points_from(py::handle object, const char* name);
/// True if the array holds 32-bit floats, which lack digits of large coordinates.
bool holds_floats(py::handle object);

/// Matrices of finite numbers, from an array of the shape (n, 4, 4).
std::vector<glm::mat4> matrices_from(py::handle object, const char* name);

/// Rows of three indices, each below `limit`.
std::vector<glm::uvec3> triangles_from(py::handle object, const char* name, std::size_t limit);

/// Rows of two indices, each below `limit`.
std::vector<std::array<std::uint32_t, 2>> pairs_from(py::handle object, const char* name,
                                                     std::size_t limit);

/// A list of indices, each below `limit`.
std::vector<std::uint32_t> indices_from(py::handle object, const char* name, std::size_t limit);

/// True if `object`, as an array, holds whole numbers.
bool holds_integers(py::handle object);

/// An array that takes over the memory of `values` without a copy.
template <class T>
py::array array_of(std::vector<T>&& values, std::vector<py::ssize_t> shape) {
    auto* kept = new std::vector<T>(std::move(values));
    const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
    return py::array_t<T>(std::move(shape), kept->data(), owner);
}

/// A read-only array of memory that `owner` keeps alive.
template <class T>
py::array view_of(const T* values, std::vector<py::ssize_t> shape, py::handle owner) {
    py::array_t<T> array(std::move(shape), values, owner);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

} // namespace lineatlas::python
