#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "base/parallel.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// Has no branches, because a branch would be predicted wrongly at every other node.
inline bool boxes_meet(const Bounds& a, const Bounds& b) {
    const auto along = [&](int axis) {
        return static_cast<int>(a.min[axis] <= b.max[axis]) &
               static_cast<int>(b.min[axis] <= a.max[axis]);
    };
    return (along(0) & along(1) & along(2)) != 0;
}

/// A tree of boxes around triangles or lines. Finds the boxes that meet a given box, and the boxes
/// that meet each other.
class BoxTree {
  public:
    /// visit_meeting_pairs() does not compare boxes of one owner; without `owners` it compares all.
    /// Visits get `numbers[k]` for box k; without `numbers` they get k.
    explicit BoxTree(std::span<const Bounds> boxes, std::span<const std::uint32_t> owners = {},
                     std::span<const std::uint32_t> numbers = {});

    static constexpr std::uint32_t nobody = 0xFFFFFFFF; ///< as an owner

    /// Calls visit(i) for every box i that meets `box`, except boxes of the owner `but` and boxes
    /// in nodes n with !enters(n).
    template <class Visit, class Enters>
    void visit_meeting(const Bounds& box, Visit&& visit, std::uint32_t but, Enters&& enters) const {
        any_meeting(
            box,
            [&](std::uint32_t i) {
                visit(i);
                return false;
            },
            but, enters);
    }
    template <class Visit>
    void visit_meeting(const Bounds& box, Visit&& visit, std::uint32_t but = nobody) const {
        visit_meeting(box, visit, but, [](std::uint32_t) { return true; });
    }

    /// True if is(i) is for some box i that meets `box`; no further one is asked then.
    template <class Is>
    bool any_meeting(const Bounds& box, Is&& is) const {
        return any_meeting(box, is, nobody, [](std::uint32_t) { return true; });
    }

    /// Two nodes whose boxes are compared with each other; twice the same: those of one node.
    struct NodePair {
        std::uint32_t a, b;
    };

    /// Parts of the work of visit_meeting_pairs(), which may be done at the same time. One after
    /// the other they visit what a single thread would visit, in the same order.
    template <class May>
    std::vector<NodePair> parts_of_pairs(May&& may) const {
        std::vector<NodePair> parts, finer;
        if (!nodes_.empty()) parts.push_back({0, 0});
        for (bool changed = true; changed && parts.size() < most_parts; std::swap(parts, finer)) {
            finer.clear();
            changed = false;
            for (const NodePair part : parts) changed |= divide(part, may, finer);
        }
        return parts;
    }

    /// Calls visit(i, j), i < j, once for every two boxes of different owners that meet, except
    /// those in nodes m and n with !may(m, n). For two boxes of one node, m and n are that node.
    template <class Visit, class May>
    void visit_meeting_pairs(NodePair part, Visit&& visit, May&& may) const {
        part.a == part.b ? visit_within(part.a, visit, may)
                         : visit_between(part.a, part.b, visit, may);
    }
    template <class Visit>
    void visit_meeting_pairs(Visit&& visit) const {
        const auto may = [](std::uint32_t, std::uint32_t) { return true; };
        if (!nodes_.empty()) visit_meeting_pairs({0, 0}, visit, may);
    }

    /// Returns one value per node: of(i) of a box, both(a, b) of two values.
    template <class Value, class Of, class Both>
    std::vector<Value> values_of_nodes(Of&& of, Both&& both) const {
        std::vector<Value> values(nodes_.size());
        if (!nodes_.empty()) find_values(0, nodes_.size(), of, both, values);
        return values;
    }

  private:
    static constexpr std::uint32_t mixed = nobody;    ///< owners
    static constexpr std::size_t deepest = 64;        ///< twice the depth of halving 2^31 boxes
    static constexpr std::size_t least_shared = 4096; ///< nodes or boxes: fewer keep one thread
    static constexpr std::size_t most_parts = 512;    ///< from which on none is divided

    /// A leaf of `count` boxes, or with none an inner node: its left child is the next node.
    struct Node {
        Bounds box;
        std::uint32_t first = 0, count = 0, right = 0;
        std::uint32_t owner = mixed;
    };

    class Builder;

    /// Finds the values of a node and of all nodes below it, which follow it up to `end`.
    template <class Value, class Of, class Both>
    void find_values(std::size_t index, std::size_t end, Of& of, Both& both,
                     std::vector<Value>& values) const {
        const Node& node = nodes_[index];
        if (node.count > 0) {
            values[index] = of(order_[node.first]);
            for (std::uint32_t i = node.first + 1; i < node.first + node.count; ++i)
                values[index] = both(values[index], of(order_[i]));
            return;
        }
        const auto left = [&] { find_values(index + 1, node.right, of, both, values); };
        const auto right = [&] { find_values(node.right, end, of, both, values); };
        if (end - index >= least_shared) {
            do_both(left, right);
        } else {
            left();
            right();
        }
        values[index] = both(values[index + 1], values[node.right]);
    }

