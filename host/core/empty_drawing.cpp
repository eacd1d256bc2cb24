#include "empty_drawing.hpp"

#include <algorithm>

#include <glm/vec4.hpp>

#include "standard_camera.hpp"

namespace lineatlas {
namespace {

/// Whether any of a line lies within the planes of clip space (Liang and Barsky 1984).
bool is_in_view(glm::vec4 p, glm::vec4 q) {
    float first = 0, last = 1;
    for (int plane = 0; plane < 6; ++plane) {
        const float sign = plane % 2 == 0 ? 1.0F : -1.0F;
        const float at_p = p.w + sign * p[plane / 2];
        const float at_q = q.w + sign * q[plane / 2];
        if (at_p < 0 && at_q < 0) return false;
        if (at_p < 0) first = std::max(first, at_p / (at_p - at_q));
        if (at_q < 0) last = std::min(last, at_p / (at_p - at_q));
    }
    return first <= last;
}

bool all_behind(const LineSet& lines, const glm::mat4& clip_from_world) {
    return std::ranges::none_of(lines.vertices, [&](glm::vec3 vertex) {
        return (clip_from_world * glm::vec4{vertex, 1}).w > 0;
    });
}

std::string names_of(LineKindMask kinds) {
    std::string names;
    for (std::size_t i = 0; i < line_kind_names.size(); ++i) {
        if ((kinds & (1U << i)) == 0) continue;
        if (!names.empty()) names += ", ";
        names += line_kind_names[i];
    }
    return names;
}

} // namespace

bool any_in_view(const LineSet& lines, const Camera& camera) {
    if (lines.segments.empty()) return false;
    const glm::mat4 clip_from_world =
        standard_camera(camera, lines.bounds).camera.clip_from_world();
    const auto clip = [&](std::uint32_t vertex) {
        return clip_from_world * glm::vec4{lines.vertices[vertex], 1};
    };
    return std::ranges::any_of(lines.segments, [&](const Segment& segment) {
        return is_in_view(clip(segment.p), clip(segment.q));
    });
}

std::string why_no_line(const LineSet& lines, LineKindMask kinds, const Camera& camera) {
    if (lines.vertices.empty()) return "the model has no triangles and no lines";
    if (lines.segments.empty()) {
        const bool creases = (kinds & mask_of(LineKind::crease)) != 0;
        return "the model has none of the kinds " + names_of(kinds) +
               (creases ? "; a smaller crease angle finds more" : "");
    }
    if (any_in_view(lines, camera))
        return "surfaces hide those in the picture, or the style leaves them out";
    return all_behind(lines, camera.clip_from_world())
               ? "the model lies behind the camera, which looks away from it"
               : "none lies in the part of the model that the camera sees";
}

} // namespace lineatlas
