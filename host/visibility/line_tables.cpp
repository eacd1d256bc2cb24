#include "line_tables.hpp"

#include <algorithm>
#include <numeric>

#include "core/model_limits.hpp"

namespace lineatlas {
namespace {

bool is_candidate(const Segment& segment) {
    return (segment.tag & LA_TAG_KIND_MASK) == LA_KIND_SILHOUETTE && segment.from_start == 0 &&
           segment.to_end == 0 && segment.face_a != LA_NO_FACE && segment.face_b != LA_NO_FACE;
}

/// Finds the candidates of a chunk, and uploads where they meet.
void add_candidates(compute::Device& device, std::span<const Segment> segments,
                    LineTables::Chunk& chunk) {
    std::size_t first = segments.size();
    while (first > 0 && is_candidate(segments[first - 1])) --first;
    const std::span<const Segment> candidates = segments.subspan(first);
    if (candidates.empty()) return;
    chunk.candidate_count = static_cast<std::uint32_t>(candidates.size());
    std::uint32_t last = 0;
    for (const Segment& one : candidates) last = std::max({last, one.p, one.q});
    std::vector<std::uint32_t> offsets(std::size_t{last} + 2, 0);
    for (const Segment& one : candidates) {
        ++offsets[one.p + 1];
        ++offsets[one.q + 1];
    }
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    std::vector<std::uint32_t> ends(2 * candidates.size());
    std::vector<std::uint32_t> next(offsets.begin(), offsets.end() - 1);
    for (std::uint32_t i = 0; i < candidates.size(); ++i) {
        ends[next[candidates[i].p]++] = 2 * i;
        ends[next[candidates[i].q]++] = 2 * i + 1;
    }
    chunk.end_offsets = upload(device, std::as_bytes(std::span{offsets}), purpose::segments);
    chunk.ends = upload(device, std::as_bytes(std::span{ends}), purpose::segments);
}

} // namespace

std::uint64_t LineTables::Chunk::bytes() const {
    std::uint64_t sum = segments->size();
    for (const auto* buffer : {&end_offsets, &ends}) {
        if (*buffer) sum += (*buffer)->size();
    }
    return sum;
}

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
        add_candidates(device, part, chunks.back());
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
