#include "line_tables.hpp"

#include <algorithm>

#include "core/model_limits.hpp"

namespace lineatlas {

std::uint32_t LineTables::most_segments() const {
    std::uint32_t most = 0;
    for (const Chunk& chunk : chunks) most = std::max(most, chunk.range.count);
    return most;
}

std::unique_ptr<compute::Buffer> upload(compute::Device& device, std::span<const std::byte> data,
                                        const Purpose& purpose) {
    std::unique_ptr<compute::Buffer> buffer = compute::allocate(device, data.size(), purpose);
    device.upload(*buffer, data);
    return buffer;
}

std::vector<LineTables::Chunk> upload_segments(compute::Device& device,
                                               std::span<const Segment> segments) {
    // The widest table per segment decides. Once it must be cut, the strokes and intervals of a
    // chunk shall fit too: some per segment, where all are visible and hidden in parts.
    constexpr std::uint64_t runs_per_segment = 4;
    const bool is_whole = segments.size() <= device.largest_buffer() / sizeof(ClippedSegment);
    const std::uint64_t usual =
        is_whole ? segments.size() : device.largest_buffer() / (runs_per_segment * sizeof(Run));
    std::vector<LineTables::Chunk> chunks;
    for (const SegmentRange& range : cut_segments(segments, usual)) {
        const std::span<const Segment> part = segments.subspan(range.first, range.count);
        chunks.push_back({range, upload(device, std::as_bytes(part), purpose::segments)});
    }
    return chunks;
}

LineTables upload_lines(compute::Device& device, const LineSet& lines) {
    check_counts({lines.vertices.size(), lines.triangles.size(), lines.segments.size()});
    return {.vertices = upload(device, std::as_bytes(std::span{lines.vertices}), purpose::model),
            .triangles = upload(device, std::as_bytes(std::span{lines.triangles}), purpose::model),
            .chunks = upload_segments(device, lines.segments)};
}

} // namespace lineatlas
