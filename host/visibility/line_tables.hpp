#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "compute/stages/stages.hpp"
#include "contour_tracer.hpp"
#include "core/segment_chunks.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// The tables of a line set that kernels read. Segments are in several chunks if no buffer of the
/// device can hold all of them.
struct LineTables {
    /// A part of the segment table.
    struct Chunk {
        SegmentRange range;
        std::unique_ptr<compute::Buffer> segments;
        /// The number of candidates for silhouettes, at the end of `segments`.
        std::uint32_t candidate_count = 0;
        std::unique_ptr<compute::Buffer> end_offsets{}, ends{}; ///< null without candidates
        /// Tables of contours, in the chunk that has all candidates.
        std::unique_ptr<compute::Buffer> corners{}, edges{}, face_corners{}, faces{}, patches{};
        std::uint32_t replaced = 0, vertex_count = 0;

        /// `turned`: the corners of objects that have moved, in place of `corners`; null: none has
        /// moved.
        compute::SilhouetteCandidates candidates(compute::Buffer* turned = nullptr) const {
            return {range.count - candidate_count, candidate_count, end_offsets.get(), ends.get(),
                    contours(turned)};
        }
        std::optional<compute::ContourTables> contours(compute::Buffer* turned = nullptr) const;
        std::uint32_t corner_count() const;
    };
    std::unique_ptr<compute::Buffer> vertices, triangles;
    std::vector<Chunk> chunks; ///< at least one
    std::uint64_t version = 0; ///< counts changes of the places of parts in the tables
    /// Traces contours whose surfaces are known, at the places they had when the tables were made.
    std::shared_ptr<const ContourTracer> tracer{};

    /// The fixed segments of the largest chunk: what tables per segment must hold before
    /// silhouettes are found. Few candidates are silhouettes.
    std::uint32_t most_fixed_segments() const;
    /// The segments of all chunks. Without room for contours there are fewer than the line set has.
    std::uint32_t segment_count() const {
        return chunks.back().range.first + chunks.back().range.count;
    }
    /// The chunk with all candidates, which has the contours, if there are any.
    const Chunk& contour_chunk() const { return chunks.back(); }
};

/// Uploads segments in chunks. `lines`: the line set of the segments, whose contours are uploaded
/// too; of its vertices and triangles only the numbers matter. If it is null, or the device has no
/// room for contours, silhouettes run along edges.
std::vector<LineTables::Chunk> upload_segments(compute::Device& device,
                                               std::span<const Segment> segments,
                                               const LineSet* lines = nullptr);
/// Where edges meet. Vertex v has the ends from offsets[v] up to offsets[v + 1]. Edge i has end 2 i
/// at its p and end 2 i + 1 at its q. `offset_count`: larger than every vertex + 1.
struct EdgeEnds {
    std::vector<std::uint32_t> offsets, ends;
};
EdgeEnds ends_by_vertex(std::span<const Segment> edges, std::size_t offset_count);
/// The corners of the triangles that contours may run through.
std::vector<glm::uvec3> contour_corners(const Contours& contours);
/// The triangles across the edges of those triangles.
std::vector<compute::ContourFace> contour_faces(const Contours& contours);
/// The triangles beside the edges that contours may cross.
std::vector<compute::ContourEdge> contour_edges(const Contours& contours,
                                                std::span<const Segment> segments);
/// For every triangle the surface of contours that it belongs to, named after one of its edges, or
/// LA_NO_SURFACE. Faces of a surface are connected across edges.
std::vector<std::uint32_t> contour_patches(const LineSet& lines, std::span<const Segment> segments);
/// The segments of all chunks. Waits for the device.
std::vector<Segment> download_segments(compute::Device& device, const LineTables& lines);
/// A line set with contours and nothing else, and with as many vertices and triangles as the tables
/// have. Waits for the device.
LineSet download_contours(compute::Device& device, const LineTables& lines,
                          std::uint32_t triangle_count);
/// Throws DeviceError when memory runs out, or if there is more than GL and kernels can count.
LineTables upload_lines(compute::Device& device, const LineSet& lines);

} // namespace lineatlas
