#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::bench {

/// The segments of a view with their samples, equal to those of the renderer bit by bit.
struct ClippedLines {
    std::vector<ClippedSegment> clipped; ///< valid where a segment has samples
    std::vector<std::uint32_t> offsets;  ///< first sample of each segment, then the total

    std::uint32_t samples(std::size_t segment) const {
        return offsets[segment + 1] - offsets[segment];
    }
};

/// `step`: k, pixels between samples (§4.1 eq. 1).
ClippedLines clip_lines(const LineSet& lines, const Camera& camera, float step,
                        LineKindMask kinds = all_line_kinds);

/// A segment's place in the window: pixels, origin at the lower left. A point at share `u` of it.
struct WindowSegment {
    glm::dvec2 p, q;
    glm::dvec2 at(double u) const { return p + (q - p) * u; }
};
WindowSegment window_segment(const ClippedSegment& segment, glm::ivec2 viewport);

/// From share `u` of a clipped segment in the window to the parameter along the whole segment, in
/// which the model's points are linear.
double parameter_at(const ClippedSegment& segment, double u);
/// The way back; nothing outside the clipped segment.
std::optional<double> share_at(const ClippedSegment& segment, double t);

} // namespace lineatlas::bench
