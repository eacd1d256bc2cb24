#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::bench {

/// The clipped segments of a view and their samples, equal to the renderer's bit by bit.
struct ClippedLines {
    std::vector<ClippedSegment> clipped; ///< only valid for segments with samples
    std::vector<std::uint32_t> offsets;  ///< first sample of each segment, then the total

    std::uint32_t samples(std::size_t segment) const {
        return offsets[segment + 1] - offsets[segment];
    }
};

/// Clips all segments. `step` is k, the pixels between samples (§4.1 eq. 1).
ClippedLines clip_lines(const LineSet& lines, const Camera& camera, float step,
                        LineKindMask kinds = all_line_kinds);

/// A segment in the window: pixels, origin at the lower left. at(u) is the point at share `u`.
struct WindowSegment {
    glm::dvec2 p, q;
    glm::dvec2 at(double u) const { return p + (q - p) * u; }
};
WindowSegment window_segment(const ClippedSegment& segment, glm::ivec2 viewport);

/// The parameter along the whole segment, linear in the model, at share `u` of the clipped segment
/// in the window.
double parameter_at(const ClippedSegment& segment, double u);
/// The inverse of parameter_at(); nothing outside the clipped segment.
std::optional<double> share_at(const ClippedSegment& segment, double t);

} // namespace lineatlas::bench
