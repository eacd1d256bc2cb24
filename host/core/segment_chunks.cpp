#include "segment_chunks.hpp"

namespace lineatlas {

std::vector<SegmentRange> cut_segments(std::span<const Segment> segments, std::uint64_t usual) {
    std::vector<SegmentRange> chunks{{0, 0}};
    for (std::uint32_t i = 0; i < segments.size();) {
        const std::uint32_t path = segments[i].to_end + 1; // i is its first segment
        if (chunks.back().count > 0 && std::uint64_t{chunks.back().count} + path > usual)
            chunks.push_back({i, 0});
        chunks.back().count += path;
        i += path;
    }
    return chunks;
}

} // namespace lineatlas
