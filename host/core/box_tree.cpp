#include "box_tree.hpp"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

namespace lineatlas {
namespace {

constexpr std::uint32_t most_in_leaf = 6;

} // namespace

BoxTree::BoxTree(std::span<const Bounds> boxes, std::span<const std::uint32_t> owners,
                 std::span<const std::uint32_t> numbers) {
    if (boxes.empty()) return;
    std::vector<Item> items;
    items.reserve(boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        items.push_back(
            {boxes[i], numbers.empty() ? i : numbers[i], owners.empty() ? mixed : owners[i]});
    nodes_.reserve(2 * boxes.size() / most_in_leaf * 2 + 1);
    build(items, 0);
    for (const Item& item : items) {
        order_.push_back(item.index);
        boxes_.push_back(item.box);
        if (!owners.empty()) owners_.push_back(item.owner);
    }
}

std::uint32_t BoxTree::build(std::span<Item> items, std::uint32_t first) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Node node{.box = {}, .first = first, .owner = items.front().owner};
    Bounds middles; // of boxes, twice
    for (const Item& item : items) {
        node.box.min = glm::min(node.box.min, item.box.min);
        node.box.max = glm::max(node.box.max, item.box.max);
        middles.min = glm::min(middles.min, item.box.min + item.box.max);
        middles.max = glm::max(middles.max, item.box.min + item.box.max);
        if (item.owner != node.owner) node.owner = mixed;
    }
    const auto count = static_cast<std::uint32_t>(items.size());
    if (count <= most_in_leaf) {
        node.count = count;
        // nth_element leaves them in an order that differs between standard libraries.
        std::ranges::sort(items, {}, &Item::index);
    } else {
        const glm::vec3 extent = middles.max - middles.min;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                         : extent.y >= extent.z                       ? 1
                                                                      : 2;
        const std::uint32_t middle = count / 2;
        std::ranges::nth_element(items, items.begin() + middle, {}, [&](const Item& item) {
            return std::pair{item.box.min[axis] + item.box.max[axis], item.index};
        });
        build(items.first(middle), first);
        node.right = build(items.subspan(middle), first + middle);
    }
    nodes_[index] = node;
    return index;
}

} // namespace lineatlas
