#include "check_camera.hpp"

#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "lineatlas/error.hpp"
#include "picture_size.hpp"

namespace lineatlas {
namespace {

[[noreturn]] void refuse(const char* matrix, const char* what) {
    throw UsageError(std::string{"camera: the "} + matrix + " is " + what +
                     "; view and projection must be finite numbers that have an inverse");
}

void check_finite(const glm::mat4& m, const char* name) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(m[column][row])) refuse(name, "not finite");
}

/// The matrix with columns of length 1; columns of zeros stay.
glm::dmat4 with_unit_columns(glm::dmat4 m) {
    for (int column = 0; column < 4; ++column) {
        const double length = glm::length(m[column]);
        if (length > 0) m[column] /= length;
    }
    return m;
}

/// The answer depends neither on the units of the two spaces nor on the distance of the origin.
bool is_singular(const glm::mat4& m) {
    constexpr double least = 1e-12; // rounding leaves less of equal columns
    const glm::dmat4 scaled = with_unit_columns(glm::transpose(with_unit_columns(glm::dmat4{m})));
    return !(std::abs(glm::determinant(scaled)) > least);
}

void check_matrix(const glm::mat4& m, const char* name) {
    check_finite(m, name);
    if (is_singular(m)) refuse(name, "singular");
}

} // namespace

void check_camera(const Camera& camera) {
    check_picture(camera.size);
    check_matrix(camera.view, "view matrix");
    check_matrix(camera.projection, "projection matrix");
    check_finite(camera.clip_from_world(), "product of projection and view"); // may overflow
}

} // namespace lineatlas
