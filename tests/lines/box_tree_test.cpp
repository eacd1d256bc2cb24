#include "lines/box_tree.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <glm/common.hpp>

#include "test_meshes.hpp"

namespace lineatlas {
namespace {

std::vector<Bounds> random_boxes(test::Random& random, std::size_t count) {
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 at = random.point(1), size = glm::abs(random.point(0.1F));
        boxes.push_back({at, at + size});
    }
    return boxes;
}

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Pairs pairs_of(const BoxTree& tree) {
    Pairs pairs;
    tree.visit_meeting_pairs([&](std::uint32_t a, std::uint32_t b) {
        EXPECT_LT(a, b);
        EXPECT_TRUE(pairs.emplace(a, b).second) << "a pair is told twice";
    });
    return pairs;
}

TEST(BoxTree, FindsWhatMeetsABox) {
    test::Random random{91};
    for (const std::size_t count : {0U, 1U, 6U, 7U, 500U}) {
        const std::vector<Bounds> boxes = random_boxes(random, count);
        const BoxTree tree{boxes};
        for (const Bounds& box : random_boxes(random, 40)) {
            std::vector<std::uint32_t> expected, found;
            for (std::uint32_t i = 0; i < count; ++i)
                if (boxes_meet(boxes[i], box)) expected.push_back(i);
            tree.visit_meeting(box, [&](std::uint32_t i) { found.push_back(i); });
            std::ranges::sort(found);
            EXPECT_EQ(found, expected);
        }
    }
}

TEST(BoxTree, FindsPairsOfDifferentOwners) {
    test::Random random{92};
    for (const std::uint32_t owners : {1U, 2U, 5U, 400U}) {
        const std::vector<Bounds> boxes = random_boxes(random, 400);
        std::vector<std::uint32_t> owner;
        for (std::size_t i = 0; i < boxes.size(); ++i) owner.push_back(random.below(owners));
        Pairs all, strangers;
        for (std::uint32_t a = 0; a < boxes.size(); ++a) {
            for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
                if (!boxes_meet(boxes[a], boxes[b])) continue;
                all.emplace(a, b);
                if (owner[a] != owner[b]) strangers.emplace(a, b);
            }
        }
        EXPECT_TRUE(pairs_of(BoxTree{boxes}) == all);
        EXPECT_TRUE(pairs_of(BoxTree(boxes, owner)) == strangers);
    }
}

} // namespace
} // namespace lineatlas
