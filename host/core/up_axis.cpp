#include "up_axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

namespace lineatlas {
namespace {

/// A face within this share of the extent lies at an end; a face with at least this cosine is
/// level.
constexpr double at_end = 0.01, level = 0.98;
/// The lead that one axis must have over the other.
constexpr double ahead_factor = 1.5, ahead_by = 0.1;

/// Measures of the triangles along one axis.
class Spread {
  public:
    Spread(const Bounds& bounds, int axis)
        : axis_(axis), low_(bounds.min[axis]),
          extent_(static_cast<double>(bounds.max[axis]) - low_) {
        const glm::dvec3 size = glm::dvec3{bounds.max} - glm::dvec3{bounds.min};
        across_ = size[(axis + 1) % 3] * size[(axis + 2) % 3];
    }

    void add(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double area = 0.5 * glm::length(normal);
        if (!(area > 0)) return;
        const auto place = [&](double at) { return (at - low_) / extent_; };
        const double lowest = place(std::min({a[axis_], b[axis_], c[axis_]}));
        const double highest = place(std::max({a[axis_], b[axis_], c[axis_]}));
        area_ += area;
        moment_ += area * place((a[axis_] + b[axis_] + c[axis_]) / 3);
        if (std::abs(normal[axis_]) < level * 2 * area) return;
        if (highest < at_end) bottom_ += area;
        if (lowest > 1 - at_end) top_ += area;
    }

    /// The score of this axis: higher is more likely to be up.
    double score() const {
        if (!(area_ > 0) || !(across_ > 0) || !(extent_ > 0)) return 0;
        constexpr double of_uneven = 3;
        return std::abs(bottom_ - top_) / across_ + of_uneven * std::abs(moment_ / area_ - 0.5);
    }

  private:
    int axis_;
    double low_, extent_, across_ = 0;
    double area_ = 0, moment_ = 0, bottom_ = 0, top_ = 0;
};

} // namespace

glm::vec3 guess_up(const Mesh& mesh, UsualUp usual) {
    const Bounds bounds = bounds_of(mesh);
    Spread y{bounds, 1}, z{bounds, 2};
    for (const glm::uvec3 triangle : mesh.triangles) {
        const glm::dvec3 a{mesh.positions[triangle.x]}, b{mesh.positions[triangle.y]},
            c{mesh.positions[triangle.z]};
        y.add(a, b, c);
        z.add(a, b, c);
    }
    const auto clear = [](const Spread& one, const Spread& other) {
        return one.score() > ahead_factor * other.score() + ahead_by;
    };
    const bool z_up = usual == UsualUp::z ? !clear(y, z) : clear(z, y);
    return z_up ? glm::vec3{0, 0, 1} : glm::vec3{0, 1, 0};
}

} // namespace lineatlas
