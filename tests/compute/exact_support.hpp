#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lineatlas/camera.hpp"
#include "lineatlas/compute_device.hpp"
#include "lineatlas/lines.hpp"

// The exact method without GL, from a line set to intervals on one device.
namespace lineatlas::test {

struct ExactResult {
    std::vector<Run> runs;           ///< visible ones, as spans_runs writes them
    std::vector<Interval> intervals; ///< visible and hidden, as spans_intervals writes them
    std::vector<ClippedSegment> clipped;
    std::vector<std::uint32_t> arcs;         ///< scanned
    std::vector<std::uint32_t> span_offsets; ///< scanned
    std::vector<float> spans;                ///< two per span
    int looks = 0;                           ///< the number of passes over all segments
};

/// `camera`: a standard one.
ExactResult find_exactly(compute::Device& device, const LineSet& lines, const Camera& camera,
                         LineKindMask kinds = all_line_kinds);

/// The length in pixels of all visible intervals of segments between these two points of the model.
float visible_length(const LineSet& lines, const ExactResult& result, glm::vec3 p, glm::vec3 q);

/// Looks along -z at the square from 0,0 to `side`,`side`, a unit of the model per pixel, by a
/// parallel projection.
Camera square_camera(int side);
/// A perspective camera that shows the same square at z = 0 from this distance.
Camera square_camera(int side, float distance, float near);

} // namespace lineatlas::test
