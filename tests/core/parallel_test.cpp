#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/groups.hpp"
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

TEST(Parallel, DoesBoth) {
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

} // namespace
} // namespace lineatlas
