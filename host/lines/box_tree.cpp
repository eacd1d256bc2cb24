#include "box_tree.hpp"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

#include "base/parallel.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t most_in_leaf = 6;

/// The number of nodes of a tree of `boxes` boxes, which are halved down to leaves, and the number
/// of nodes with one more box.
std::pair<std::uint32_t, std::uint32_t> nodes_of(std::uint32_t boxes) {
    if (boxes < most_in_leaf) return {1, 1};
    if (boxes == most_in_leaf) return {1, 3};
    const auto [half, more] = nodes_of(boxes / 2);
    if (boxes % 2 == 0) return {1 + 2 * half, 1 + half + more};
    return {1 + half + more, 1 + 2 * more};
}

int longest_axis(glm::vec3 extent) {
    if (extent.x >= extent.y && extent.x >= extent.z) return 0;
    return extent.y >= extent.z ? 1 : 2;
}

} // namespace

/// Halves boxes at the median of their middles.
class BoxTree::Builder {
  public:
    Builder(std::span<const Bounds> boxes, std::span<const std::uint32_t> owners, BoxTree& tree)
        : boxes_(boxes), owners_(owners), tree_(tree), items_(boxes.size()) {
        for_each_index(boxes.size(), [&](std::size_t i) {
            items_[i] = {boxes[i].min + boxes[i].max, static_cast<std::uint32_t>(i)};
        });
        const auto count = static_cast<std::uint32_t>(boxes.size());
        tree_.nodes_.resize(nodes_of(count).first);
        build(0, 0, count);
    }

    /// The number of the box at a place among those in leaves.
    std::uint32_t operator[](std::size_t place) const { return items_[place].box; }

  private:
    struct Item {
        glm::vec3 middle; ///< twice
        std::uint32_t box;
    };

    /// Fills the node and all below it with the items from `first` up to `end`.
    void build(std::uint32_t index, std::uint32_t first, std::uint32_t end) {
        Node& node = tree_.nodes_[index];
        node.first = first;
        const std::uint32_t count = end - first;
        if (count <= most_in_leaf) return fill_leaf(node, count);
        const std::uint32_t middle = first + count / 2;
        node.right = index + 1 + nodes_of(count / 2).first;
        part(first, middle, end);
        const auto left_half = [&] { build(index + 1, first, middle); };
        const auto right_half = [&] { build(node.right, middle, end); };
        if (count >= least_shared) {
            do_both(left_half, right_half);
        } else {
            left_half();
            right_half();
        }
        const Node &left = tree_.nodes_[index + 1], &right = tree_.nodes_[node.right];
        node.box = {glm::min(left.box.min, right.box.min), glm::max(left.box.max, right.box.max)};
        node.owner = left.owner == right.owner ? left.owner : mixed;
    }

    void fill_leaf(Node& node, std::uint32_t count) {
        node.count = count;
        const std::span own = std::span{items_}.subspan(node.first, count);
        // nth_element leaves them in an order that differs between standard libraries.
        std::ranges::sort(own, {}, &Item::box);
        node.owner = owner_of(own.front());
        for (const Item& item : own) {
            node.box.min = glm::min(node.box.min, boxes_[item.box].min);
            node.box.max = glm::max(node.box.max, boxes_[item.box].max);
            if (owner_of(item) != node.owner) node.owner = mixed;
        }
    }

    std::uint32_t owner_of(const Item& item) const {
        return owners_.empty() ? mixed : owners_[item.box];
    }

    /// Puts the half with the lesser middles first, along the axis on which middles differ most.
    void part(std::uint32_t first, std::uint32_t middle, std::uint32_t end) {
        const std::span own = std::span{items_}.subspan(first, end - first);
        Bounds middles;
        for (const Item& item : own) {
            middles.min = glm::min(middles.min, item.middle);
            middles.max = glm::max(middles.max, item.middle);
        }
        const int axis = longest_axis(middles.max - middles.min);
        std::nth_element(own.begin(), own.begin() + (middle - first), own.end(),
                         [axis](const Item& a, const Item& b) {
                             return a.middle[axis] != b.middle[axis]
                                        ? a.middle[axis] < b.middle[axis]
                                        : a.box < b.box;
                         });
    }

    std::span<const Bounds> boxes_;
    std::span<const std::uint32_t> owners_;
    BoxTree& tree_;
    std::vector<Item> items_;
};

BoxTree::BoxTree(std::span<const Bounds> boxes, std::span<const std::uint32_t> owners,
                 std::span<const std::uint32_t> numbers) {
    if (boxes.empty()) return;
    const Builder built{boxes, owners, *this};
    order_.resize(boxes.size());
    boxes_.resize(boxes.size());
    owners_.resize(owners.size());
    for_each_index(boxes.size(), [&](std::size_t place) {
        const std::uint32_t box = built[place];
        order_[place] = numbers.empty() ? box : numbers[box];
        boxes_[place] = boxes[box];
        if (!owners.empty()) owners_[place] = owners[box];
    });
}

} // namespace lineatlas
