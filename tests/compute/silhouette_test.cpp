// silhouette: numbers candidates with one face towards the eye and one away from it.

#include <type_traits>

#include "compute/stages/silhouette_chains.hpp"
#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

LINEATLAS_STAGE_TEST(SilhouetteStage);

void upload(compute::Table& table, const std::vector<std::uint32_t>& values) {
    table.upload(std::span{values});
}

TEST_P(SilhouetteStage, NumbersWhatHasOneFaceInFront) {
    constexpr std::uint32_t flipped = LA_FACE_FLIPPED;
    const auto segment = [](std::uint32_t a, std::uint32_t b) {
        return Segment{.p = 0,
                       .q = 1,
                       .face_a = a,
                       .face_b = b,
                       .from_start = 0,
                       .to_end = 0,
                       .path = 0,
                       .tag = LA_KIND_SILHOUETTE};
    };
    // The first two are no candidates.
    const auto segments = put(std::vector<Segment>{
        segment(0, 1), segment(0, 1), segment(0, 2), segment(0, 1), segment(2, 3), segment(1, 0),
        segment(0, 2 | flipped), segment(0, 1 | flipped), segment(3, 1)});
    const auto front = put(std::vector<std::uint8_t>{1, 0, 1, 0});
    compute::ChainTables tables{&device()};
    tables.numbers.fit(8 * sizeof(std::uint32_t));
    const auto ends = device().allocate(16);
    stages().silhouette({*segments, *segments, *segments, 4, 9, {2, 7, ends.get(), ends.get()}},
                        *front, tables);
    EXPECT_TRUE(equal(get<std::uint32_t>(*tables.numbers, 8), {0, 0, 1, 2, 3, 4, 4, 4}));
}

TEST_P(SilhouetteStage, ListsThem) {
    // Seven candidates: three edges, two that contours stand for, two contours.
    compute::SilhouetteCandidates candidates{.first = 9, .count = 7};
    candidates.contours = compute::ContourTables{.face_count = 2, .replaced = 2};
    compute::ChainTables tables{&device()};
    upload(tables.numbers, {0, 1, 1, 2, 2, 3});
    upload(tables.chosen, std::vector<std::uint32_t>(4, 99));
    upload(tables.positions, std::vector<std::uint32_t>(7, 99));
    tables.total.fit(sizeof(std::uint32_t));
    stages().silhouette_list(candidates, 3, tables);
    EXPECT_TRUE(equal(get<std::uint32_t>(*tables.chosen, 4), {0, 2, 6, 99}));
    EXPECT_TRUE(equal(get<std::uint32_t>(*tables.positions, 7), {0, 0, 0, 99, 99, 0, 0}));
    EXPECT_TRUE(equal(get<std::uint32_t>(*tables.total, 1), {3}));

    upload(tables.chosen, std::vector<std::uint32_t>(6, 99));
    stages().silhouette_list(candidates, 5, tables);
    constexpr std::uint32_t none = LA_NO_SILHOUETTE;
    EXPECT_TRUE(equal(get<std::uint32_t>(*tables.chosen, 6), {0, 2, 6, none, none, 99}));
    EXPECT_TRUE(equal(get<std::uint32_t>(*tables.total, 1), {3}));

    upload(tables.chosen, std::vector<std::uint32_t>(3, 99));
    stages().silhouette_list(candidates, 2, tables);
    EXPECT_TRUE(equal(get<std::uint32_t>(*tables.chosen, 3), {0, 2, 99})) << "no room for one";
    EXPECT_TRUE(equal(get<std::uint32_t>(*tables.total, 1), {3}));
}

TEST_P(SilhouetteStage, AreNotLaunchedOnATableWithoutRoom) {
    const compute::ChainTables tables{&device()};
    EXPECT_THROW(stages().silhouette_list({.first = 0, .count = 1}, 1, tables), std::logic_error);
    const auto one = device().allocate(4);
    const struct {
        compute::Buffer &segments, &front;
        compute::Buffer* numbers;
    } written_is_absent{*one, *one, nullptr};
    EXPECT_THROW(stages().launch<compute::kernels::silhouette>(1, {}, written_is_absent),
                 std::logic_error);
}

// A launch without a table that no group has does not compile.
struct WithoutNumbers {
    compute::Buffer &segments, &front;
};
static_assert(std::is_same_v<decltype(compute::kernels::silhouette::Own<WithoutNumbers>::numbers),
                             compute::kernels::OwnTable<false>>);
static_assert(std::is_same_v<decltype(compute::kernels::silhouette::Own<WithoutNumbers>::front),
                             compute::kernels::OwnTable<true>>);
static_assert(!std::is_default_constructible_v<compute::kernels::OwnTable<false>>);
static_assert(std::is_default_constructible_v<compute::kernels::OwnTable<true>>);

TEST_P(SilhouetteStage, TakesTablesOfTheLaunchBeforeThoseOfGroups) {
    compute::ChainTables tables{&device()}; // whose numbers have no room
    upload(tables.chosen, std::vector<std::uint32_t>(1, 99));
    upload(tables.positions, std::vector<std::uint32_t>(2, 99));
    upload(tables.total, std::vector<std::uint32_t>(1, 99));
    const auto numbers = put(std::vector<std::uint32_t>{0, 0, 1});
    stages().launch<compute::kernels::silhouette_list>(
        2, {.count = 2, .first = 0, .replaced = 2, .contours = 2, .capacity = 1},
        {.numbers = numbers.get()}, tables);
    EXPECT_TRUE(equal(get<std::uint32_t>(*tables.chosen, 1), {1}));
}

} // namespace
} // namespace lineatlas::test
