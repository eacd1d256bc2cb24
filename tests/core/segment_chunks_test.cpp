// Chunks of a segment table have whole paths, leave no path out and are no larger than fits.

#include <gtest/gtest.h>

#include "core/segment_chunks.hpp"

namespace lineatlas {
namespace {

std::vector<Segment> segments_of(std::initializer_list<std::uint32_t> paths) {
    std::vector<Segment> segments;
    std::uint32_t path = 0;
    for (const std::uint32_t length : paths) {
        for (std::uint32_t i = 0; i < length; ++i) {
            Segment segment{};
            segment.from_start = i;
            segment.to_end = length - 1 - i;
            segment.path = path;
            segments.push_back(segment);
        }
        ++path;
    }
    return segments;
}

std::vector<std::uint32_t> counts(std::initializer_list<std::uint32_t> paths, std::uint64_t usual) {
    std::vector<std::uint32_t> counts;
    std::uint32_t first = 0;
    for (const SegmentRange& range : cut_segments(segments_of(paths), usual)) {
        EXPECT_EQ(range.first, first);
        first += range.count;
        counts.push_back(range.count);
    }
    return counts;
}

TEST(SegmentChunks, AreOfWholePaths) {
    using Counts = std::vector<std::uint32_t>;
    EXPECT_EQ(counts({}, 4), Counts{0});
    EXPECT_EQ(counts({1, 1, 1}, 4), Counts{3});
    EXPECT_EQ(counts({2, 2, 2}, 4), (Counts{4, 2}));
    EXPECT_EQ(counts({3, 2, 3}, 4), (Counts{3, 2, 3}));
    EXPECT_EQ(counts({1, 9, 1, 1}, 4), (Counts{1, 9, 2})); // a path that is too long stays whole
    EXPECT_EQ(counts({2, 1}, 0), (Counts{2, 1}));
}

} // namespace
} // namespace lineatlas
