#include "corner_normals.hpp"

#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

namespace lineatlas {

glm::dvec3 normal_by_angle(glm::dvec3 u, glm::dvec3 v, glm::dvec3 known) {
    const glm::dvec3 normal = glm::cross(u, v);
    const double sine = glm::length(normal);
    if (!(sine > 0)) return glm::dvec3{0};
    const double angle = std::atan2(sine, glm::dot(u, v));
    return angle * (known != glm::dvec3{0} ? known : normal / sine);
}

CornerPlaces find_corner_places(const Contours& contours, std::span<const Segment> segments) {
    const std::span<const Segment> own = segments.last(contours.faces.size());
    // Calls `each` with every corner of contours and the corner of a triangle there.
    const auto for_each_place = [&](const auto& each) {
        for (std::size_t i = 0; i < own.size(); ++i) {
            const glm::uvec3 face = contours.faces[i];
            if (face.x == face.y) continue; // in empty room, see Assembly
            for (int k = 0; k < 3; ++k) {
                const glm::uvec2 edge = contours.edges[face[k] & ~LA_CONTOUR_TURNED];
                const bool turned = (face[k] & LA_CONTOUR_TURNED) != 0;
                each(turned ? edge.y : edge.x, 3 * own[i].face_a + static_cast<std::uint32_t>(k));
            }
        }
    };
    CornerPlaces result;
    result.offsets.assign(contours.corners.size() + 1, 0);
    for_each_place([&](std::uint32_t corner, std::uint32_t) { ++result.offsets[corner + 1]; });
    std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
    result.places.resize(result.offsets.back());
    std::vector<std::uint32_t> next(result.offsets.begin(), result.offsets.end() - 1);
    for_each_place(
        [&](std::uint32_t corner, std::uint32_t place) { result.places[next[corner]++] = place; });
    return result;
}

void find_normals(LineSet& lines) {
    if (lines.contours.empty()) return;
    const CornerPlaces found = find_corner_places(lines.contours, lines.segments);
    const auto at = [&](std::uint32_t place) {
        return glm::dvec3{lines.vertices[lines.triangles[place / 3][static_cast<int>(place % 3)]]};
    };
    for (std::size_t i = 0; i < lines.contours.corners.size(); ++i) {
        glm::dvec3 sum{0};
        for (std::uint32_t k = found.offsets[i]; k < found.offsets[i + 1]; ++k) {
            const std::uint32_t place = found.places[k], next = next_corner(place);
            sum += normal_by_angle(at(next) - at(place), at(next_corner(next)) - at(place), {});
        }
        const double length = glm::length(sum);
        if (length > 0) sum /= length;
        for (int axis = 0; axis < 3; ++axis)
            lines.contours.corners[i].normal[axis] = static_cast<float>(sum[axis]);
    }
}

} // namespace lineatlas
