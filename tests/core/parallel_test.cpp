#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/equal_positions.hpp"
#include "base/groups.hpp"
#include "base/vertex_pairs.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

TEST(Parallel, PiecesCoverAllOnce) {
    for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 1000U}) {
        std::vector<std::atomic<int>> visits(count);
        for_each_piece(count, 8, [&](std::size_t first, std::size_t end) {
            EXPECT_EQ(first % 8, 0U);
            EXPECT_EQ(end, std::min<std::size_t>(count, first + 8));
            for (; first < end; ++first) ++visits[first];
        });
        for (const std::atomic<int>& times : visits) EXPECT_EQ(times.load(), 1);
    }
}

TEST(Parallel, KeepsTheOrderOfPieces) {
    const auto numbers = [](std::size_t first, std::size_t end) {
        std::vector<std::size_t> own(end - first);
        std::iota(own.begin(), own.end(), first);
        return own;
    };
    const auto all = joined(made_of_pieces<std::vector<std::size_t>>(1001, 10, numbers));
    EXPECT_EQ(all, numbers(0, 1001));
}

TEST(Parallel, ThrowsWhatAPieceThrows) {
    const auto fail = [](std::size_t first, std::size_t) {
        if (first == 500) throw std::runtime_error("piece");
    };
    EXPECT_THROW(for_each_piece(1000, 10, fail), std::runtime_error);
}

TEST(Parallel, AsksBetweenPieces) {
    const auto caller = std::this_thread::get_id();
    const auto work = [](std::size_t, std::size_t) {
        std::this_thread::sleep_for(std::chrono::milliseconds{20});
    };
    int asked = 0;
    {
        const BetweenPieces asking{[&] {
            EXPECT_EQ(std::this_thread::get_id(), caller);
            if (++asked == 2) throw std::runtime_error("stopped");
        }};
        EXPECT_THROW(for_each_piece(1000, 1, work), std::runtime_error);
    }
    EXPECT_EQ(asked, 2);
    for_each_piece(8, 1, work);
    EXPECT_EQ(asked, 2) << "nobody asks any more";
}

TEST(Parallel, BothActionsRun) {
    int one = 0, other = 0;
    do_both([&] { one = 1; }, [&] { other = 2; });
    EXPECT_EQ(one, 1);
    EXPECT_EQ(other, 2);
}

TEST(Parallel, SortsAsOneThreadDoes) {
    test::Random random{5};
    for (const std::size_t count : {0U, 1U, 40000U, 100001U, 300000U}) {
        std::vector<int> list;
        for (std::size_t i = 0; i < count; ++i)
            list.push_back(static_cast<int>(random.point(50000).x));
        std::vector<int> expected = list;
        std::ranges::sort(expected);
        sort_in_pieces(list);
        EXPECT_EQ(list, expected) << count;
    }
}

TEST(Parallel, GroupsHaveWhatWasAdded) {
    constexpr std::uint32_t count = 100000, numbers = 777;
    Groups<std::uint32_t> groups{numbers, count, [](std::size_t i, const auto& add) {
                                     const auto item = static_cast<std::uint32_t>(i);
                                     if (i % 3 != 0) add(item % numbers, item);
                                 }};
    for (std::uint32_t number = 0; number < numbers; ++number) {
        std::vector<std::uint32_t> expected;
        for (std::uint32_t i = number; i < count; i += numbers)
            if (i % 3 != 0) expected.push_back(i);
        std::ranges::sort(groups[number]);
        EXPECT_TRUE(std::ranges::equal(groups[number], expected)) << number;
    }
}

TEST(Parallel, VertexPairsFindItemsByTheirTwoVertices) {
    constexpr std::uint32_t count = 100000, vertices = 300;
    const auto ends_of = [](std::size_t i) -> std::optional<glm::uvec2> {
        const auto item = static_cast<std::uint32_t>(i);
        if (i % 3 == 0) return {};
        return glm::uvec2{item % vertices, item * 7 % vertices};
    };
    const VertexPairs pairs{vertices, count, ends_of};
    for (const glm::uvec2 ends : {glm::uvec2{1, 7}, {7, 1}, {299, 293}, {50, 50}, {0, 1}}) {
        std::vector<std::uint32_t> expected, found;
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::optional<glm::uvec2> own = ends_of(i);
            if (own == ends || own == glm::uvec2{ends.y, ends.x}) expected.push_back(i);
        }
        for (const VertexPairs::Item& item : pairs.between(ends.x, ends.y))
            found.push_back(item.index);
        EXPECT_EQ(found, expected) << ends.x << ' ' << ends.y;
    }
    EXPECT_FALSE(pairs.between(1, 7).empty());
    EXPECT_TRUE(pairs.between(0, 1).empty());
}

TEST(Parallel, EqualPositionsHaveOneNumber) {
    std::vector<glm::vec3> positions;
    for (int i = 0; i < 50000; ++i)
        positions.emplace_back(i % 700, i % 3, i % 2 == 0 ? 0.0F : -0.0F);
    const std::vector<std::uint32_t> equal = equal_positions(positions);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        EXPECT_EQ(positions[equal[i]], positions[i]) << i;
        EXPECT_EQ(equal[i], equal[i % 2100]) << i; // where the same comes again
    }
}

} // namespace
} // namespace lineatlas
