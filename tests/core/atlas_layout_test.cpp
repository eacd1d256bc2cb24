#include "core/atlas_layout.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "lineatlas/error.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max();

TEST(AtlasLayout, AddressesFollowEquation2) {
    const AtlasLayout layout{.width = 5, .pitch = 8};
    EXPECT_EQ(layout.address(0), 0U);
    EXPECT_EQ(layout.address(4), 4U);
    EXPECT_EQ(layout.address(5), 8U);
    EXPECT_EQ(layout.address(13), 19U);
    const AtlasLayout without_gutter{.width = 8, .pitch = 8};
    for (std::uint32_t s = 0; s < 100; ++s) EXPECT_EQ(without_gutter.address(s), s);
}

TEST(AtlasLayout, RowsHoldTheSamples) {
    const AtlasLayout layout{.width = 5, .pitch = 8};
    EXPECT_EQ(layout.rows(0), 0U);
    EXPECT_EQ(layout.rows(1), 1U);
    EXPECT_EQ(layout.rows(5), 1U);
    EXPECT_EQ(layout.rows(6), 2U);
    EXPECT_EQ(layout.texels(6), 16U);
}

TEST(AtlasLayout, RowsHoldAsManySamplesAsCanBeCounted) {
    const AtlasLayout layout{.width = 8192, .pitch = 16384};
    EXPECT_EQ(layout.rows(most), (most - 1) / 8192 + 1);
    EXPECT_EQ(layout.texels(most), std::uint64_t{(most - 1) / 8192 + 1} * 16384);
}

TEST(MakeAtlasLayout, WrapWastesNothing) {
    for (const std::uint32_t longest : {1U, 700U, 4000U, 8000U}) {
        const AtlasLayout layout = make_atlas_layout(AtlasLayoutChoice::wrap, longest, 16384);
        EXPECT_EQ(layout.width, layout.pitch);
        EXPECT_GT(layout.pitch, longest);
        EXPECT_EQ(layout.texels(10 * layout.pitch), 10U * layout.pitch);
    }
}

TEST(MakeAtlasLayout, GutterLeavesRoomForTheLongest) {
    for (const std::uint32_t longest : {1U, 700U, 4000U, 8000U, 16383U}) {
        const AtlasLayout layout = make_atlas_layout(AtlasLayoutChoice::gutter, longest, 16384);
        EXPECT_GE(layout.width, 1U);
        EXPECT_GE(layout.pitch, layout.width + longest);
    }
}

TEST(MakeAtlasLayout, NoRowIsLongerThanTheDeviceAllows) {
    test::Random random{41};
    for (int round = 0; round < 2000; ++round) {
        const std::uint32_t largest = 1U << (6 + random.below(12));
        const std::uint32_t longest = random.below(2 * largest);
        for (const auto kind : {AtlasLayoutChoice::wrap, AtlasLayoutChoice::gutter}) {
            if (longest >= largest) {
                EXPECT_THROW(make_atlas_layout(kind, longest, largest), UsageError);
                continue;
            }
            const AtlasLayout layout = make_atlas_layout(kind, longest, largest);
            EXPECT_LE(layout.pitch, largest);
            EXPECT_LE(layout.width, layout.pitch);
        }
    }
}

TEST(MakeAtlasLayout, RefusesSegmentsOfAnyLengthThatDoNotFit) {
    for (const std::uint32_t longest :
         {16384U, 1U << 30U, (1U << 30U) + 1, 1U << 31U, (1U << 31U) + 1, most - 1, most}) {
        EXPECT_THROW(make_atlas_layout(AtlasLayoutChoice::wrap, longest, 16384), UsageError);
        EXPECT_THROW(make_atlas_layout(AtlasLayoutChoice::gutter, longest, 16384), UsageError);
    }
}

/// Segments one after the other, as the pipeline places them: each starts at the address of its
/// first sample and, with a gutter, goes on from texel to texel.
TEST(MakeAtlasLayout, SegmentsNeverShareATexelAndNeverLeaveTheirRow) {
    test::Random random{42};
    for (int round = 0; round < 40; ++round) {
        const std::uint32_t longest = 1 + random.below(900);
        for (const auto kind : {AtlasLayoutChoice::wrap, AtlasLayoutChoice::gutter}) {
            const AtlasLayout layout =
                make_atlas_layout(kind, longest, longest + 1 + random.below(1000));
            std::vector<std::uint32_t> lengths;
            std::uint32_t total = 0;
            for (int i = 0; i < 60; ++i) {
                lengths.push_back(random.coin() ? longest : 1 + random.below(longest));
                total += lengths.back();
            }
            std::vector<bool> taken(layout.texels(total), false);
            std::uint32_t s = 0;
            for (const std::uint32_t length : lengths) {
                const std::uint32_t first = layout.address(s);
                if (kind == AtlasLayoutChoice::gutter) {
                    ASSERT_EQ(first / layout.pitch, (first + length - 1) / layout.pitch)
                        << "a segment leaves its row";
                }
                for (std::uint32_t j = 0; j < length; ++j) {
                    const std::uint32_t texel =
                        kind == AtlasLayoutChoice::gutter ? first + j : layout.address(s + j);
                    ASSERT_LT(texel, taken.size());
                    ASSERT_FALSE(taken[texel]) << "two samples in one texel";
                    taken[texel] = true;
                }
                s += length;
            }
        }
    }
}

} // namespace
} // namespace lineatlas
