#include "stages.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace lineatlas::compute::reference {
namespace {

/// One of the two faces of a line, as own_face in project_clip.cl describes it.
struct OwnFace {
    float slope;
    float height;

    explicit OwnFace(std::uint32_t packed)
        : slope(std::bit_cast<float>(packed << 16U)),
          height(std::bit_cast<float>(packed & 0xFFFF0000U)) {}

    /// Whether a depth `seen` from the line's own, `across` pixels to its left, is this face.
    bool matches(float seen, float across, float before) const {
        const float sign = height > 0 ? 1.0F : -1.0F;
        const float snap = std::fabs(slope) * LA_OWN_FACE_SNAP + LA_DEPTH_ROUNDING;
        const float expected = slope * across;
        const bool on_side = across * sign > -LA_OWN_FACE_SNAP;
        const bool in_reach = std::fabs(across) <= std::fabs(height) + LA_OWN_FACE_SNAP ||
                              std::fabs(expected) <= LA_OWN_FACE_REACH * before;
        return on_side && in_reach && std::fabs(seen - expected) <= std::fmin(snap, before);
    }
};

/// A segment on the screen, ready for its samples. Texels are those of the depth buffer.
struct Spine {
    glm::vec2 p, d;
    float depth_p, depth_d;
    float inverse_w_p, inverse_w_d;
    glm::vec2 along;
    float depth_along;
    OwnFace a, b;

    /// The outside of a fold, both faces on one side: 1 left, -1 right; 0 if the line is none.
    float outside() const {
        if (a.height > 0 && b.height > 0) return -1;
        return a.height < 0 && b.height < 0 ? 1.0F : 0.0F;
    }
};

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

std::uint32_t count_visible(const AtlasInput& in, const Spine& spine, std::uint32_t j,
                            float inverse_l) {
    std::uint32_t visible = 0;
    const float inverse_axis = 1.0F / static_cast<float>(in.probes);
    const float inverse_scale = 1.0F / in.depth_scale;
    const glm::vec2 left{-spine.along.y, spine.along.x};
    const float shift = in.probes == 1 ? spine.outside() * LA_FOLD_CLEARANCE * inverse_scale : 0;
    const float middle = 0.5F * static_cast<float>(in.probes - 1);
    const float inverse_probes = 1.0F / static_cast<float>(in.probes * in.probes);
    for (std::uint32_t row = 0; row < in.probes; ++row) {
        for (std::uint32_t column = 0; column < in.probes; ++column) {
            const float row_shift = (static_cast<float>(column) - middle) * inverse_probes;
            const float column_shift = (static_cast<float>(row) - middle) * inverse_probes;
            const float row_place = (static_cast<float>(row) + 0.5F) * inverse_axis + row_shift;
            const float side =
                (static_cast<float>(column) + 0.5F) * inverse_axis - 0.5F + column_shift + shift;
            const float u = (static_cast<float>(j) + row_place) * inverse_l;
            const glm::vec2 point = spine.p + spine.d * u;
            const float before =
                in.tolerance * (spine.inverse_w_p + spine.inverse_w_d * u) + LA_DEPTH_ROUNDING;
            const glm::vec2 probe = point + left * (side * in.depth_scale);
            const glm::ivec2 texel =
                glm::clamp(glm::ivec2{std::floor(probe.x), std::floor(probe.y)}, glm::ivec2{0},
                           in.depth_size - 1);
            const glm::vec2 offset = (glm::vec2{texel} + 0.5F - point) * inverse_scale;
            const float along = offset.x * spine.along.x + offset.y * spine.along.y;
            const float across = offset.x * left.x + offset.y * left.y;
            const float line_depth =
                (spine.depth_p + spine.depth_d * u) + spine.depth_along * along;
            const auto index = static_cast<std::size_t>(texel.y) * in.depth_size.x + texel.x;
            const float seen = in.depth[index] - line_depth;
            const bool sees = seen >= -before || spine.a.matches(seen, across, before) ||
                              spine.b.matches(seen, across, before);
            visible += sees ? 1 : 0;
        }
    }
    return visible;
}

/// Judged by the place in the whole picture, see atlas.cl.
bool is_in_core(const DepthTile& tile, const Spine& spine, std::uint32_t j, float inverse_l) {
    const glm::vec2 place = spine.p + spine.d * ((static_cast<float>(j) + 0.5F) * inverse_l);
    const glm::ivec2 texel{std::floor(place.x), std::floor(place.y)};
    return texel.x >= tile.core_low.x && texel.y >= tile.core_low.y && texel.x < tile.core_high.x &&
           texel.y < tile.core_high.y;
}

} // namespace

void atlas(const AtlasInput& in, std::span<std::uint8_t> alpha) {
    const std::uint32_t probes = in.probes * in.probes;
    for (std::size_t i = 0; i + 1 < in.offsets.size(); ++i) {
        const std::uint32_t begin = in.offsets[i];
        const std::uint32_t l = in.offsets[i + 1] - begin;
        if (l == 0) continue;
        if (begin >= in.capacity) return;
        const Spine whole = make_spine(in.clipped[i], in.viewport, in.depth_scale);
        Spine spine = whole;
        if (in.tile != nullptr) spine.p -= glm::vec2{in.tile->origin};
        const float inverse_l = 1.0F / static_cast<float>(l);
        const std::uint32_t address = in.layout.address(begin);
        const std::uint32_t stop = std::min(l, in.capacity - begin);
        for (std::uint32_t j = 0; j < stop; ++j) {
            if (in.tile != nullptr && !is_in_core(*in.tile, whole, j, inverse_l)) continue;
            const std::uint32_t visible = count_visible(in, spine, j, inverse_l);
            alpha[address + j] = static_cast<std::uint8_t>((visible * 255 + probes / 2) / probes);
        }
    }
}

} // namespace lineatlas::compute::reference
