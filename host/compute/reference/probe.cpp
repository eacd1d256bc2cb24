#include "probe.hpp"

namespace lineatlas::compute::reference {

Spine make_spine(const ClippedSegment& segment, glm::vec2 viewport, float depth_scale) {
    const glm::vec3 p{segment.p[0], segment.p[1], segment.p[2]};
    const glm::vec3 q{segment.q[0], segment.q[1], segment.q[2]};
    const float wp = segment.p[3];
    const float wq = segment.q[3];
    const glm::vec3 scale{viewport * 0.5F, 0.5F};
    const glm::vec3 window_p = (p / wp + 1.0F) * scale;
    const glm::vec3 window_q = (q / wq + 1.0F) * scale;
    const glm::vec3 d = window_q - window_p;
    const float length_px = std::sqrt(d.x * d.x + d.y * d.y);
    return {.p = glm::vec2{window_p} * depth_scale,
            .d = glm::vec2{d} * depth_scale,
            .depth_p = window_p.z,
            .depth_d = d.z,
            .inverse_w_p = 1 / wp,
            .inverse_w_d = 1 / wq - 1 / wp,
            .along = length_px > 0 ? glm::vec2{d} / length_px : glm::vec2{1, 0},
            .depth_along = length_px > 0 ? d.z / length_px : 0,
            .a = OwnFace{segment.own_a},
            .b = OwnFace{segment.own_b}};
}

bool sees_line(const Spine& spine, float u, float side, const Depth& depth) {
    const float inverse_scale = 1.0F / depth.scale;
    const glm::vec2 left{-spine.along.y, spine.along.x};
    const glm::vec2 point = spine.p + spine.d * u;
    const glm::vec2 probe = point + left * (side * depth.scale);
    const glm::ivec2 texel = glm::clamp(glm::ivec2{std::floor(probe.x), std::floor(probe.y)},
                                        glm::ivec2{0}, depth.size - 1);
    const glm::vec2 offset = (glm::vec2{texel} + 0.5F - point) * inverse_scale;
    const float along = offset.x * spine.along.x + offset.y * spine.along.y;
    const float across = offset.x * left.x + offset.y * left.y;
    const float line_depth = (spine.depth_p + spine.depth_d * u) + spine.depth_along * along;
    const float before =
        depth.tolerance * (spine.inverse_w_p + spine.inverse_w_d * u) + LA_DEPTH_ROUNDING;
    const auto index = static_cast<std::size_t>(texel.y) * depth.size.x + texel.x;
    const float seen = depth.texels[index] - line_depth;
    return seen >= -before || spine.a.matches(seen, across, before) ||
           spine.b.matches(seen, across, before);
}

} // namespace lineatlas::compute::reference
