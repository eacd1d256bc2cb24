#include "patch_cover.hpp"

#include <array>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/plane_vectors.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t no_face = 0xFFFFFFFF;

} // namespace

PatchCover::PatchCover(const LineSet& lines, const Camera& camera)
    : lines_(lines), clip_from_world_(glm::dmat4{camera.projection} * glm::dmat4{camera.view}),
      size_(camera.size), beside_edge_(lines.contours.edges.size(), glm::uvec2{no_face}),
      asked_(lines.contours.faces.size(), 0) {
    for (std::uint32_t i = 0; i < lines.contours.faces.size(); ++i)
        for (int k = 0; k < 3; ++k) {
            glm::uvec2& faces = beside_edge_[lines.contours.faces[i][k] & ~LA_CONTOUR_TURNED];
            (faces.x == no_face ? faces.x : faces.y) = i;
        }
}

PatchCover::Corner PatchCover::project(std::uint32_t vertex) const {
    const glm::dvec4 clip = clip_from_world_ * glm::dvec4{glm::dvec3{lines_.vertices[vertex]}, 1};
    const glm::dvec3 device = glm::dvec3{clip} / clip.w;
    return {.at = {(device.x + 1) * 0.5 * size_.x, (1 - device.y) * 0.5 * size_.y},
            .depth = (device.z + 1) * 0.5,
            .is_seen = clip.w > 0};
}

bool PatchCover::hides(std::uint32_t face, const VectorPoint& place, double reach) {
    ++query_;
    asked_[face] = query_;
    waiting_.assign(1, face);
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
        const glm::uvec3 edges = lines_.contours.faces[waiting_[i]];
        std::array<Corner, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t edge = edges[static_cast<int>(k)];
            const glm::uvec2 ends = lines_.contours.edges[edge & ~LA_CONTOUR_TURNED];
            const std::uint32_t corner = (edge & LA_CONTOUR_TURNED) != 0 ? ends.y : ends.x;
            corners[k] = project(lines_.contours.corners[corner].vertex);
        }
        const auto& [a, b, c] = corners;
        if (!a.is_seen || !b.is_seen || !c.is_seen) continue;
        const glm::dvec2 low = glm::min(glm::min(a.at, b.at), c.at) - reach;
        const glm::dvec2 high = glm::max(glm::max(a.at, b.at), c.at) + reach;
        if (place.at.x < low.x || place.at.y < low.y || place.at.x > high.x || place.at.y > high.y)
            continue;
        const double area = cross(b.at - a.at, c.at - a.at);
        const double share_b = cross(place.at - a.at, c.at - a.at) / area;
        const double share_c = cross(b.at - a.at, place.at - a.at) / area;
        constexpr double slack = 1e-9; // so that no place lies between two triangles
        if (area != 0 && share_b > -slack && share_c > -slack && share_b + share_c < 1 + slack &&
            a.depth + share_b * (b.depth - a.depth) + share_c * (c.depth - a.depth) < place.depth)
            return true;
        for (int k = 0; k < 3; ++k) {
            const glm::uvec2 faces = beside_edge_[edges[k] & ~LA_CONTOUR_TURNED];
            for (const std::uint32_t next : {faces.x, faces.y}) {
                if (next == no_face || asked_[next] == query_) continue;
                asked_[next] = query_;
                waiting_.push_back(next);
            }
        }
    }
    return false;
}

} // namespace lineatlas
