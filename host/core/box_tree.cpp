#include "box_tree.hpp"

#include <algorithm>
#include <numeric>

#include <glm/common.hpp>

namespace lineatlas {
namespace {

constexpr std::uint32_t most_in_leaf = 6;

} // namespace

BoxTree::BoxTree(std::span<const Bounds> boxes, std::span<const std::uint32_t> owners)
    : order_(boxes.size()) {
    if (boxes.empty()) return;
    std::iota(order_.begin(), order_.end(), 0U);
    boxes_.assign(boxes.begin(), boxes.end());
    nodes_.reserve(2 * boxes.size() / most_in_leaf * 2 + 1);
    build(0, static_cast<std::uint32_t>(boxes.size()), owners);
    for (std::size_t i = 0; i < order_.size(); ++i) boxes_[i] = boxes[order_[i]];
    for (std::size_t i = 0; i < owners.size(); ++i) owners_.push_back(owners[order_[i]]);
}

std::uint32_t BoxTree::build(std::uint32_t first, std::uint32_t end,
                             std::span<const std::uint32_t> owners) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Node node{.box = {}, .first = first};
    Bounds middles; // of boxes, twice
    if (!owners.empty()) node.owner = owners[order_[first]];
    for (std::uint32_t i = first; i < end; ++i) {
        const Bounds& box = boxes_[order_[i]];
        node.box.min = glm::min(node.box.min, box.min);
        node.box.max = glm::max(node.box.max, box.max);
        middles.min = glm::min(middles.min, box.min + box.max);
        middles.max = glm::max(middles.max, box.min + box.max);
        if (!owners.empty() && owners[order_[i]] != node.owner) node.owner = mixed;
    }
    if (end - first <= most_in_leaf) {
        node.count = end - first;
    } else {
        const glm::vec3 extent = middles.max - middles.min;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                         : extent.y >= extent.z                       ? 1
                                                                      : 2;
        const std::uint32_t middle = first + (end - first) / 2;
        std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + end,
                         [&](std::uint32_t a, std::uint32_t b) {
                             const float x = boxes_[a].min[axis] + boxes_[a].max[axis];
                             const float y = boxes_[b].min[axis] + boxes_[b].max[axis];
                             return x != y ? x < y : a < b;
                         });
        build(first, middle, owners);
        node.right = build(middle, end, owners);
    }
    nodes_[index] = node;
    return index;
}

} // namespace lineatlas
