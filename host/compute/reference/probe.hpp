#pragma once

// Looking at the depth buffer along a segment: what the twins of `atlas` and `intervals` share. See
// kernels/probe.h.

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "segment_table.h"

namespace lineatlas::compute::reference {

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

Spine make_spine(const ClippedSegment& segment, glm::vec2 viewport, float depth_scale);

/// The depth buffer, and how much may stand before a line: in window depth times w.
struct Depth {
    std::span<const float> texels;
    glm::ivec2 size;
    float scale; ///< texels per pixel
    float tolerance;
};

/// Whether a probe `side` pixels to the left of the point at share u of the segment sees the line.
bool sees_line(const Spine& spine, float u, float side, const Depth& depth);

} // namespace lineatlas::compute::reference
