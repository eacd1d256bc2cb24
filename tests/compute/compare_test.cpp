// The comparers must see what they are there to see: each gets a planted error.

#include "compare.hpp"
#include "compute/compare/layouts.hpp"
#include "compute/kernels.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::test {
namespace {

TEST(Compare, FirstDifferenceSeesOneChangedElement) {
    std::vector<std::uint32_t> a(1000, 7);
    std::vector<std::uint32_t> b = a;
    EXPECT_TRUE(equal(a, b));
    b[613] ^= 1U;
    EXPECT_FALSE(equal(a, b));
    EXPECT_EQ(first_difference<std::uint32_t>(a, b), 613U);
    b = a;
    b.push_back(7);
    EXPECT_FALSE(equal(a, b));
}

TEST(Compare, SameBitsSeesZeroesOfEitherSignAndLengths) {
    const std::vector<float> none, a{1, 0};
    EXPECT_TRUE(same_bits(none, none));
    EXPECT_TRUE(same_bits(a, a));
    EXPECT_FALSE(same_bits(a, {1, -0.0F}));
    EXPECT_FALSE(same_bits(a, {1}));
    EXPECT_FALSE(same_bits(none, a));
}

TEST(Compare, FloatsDifferBeyondTheirTolerance) {
    EXPECT_TRUE(close(100.0F, 100.0009F));
    EXPECT_FALSE(close(100.0F, 100.01F));
    EXPECT_TRUE(close(0.0F, 1e-7F));
    EXPECT_FALSE(close(0.0F, 1e-4F));
    EXPECT_FALSE(close(std::nanf(""), 1.0F));
    EXPECT_FALSE(close(INFINITY, 1.0F));
}

TEST(Compare, ClippedSegmentsDifferInEveryField) {
    const ClippedSegment a{{1, 2, 3, 4}, {5, 6, 7, 8}, 0.25F, 0.75F, 0x40003F80U, 0xC0003F80U};
    EXPECT_TRUE(close(a, a));
    for (int field = 0; field < 12; ++field) {
        ClippedSegment b = a;
        if (field < 4)
            b.p[field] += 0.01F;
        else if (field < 8)
            b.q[field - 4] += 0.01F;
        else if (field == 8)
            b.t0 += 0.01F;
        else if (field == 9)
            b.t1 += 0.01F;
        else if (field == 10)
            b.own_a ^= 0x8000U;
        else
            b.own_b += 0x00400000U;
        EXPECT_FALSE(close(a, b)) << "field " << field;
    }
}

TEST(Compare, RunsDifferInEveryField) {
    const lineatlas::Run a{{1, 2}, {3, 4}, {0, 1}, {0, 1}, 5, 6, 0,    9,
                           100,    9,      3,      42,     1, 7, 0.5F, 0.6F};
    EXPECT_TRUE(close(a, a));
    for (int field = 0; field < 20; ++field) {
        lineatlas::Run b = a;
        switch (field) {
        case 0:
        case 1:
            b.start[field] += 0.1F;
            break;
        case 2:
        case 3:
            b.end[field - 2] += 0.1F;
            break;
        case 4:
        case 5:
            b.start_corner[field - 4] += 0.1F;
            break;
        case 6:
        case 7:
            b.end_corner[field - 6] += 0.1F;
            break;
        case 8:
            b.start_arc += 0.1F;
            break;
        case 9:
            b.end_arc += 0.1F;
            break;
        case 10:
            b.start_sample += 0.5F;
            break;
        case 11:
            b.end_sample += 0.5F;
            break;
        case 12:
            ++b.address;
            break;
        case 13:
            ++b.samples;
            break;
        case 14:
            ++b.flags;
            break;
        case 15:
            ++b.segment;
            break;
        case 16:
            b.stroke_start += 0.1F;
            break;
        case 17:
            b.stroke_end += 0.1F;
            break;
        case 18:
            b.start_depth += 0.1F;
            break;
        default:
            b.end_depth += 0.1F;
            break;
        }
        EXPECT_FALSE(close(a, b)) << "field " << field;
    }
}

TEST(Compare, IntervalsDifferInAnyField) {
    const Interval a{.start = {1, 2},
                     .end = {3, 4},
                     .start_depth = 0.5F,
                     .end_depth = 0.6F,
                     .start_world = {1, 2, 3},
                     .end_world = {4, 5, 6},
                     .start_arc = 7,
                     .end_arc = 8,
                     .start_sample = 9,
                     .end_sample = 10,
                     .alpha = 0.5F,
                     .segment = 3,
                     .flags = 1};
    EXPECT_TRUE(close(a, a));
    constexpr std::size_t floats = 17; // then two integers
    for (std::size_t field = 0; field < floats + 2; ++field) {
        auto words = std::bit_cast<std::array<std::uint32_t, floats + 2>>(a);
        words[field] =
            field < floats
                ? std::bit_cast<std::uint32_t>(std::bit_cast<float>(words[field]) + 0.01F)
                : words[field] + 1;
        EXPECT_FALSE(close(a, std::bit_cast<Interval>(words))) << "field " << field;
    }
}

/// A device that is compared with another sees what every kernel writes.
TEST(Compare, EveryTableThatAKernelWritesHasALayout) {
    for (const compute::Kernel& kernel : compute::all_kernels()) {
        for (const compute::KernelTable& table : kernel.tables) {
            if (table.access == compute::Access::in) continue;
            EXPECT_EQ(compute::layout_of(table.type).size(), table.element_size)
                << kernel.name << ": " << table.name;
        }
    }
    EXPECT_THROW(compute::layout_of("Nothing"), Error);
}

TEST(Compare, BytesCountWhatLiesBeyondTheStep) {
    std::vector<std::uint8_t> a(1000, 100);
    std::vector<std::uint8_t> b = a;
    b[3] = 101; // within one step
    b[4] = 102;
    b[5] = 0;
    const ByteDifference difference = compare_bytes(a, b);
    EXPECT_EQ(difference.count, 1000U);
    EXPECT_EQ(difference.beyond, 2U);
    EXPECT_EQ(difference.largest, 100);
    EXPECT_DOUBLE_EQ(difference.share(), 0.002);
    b.pop_back();
    EXPECT_DOUBLE_EQ(compare_bytes(a, b).share(), 1.0);
}

} // namespace
} // namespace lineatlas::test