    template <class Is, class Enters>
    bool any_meeting(const Bounds& box, Is&& is, std::uint32_t but, Enters&& enters) const {
        const auto wanted = [&](std::uint32_t index) {
            const Node& node = nodes_[index];
            return boxes_meet(node.box, box) && (but == nobody || node.owner != but) &&
                   enters(index);
        };
        if (nodes_.empty() || !wanted(0)) return false;
        std::array<std::uint32_t, deepest> waiting;
        std::size_t count = 0;
        waiting[count++] = 0;
        while (count > 0) {
            const std::uint32_t index = waiting[--count];
            const Node& node = nodes_[index];
            if (node.count == 0) {
                if (wanted(node.right)) waiting[count++] = node.right;
                if (wanted(index + 1)) waiting[count++] = index + 1;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                const bool is_other = but == nobody || owners_[i] != but;
                if (is_other && boxes_meet(boxes_[i], box) && is(order_[i])) return true;
            }
        }
        return false;
    }

    bool are_strangers(const Node& a, const Node& b) const {
        return (a.owner == mixed || a.owner != b.owner) && boxes_meet(a.box, b.box);
    }

    /// Adds what a part consists of, if any is to be compared; whether it was divided.
    template <class May>
    bool divide(NodePair part, May& may, std::vector<NodePair>& finer) const {
        const Node &one = nodes_[part.a], &other = nodes_[part.b];
        const bool within = part.a == part.b;
        if (!may(part.a, part.b) || (within ? one.owner != mixed : !are_strangers(one, other)))
            return true;
        if (one.count > 0 && other.count > 0) {
            finer.push_back(part);
            return false;
        }
        const std::uint32_t a = part.a, b = part.b;
        if (within)
            finer.insert(finer.end(), {{a + 1, a + 1}, {one.right, one.right}, {a + 1, one.right}});
        else if (divides_first(one, other))
            finer.insert(finer.end(), {{a + 1, b}, {one.right, b}});
        else
            finer.insert(finer.end(), {{a, b + 1}, {a, other.right}});
        return true;
    }

    static bool divides_first(const Node& one, const Node& other) {
        return other.count > 0 || (one.count == 0 && is_larger(one.box, other.box));
    }

    template <class Visit, class May>
    void visit_within(std::uint32_t index, Visit& visit, May& may) const {
        const Node& node = nodes_[index];
        if (node.owner != mixed || !may(index, index)) return;
        if (node.count > 0) {
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                for (std::uint32_t j = i + 1; j < node.first + node.count; ++j)
                    compare(i, j, visit);
            }
            return;
        }
        visit_within(index + 1, visit, may);
        visit_within(node.right, visit, may);
        visit_between(index + 1, node.right, visit, may);
    }

    template <class Visit, class May>
    void visit_between(std::uint32_t a, std::uint32_t b, Visit& visit, May& may) const {
        const Node &one = nodes_[a], &other = nodes_[b];
        if (!are_strangers(one, other) || !may(a, b)) return;
        if (one.count > 0 && other.count > 0) {
            for (std::uint32_t i = one.first; i < one.first + one.count; ++i) {
                if (!boxes_meet(boxes_[i], other.box)) continue;
                for (std::uint32_t j = other.first; j < other.first + other.count; ++j)
                    compare(i, j, visit);
            }
        } else if (divides_first(one, other)) {
            visit_between(a + 1, b, visit, may);
            visit_between(one.right, b, visit, may);
        } else {
            visit_between(a, b + 1, visit, may);
            visit_between(a, other.right, visit, may);
        }
    }

    static bool is_larger(const Bounds& a, const Bounds& b) {
        const glm::vec3 p = a.max - a.min, q = b.max - b.min;
        return p.x + p.y + p.z > q.x + q.y + q.z;
    }

    template <class Visit>
    void compare(std::uint32_t i, std::uint32_t j, Visit& visit) const {
        if (!owners_.empty() && owners_[i] == owners_[j]) return;
        if (!boxes_meet(boxes_[i], boxes_[j])) return;
        const std::uint32_t a = order_[i], b = order_[j];
        a < b ? visit(a, b) : visit(b, a);
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;  ///< of the boxes in leaves
    std::vector<Bounds> boxes_;         ///< in that order
    std::vector<std::uint32_t> owners_; ///< likewise
};

} // namespace lineatlas
