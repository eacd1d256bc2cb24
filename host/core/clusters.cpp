#include "clusters.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include <glm/common.hpp>

namespace lineatlas {
namespace {

struct Item {
    glm::vec3 center; ///< of the triangle, times 3
    std::uint32_t triangle;
};

/// Halves `items` at the median of the longest axis until a piece has at most `cluster_size`, and
/// calls `add` with each piece, neighbours one after the other.
template <class Add>
void split(std::span<Item> items, std::uint32_t cluster_size, const Add& add) {
    if (items.size() <= cluster_size) {
        // nth_element leaves them in an order that differs between standard libraries.
        std::ranges::sort(items, {}, &Item::triangle);
        return add(items);
    }
    glm::vec3 low = items.front().center;
    glm::vec3 high = low;
    for (const Item& item : items) {
        low = glm::min(low, item.center);
        high = glm::max(high, item.center);
    }
    const glm::vec3 extent = high - low;
    int axis = extent.x >= extent.y ? 0 : 1;
    if (extent.z > extent[axis]) axis = 2;
    // The left half gets a multiple of the cluster size, so that all clusters but the last are
    // full.
    const std::size_t clusters = (items.size() + cluster_size - 1) / cluster_size;
    const std::size_t left = clusters / 2 * cluster_size;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(left), items.end(),
                     [axis](const Item& a, const Item& b) {
                         return a.center[axis] != b.center[axis] ? a.center[axis] < b.center[axis]
                                                                 : a.triangle < b.triangle;
                     });
    split(items.first(left), cluster_size, add);
    split(items.subspan(left), cluster_size, add);
}

} // namespace

TriangleClusters build_clusters(std::span<const glm::vec3> vertices,
                                std::span<const glm::uvec3> triangles, std::uint32_t cluster_size,
                                std::span<const LineObject> objects) {
    std::vector<Item> items(triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const glm::uvec3 t = triangles[i];
        items[i] = {vertices[t.x] + vertices[t.y] + vertices[t.z], i};
    }
    // A vertex belongs to one object, whose vertices stand together.
    std::vector<std::uint32_t> order(objects.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return objects[i].first_vertex; });
    std::uint32_t object = 0;
    const auto is_before = [&](const Item& item) {
        return triangles[item.triangle].x <
               objects[object].first_vertex + objects[object].vertex_count;
    };
    if (!objects.empty()) {
        std::ranges::stable_sort(items, {},
                                 [&](const Item& item) { return triangles[item.triangle].x; });
    }
    TriangleClusters result;
    result.triangles.reserve(triangles.size());
    result.order.reserve(triangles.size());
    const auto add = [&](std::span<const Item> piece) {
        if (piece.empty()) return;
        glm::vec3 low{std::numeric_limits<float>::infinity()};
        glm::vec3 high{-std::numeric_limits<float>::infinity()};
        const auto first = static_cast<std::uint32_t>(result.triangles.size());
        for (const Item& item : piece) {
            const glm::uvec3 t = triangles[item.triangle];
            result.triangles.push_back(t);
            result.order.push_back(item.triangle);
            for (int corner = 0; corner < 3; ++corner) {
                low = glm::min(low, vertices[t[corner]]);
                high = glm::max(high, vertices[t[corner]]);
            }
        }
        result.objects.push_back(object);
        result.clusters.push_back({.low = {low.x, low.y, low.z},
                                   .high = {high.x, high.y, high.z},
                                   .first = first,
                                   .count = static_cast<std::uint32_t>(piece.size())});
    };
    std::span<Item> rest = items;
    for (const std::uint32_t next : order) {
        object = next;
        const auto end = std::ranges::partition_point(rest, is_before);
        const auto count = static_cast<std::size_t>(end - rest.begin());
        split(rest.first(count), cluster_size, add);
        rest = rest.subspan(count);
    }
    object = 0;
    split(rest, cluster_size, add); // all triangles if there are no objects
    return result;
}

} // namespace lineatlas
