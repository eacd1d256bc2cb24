// Visible parts of a piece (kernels/visible_parts.h) compared with sorted ranges, and the number of
// passes over the faces before a piece.

#include <algorithm>
#include <vector>

#include "test_meshes.hpp"

#include "segment_table.h"
#include "shared/constants.h"

#include <gtest/gtest.h>

namespace lineatlas::test {
namespace kernel {
#include "compute/cpp/opencl_c.hpp"

#include "visible_parts.h"
} // namespace kernel
namespace {

struct Range {
    float from, to;
};

struct Cut {
    std::vector<Range> visible;
    int windows = 0; ///< passes over all ranges
};

/// Finds the visible parts as visible.cl does, in a piece of this length.
Cut cut(const std::vector<Range>& hidden, float pixels) {
    Cut result;
    std::vector<float> out(2 * (hidden.size() + 1));
    kernel::Found found = kernel::nothing_found(kernel::float2{pixels, 0}, out.data());
    kernel::Parts parts;
    for (float from = 0; from < 1; from = parts.end) {
        ++result.windows;
        kernel::begin_parts(&parts, from);
        for (const Range range : hidden) {
            if (parts.count == 0) break;
            if (range.from >= parts.part[parts.count - 1].y || range.to <= parts.part[0].x)
                continue;
            kernel::hide(&parts, range.from, range.to, SHORTEST_PART / pixels);
        }
        for (int k = 0; k < parts.count; ++k) kernel::add_part(&found, parts.part[k]);
    }
    kernel::close_part(&found);
    for (kernel::uint k = 0; k < found.count; ++k)
        result.visible.push_back({out[2 * k], out[2 * k + 1]});
    return result;
}

/// The parts that no range covers.
std::vector<Range> rest_of(std::vector<Range> ranges) {
    std::ranges::sort(ranges, {}, &Range::from);
    std::vector<Range> rest;
    float from = 0;
    for (const Range range : ranges) {
        if (range.from > from) rest.push_back({from, range.from});
        from = std::max(from, range.to);
    }
    if (from < 1) rest.push_back({from, 1});
    return rest;
}

TEST(VisibleParts, AreWhatNoRangeCovers) {
    Random random(20);
    for (const int count : {10, 300, 3000}) {
        std::vector<Range> hidden;
        for (int i = 0; i < count; ++i) {
            const float from = random.between(0, 0.99F);
            hidden.push_back({from, from + random.between(0, 2.0F / static_cast<float>(count))});
        }
        const std::vector<Range> expected = rest_of(hidden);
        const auto look = [&] {
            const Cut found = cut(hidden, 1e9F);
            ASSERT_EQ(found.visible.size(), expected.size()) << count;
            for (std::size_t i = 0; i < expected.size(); ++i) {
                EXPECT_EQ(found.visible[i].from, expected[i].from);
                EXPECT_EQ(found.visible[i].to, expected[i].to);
            }
            // Each pass but the last takes as many ranges as fill a piece.
            EXPECT_LE(found.windows, 1 + count / (MOST_PARTS - 1)) << count;
        };
        look();
        std::ranges::sort(hidden, {}, &Range::from);
        look();
        std::ranges::reverse(hidden);
        look();
    }
}

} // namespace
} // namespace lineatlas::test
