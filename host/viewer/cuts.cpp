#include "cuts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lineatlas/error.hpp"

namespace lineatlas::viewer {
namespace {

glm::dvec3 middle(const Bounds& bounds) {
    return 0.5 * (glm::dvec3{bounds.min} + glm::dvec3{bounds.max});
}

/// Half of the model's extent along a direction.
double half_along(glm::dvec3 direction, const Bounds& bounds) {
    return 0.5 * glm::dot(glm::abs(direction), glm::dvec3{bounds.max} - glm::dvec3{bounds.min});
}

/// The parameter at which the line comes nearest to the ray; nothing if they are parallel.
std::optional<double> nearest_to(glm::dvec3 direction, glm::dvec3 point, const Ray& ray) {
    const double cosine = glm::dot(direction, ray.direction);
    const double sine2 = 1 - cosine * cosine;
    constexpr double least = 1e-3; // about two degrees
    if (sine2 < least) return {};
    const glm::dvec3 offset = ray.origin - point;
    return (glm::dot(offset, direction) - cosine * glm::dot(offset, ray.direction)) / sine2;
}

} // namespace

std::optional<int> axis_of(const Cut& cut) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(cut.normal[axis]) == 1) return axis;
    return {};
}

Cut flipped(const Cut& cut) {
    Cut result = cut;
    result.normal = glm::dvec3{0} - cut.normal; // no minus zero
    result.at = 0 - cut.at;
    return result;
}

std::string text_of(const Cut& cut) {
    const glm::dvec3 n = cut.normal;
    if (const std::optional<int> axis = axis_of(cut))
        return fmt::format("{}{}={}", n[*axis] < 0 ? '-' : '+', "xyz"[*axis],
                           n[*axis] * cut.at + 0.0); // no minus zero
    const glm::dvec3 p = cut.at * n;
    return fmt::format("{},{},{}/{},{},{}", p.x, p.y, p.z, n.x, n.y, n.z);
}

Cut cut_from(std::string_view text, const Bounds& bounds, glm::dvec3 origin) {
    SectionPlane plane = parse_section(text, bounds);
    if (text.ends_with('%')) plane.point += origin;
    const glm::dvec3 normal = glm::normalize(plane.normal);
    return {.normal = normal, .at = glm::dot(normal, plane.point)};
}

Reach reach_along(glm::dvec3 normal, const Bounds& bounds, glm::dvec3 origin) {
    const double at = glm::dot(normal, middle(bounds) + origin), half = half_along(normal, bounds);
    return {at - half, at + half};
}

glm::dvec3 middle_of(const Cut& cut, const Bounds& bounds, glm::dvec3 origin) {
    const glm::dvec3 centre = middle(bounds);
    return centre + (cut.at - glm::dot(cut.normal, centre + origin)) * cut.normal;
}

std::array<glm::dvec3, 4> outline_of(const Cut& cut, const Bounds& bounds, glm::dvec3 origin) {
    const glm::dvec3 other =
        std::abs(cut.normal.x) < 0.7 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    const glm::dvec3 u = glm::normalize(other - glm::dot(other, cut.normal) * cut.normal);
    const glm::dvec3 v = glm::cross(cut.normal, u);
    // Larger, so that the outline is not mistaken for a line of the model.
    constexpr double margin = 1.04;
    const glm::dvec3 along_u = margin * half_along(u, bounds) * u;
    const glm::dvec3 along_v = margin * half_along(v, bounds) * v;
    const glm::dvec3 at = middle_of(cut, bounds, origin);
    return {at - along_u - along_v, at + along_u - along_v, at + along_u + along_v,
            at - along_u + along_v};
}

double way_along(glm::dvec3 normal, glm::dvec3 handle, const Ray& from, const Ray& to) {
    const std::optional<double> start = nearest_to(normal, handle, from);
    const std::optional<double> end = nearest_to(normal, handle, to);
    return start && end ? *end - *start : 0;
}

CutMesh apply_cuts(Mesh mesh, const std::vector<Cut>& cuts, glm::dvec3 origin) {
    CutMesh result;
    const Bounds bounds = bounds_of(mesh);
    std::vector<SectionPlane> planes;
    for (const Cut& cut : cuts) {
        if (!cut.on) continue;
        // The plane goes through its text, so that it equals the tool's plane to the last bit.
        planes.push_back(parse_section(text_of(cut), bounds));
        planes.back().point -= origin;
    }
    const auto try_planes = [&](const std::vector<SectionPlane>& tried) {
        Section section = cut_mesh(mesh, tried);
        result.planes = tried;
        result.mesh = std::move(section.mesh);
        result.notes = std::move(section.notes);
    };
    try {
        try_planes(planes);
    } catch (const UsageError&) {
        std::vector<SectionPlane> good;
        std::string refused;
        result.mesh = mesh;
        for (const SectionPlane& plane : planes) {
            good.push_back(plane);
            try {
                try_planes(good);
            } catch (const UsageError& error) {
                good.pop_back();
                refused = error.what();
            }
        }
        result.notes.push_back(refused);
    }
    return result;
}

bool is_cut_away(glm::dvec3 point, std::span<const SectionPlane> planes) {
    return std::ranges::any_of(planes, [&](const SectionPlane& plane) {
        return glm::dot(point - plane.point, plane.normal) > 0;
    });
}

} // namespace lineatlas::viewer
