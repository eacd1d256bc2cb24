#pragma once

#include <span>

#include "runs.hpp"

namespace lineatlas::test::oracles {

struct HaloInput {
    std::span<const Segment> segments;
    std::span<const ClippedSegment> clipped;
    std::span<const Run> runs;
    glm::vec2 viewport; ///< pixels
    float width;        ///< from the middle of the nearer stroke to the end of the gap, pixels
    float tolerance;    ///< lines nearer by more than this are nearer, window depth times w
};

/// The gaps of `halo`, from all pairs of runs that share a square of the picture. cuts: as many as
/// runs.
void halo(const HaloInput& input, std::span<RunCuts> cuts);

} // namespace lineatlas::test::oracles
