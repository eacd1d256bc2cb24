#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "compute/stages/stages.hpp"
#include "core/segment_chunks.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// What kernels read of a line set. Segments come in several chunks if the device has no buffer
/// that would hold a table of all of them.
struct LineTables {
    /// A part of the segment table.
    struct Chunk {
        SegmentRange range;
        std::unique_ptr<compute::Buffer> segments;
        /// Those that are silhouettes in some frames, at the end of `segments`.
        std::uint32_t candidate_count = 0;
        std::unique_ptr<compute::Buffer> end_offsets{}, ends{}; ///< where there are any
        /// Of contours; there are none where there are several chunks.
        std::unique_ptr<compute::Buffer> corners{}, edges{}, faces{}, patches{};
        std::uint32_t replaced = 0, vertex_count = 0;

        compute::SilhouetteCandidates candidates() const {
            return {range.count - candidate_count, candidate_count, end_offsets.get(), ends.get(),
                    contours()};
        }
        /// The same without contours: for vertices that have moved.
        compute::SilhouetteCandidates edge_candidates() const {
            return {range.count - candidate_count, candidate_count, end_offsets.get(), ends.get()};
        }
        std::optional<compute::ContourTables> contours() const;
        std::uint64_t bytes() const;
    };
    std::unique_ptr<compute::Buffer> vertices, triangles;
    std::vector<Chunk> chunks; ///< at least one
    std::uint64_t version = 0; ///< counts changes of what stands where

    /// What tables per segment must hold before silhouettes are found: all, or of the largest of
    /// several chunks what is not a candidate.
    std::uint32_t most_segments() const;
};

/// A buffer of the device with that content.
std::unique_ptr<compute::Buffer> upload(compute::Device& device, std::span<const std::byte> data,
                                        const Purpose& purpose);
/// `contours`: of the line set, if its vertices stand as they were made; else null.
std::vector<LineTables::Chunk> upload_segments(compute::Device& device,
                                               std::span<const Segment> segments,
                                               const LineSet* contours = nullptr);
/// Throws DeviceError when memory runs out, or where there is more than GL and kernels can count.
LineTables upload_lines(compute::Device& device, const LineSet& lines);

} // namespace lineatlas
