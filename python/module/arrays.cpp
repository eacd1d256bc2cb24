#include "arrays.hpp"

#include <cmath>
#include <string>

#include "lineatlas/error.hpp"

namespace lineatlas::python {
namespace {

std::string shape_of(const py::array& array) {
    std::string text = "(";
    for (py::ssize_t i = 0; i < array.ndim(); ++i)
        text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
    return text + ")";
}

/// An object as an array of numbers. `kinds` lists the allowed kinds of NumPy types.
py::array number_array(py::handle object, const std::string& name, const std::string& kinds) {
    const py::array array = py::array::ensure(py::reinterpret_borrow<py::object>(object));
    if (!array) {
        PyErr_Clear(); // the message below says more
        throw py::type_error(name + " is not an array");
    }
    // NumPy makes an empty list an array of floats, so the type of empty arrays does not matter.
    if (array.size() != 0 && kinds.find(array.dtype().kind()) == std::string::npos) {
        const std::string wanted = kinds.find('f') != std::string::npos ? "real" : "whole";
        throw py::type_error(name + " must be " + wanted + " numbers, not " +
                             py::str(array.dtype()).cast<std::string>());
    }
    return array;
}

void check_rows(const py::array& array, py::ssize_t length, const std::string& name) {
    const bool empty_list = array.ndim() == 1 && array.size() == 0;
    if (empty_list || (array.ndim() == 2 && array.shape(1) == length)) return;
    throw UsageError(name + " must have the shape (n, " + std::to_string(length) + "), not " +
                     shape_of(array));
}

std::uint32_t checked_index(std::int64_t index, std::size_t limit, std::size_t place,
                            const char* name) {
    if (index >= 0 && static_cast<std::uint64_t>(index) < limit)
        return static_cast<std::uint32_t>(index);
    throw UsageError(std::string{name} + ": entry " + std::to_string(place) + " is " +
                     std::to_string(index) +
                     (limit == 0 ? ", but there is none to refer to"
                                 : ", not one of 0 to " + std::to_string(limit - 1)));
}

template <class Real, class Point>
std::vector<Point> finite_rows(const py::array& given, const char* name) {
    const py::array_t<Real, py::array::c_style | py::array::forcecast> rows(given);
    std::vector<Point> points(static_cast<std::size_t>(rows.size()) / 3);
    const Real* value = rows.data();
    for (std::size_t i = 0; i < points.size(); ++i, value += 3) {
        for (int axis = 0; axis < 3; ++axis) {
            points[i][axis] = static_cast<typename Point::value_type>(value[axis]);
            if (std::isfinite(static_cast<float>(value[axis]))) continue;
            throw UsageError(std::string{name} + ": row " + std::to_string(i) +
                             " is not finite as 32-bit floats");
        }
    }
    return points;
}

/// All entries in C order. Too large unsigned 64-bit entries become negative.
py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>
whole_numbers(const py::array& array) {
    return {array};
}

template <class Point>
std::vector<Point> rows_from(py::handle object, const char* name) {
    const py::array given = number_array(object, name, "fiu");
    check_rows(given, 3, name);
    // Values too large for a float become infinite without a warning if they come from doubles.
    return given.dtype().is(py::dtype::of<float>()) ? finite_rows<float, Point>(given, name)
                                                    : finite_rows<double, Point>(given, name);
}

} // namespace

std::vector<glm::vec3> points_from(py::handle object, const char* name) {
    return rows_from<glm::vec3>(object, name);
}

std::vector<glm::dvec3> exact_points_from(py::handle object, const char* name) {
    return rows_from<glm::dvec3>(object, name);
}

bool holds_floats(py::handle object) {
    return py::isinstance<py::array>(object) &&
           py::reinterpret_borrow<py::array>(object).dtype().is(py::dtype::of<float>());
}

std::vector<glm::mat4> matrices_from(py::handle object, const char* name) {
    const py::array given = number_array(object, name, "fiu");
    if (given.ndim() != 3 || given.shape(1) != 4 || given.shape(2) != 4) {
        throw UsageError(std::string{name} + " must have the shape (n, 4, 4), not " +
                         shape_of(given));
    }
    const py::array_t<double, py::array::c_style | py::array::forcecast> rows(given);
    std::vector<glm::mat4> matrices(static_cast<std::size_t>(rows.shape(0)));
    const double* value = rows.data();
    for (glm::mat4& matrix : matrices) {
        // NumPy stores rows, GLM columns.
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                matrix[column][row] = static_cast<float>(*value++);
    }
    return matrices;
}

std::vector<glm::uvec3> triangles_from(py::handle object, const char* name, std::size_t limit) {
    const py::array given = number_array(object, name, "iu");
    check_rows(given, 3, name);
    const auto rows = whole_numbers(given);
    const auto count = static_cast<std::size_t>(rows.size()) / 3;
    std::vector<glm::uvec3> triangles(count);
    const std::int64_t* value = rows.data();
    for (std::size_t i = 0; i < count; ++i, value += 3) {
        for (int corner = 0; corner < 3; ++corner)
            triangles[i][corner] = checked_index(value[corner], limit, i, name);
    }
    return triangles;
}

std::vector<std::array<std::uint32_t, 2>> pairs_from(py::handle object, const char* name,
                                                     std::size_t limit) {
    const py::array given = number_array(object, name, "iu");
    check_rows(given, 2, name);
    const auto rows = whole_numbers(given);
    std::vector<std::array<std::uint32_t, 2>> pairs(static_cast<std::size_t>(rows.size()) / 2);
    const std::int64_t* value = rows.data();
    for (std::size_t i = 0; i < pairs.size(); ++i, value += 2) {
        for (std::size_t end = 0; end < 2; ++end)
            pairs[i][end] = checked_index(value[end], limit, i, name);
    }
    return pairs;
}

std::vector<std::uint32_t> indices_from(py::handle object, const char* name, std::size_t limit) {
    const py::array given = number_array(object, name, "iu");
    if (given.ndim() != 1)
        throw UsageError(std::string{name} + " must have the shape (n,), not " + shape_of(given));
    const auto numbers = whole_numbers(given);
    std::vector<std::uint32_t> indices(static_cast<std::size_t>(numbers.size()));
    for (std::size_t i = 0; i < indices.size(); ++i)
        indices[i] = checked_index(numbers.data()[i], limit, i, name);
    return indices;
}

bool holds_integers(py::handle object) {
    const py::array array = py::array::ensure(py::reinterpret_borrow<py::object>(object));
    if (!array) PyErr_Clear();
    return array && array.ndim() == 1 &&
           (array.dtype().kind() == 'i' || array.dtype().kind() == 'u');
}

} // namespace lineatlas::python
