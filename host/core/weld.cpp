#include "weld.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t empty_slot = std::numeric_limits<std::uint32_t>::max();

std::uint32_t mix(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::uint64_t h =
        a * 0x9E3779B97F4A7C15ULL ^ (std::uint64_t{b} << 32U | c) * 0xC2B2AE3D27D4EB4FULL;
    h ^= h >> 29U;
    h *= 0xBF58476D1CE4E5B9ULL;
    return static_cast<std::uint32_t>(h >> 32U);
}

/// An open-addressing table from a key of three words to the index of its first appearance.
template <class Key>
class FirstSeen {
  public:
    explicit FirstSeen(std::size_t expected)
        : slots_(std::bit_ceil(std::max<std::size_t>(16, expected * 2)), empty_slot) {}

    /// The index kept for `key`; `fresh` if it is new.
    std::uint32_t find_or_add(const Key& key, std::uint32_t fresh, std::uint32_t hash,
                              const std::vector<Key>& keys) {
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t slot = hash & mask;; slot = (slot + 1) & mask) {
            if (slots_[slot] == empty_slot) return slots_[slot] = fresh;
            if (keys[slots_[slot]] == key) return slots_[slot];
        }
    }

  private:
    std::vector<std::uint32_t> slots_;
};

class VertexWelder {
  public:
    explicit VertexWelder(const Mesh& mesh)
        : mesh_(mesh), welded_index_(mesh.positions.size(), empty_slot),
          table_(mesh.positions.size()) {}

    std::uint32_t operator()(std::uint32_t index) {
        if (index >= mesh_.positions.size()) {
            throw UsageError("mesh: index " + std::to_string(index) +
                             " is out of range, there are " +
                             std::to_string(mesh_.positions.size()) + " positions");
        }
        std::uint32_t& result = welded_index_[index];
        if (result != empty_slot) return result;
        const glm::vec3 position = mesh_.positions[index] + 0.0F; // -0 becomes 0
        if (!std::isfinite(position.x) || !std::isfinite(position.y) ||
            !std::isfinite(position.z)) {
            throw UsageError("mesh: position " + std::to_string(index) + " is not finite");
        }
        const auto fresh = static_cast<std::uint32_t>(vertices.size());
        const std::uint32_t hash =
            mix(std::bit_cast<std::uint32_t>(position.x), std::bit_cast<std::uint32_t>(position.y),
                std::bit_cast<std::uint32_t>(position.z));
        result = table_.find_or_add(position, fresh, hash, vertices);
        if (result == fresh) vertices.push_back(position);
        return result;
    }

    std::vector<glm::vec3> vertices;

  private:
    const Mesh& mesh_;
    std::vector<std::uint32_t> welded_index_;
    FirstSeen<glm::vec3> table_;
};

glm::uvec3 sorted(glm::uvec3 t) {
    if (t.x > t.y) std::swap(t.x, t.y);
    if (t.y > t.z) std::swap(t.y, t.z);
    if (t.x > t.y) std::swap(t.x, t.y);
    return t;
}

/// Drops vertices that nothing uses any more; the others keep their order.
void drop_unused_vertices(WeldedMesh& mesh) {
    std::vector<std::uint32_t> index(mesh.vertices.size(), empty_slot);
    const auto for_each_index = [&](auto&& visit) {
        for (glm::uvec3& triangle : mesh.triangles) {
            for (int corner = 0; corner < 3; ++corner) visit(triangle[corner]);
        }
        for (auto& polyline : mesh.polylines) {
            for (std::uint32_t& vertex : polyline) visit(vertex);
        }
    };
    for_each_index([&](std::uint32_t vertex) { index[vertex] = 0; });
    std::uint32_t used = 0;
    for (std::size_t v = 0; v < index.size(); ++v) {
        if (index[v] == empty_slot) continue;
        mesh.vertices[used] = mesh.vertices[v];
        index[v] = used++;
    }
    mesh.vertices.resize(used);
    for_each_index([&](std::uint32_t& vertex) { vertex = index[vertex]; });
}

} // namespace

WeldedMesh weld(const Mesh& mesh) {
    if (!mesh.triangle_group.empty() && mesh.triangle_group.size() != mesh.triangles.size()) {
        throw UsageError("mesh: there are " + std::to_string(mesh.triangles.size()) +
                         " triangles, but groups for " +
                         std::to_string(mesh.triangle_group.size()));
    }
    WeldedMesh result;
    VertexWelder weld_vertex{mesh};
    FirstSeen<glm::uvec3> seen{mesh.triangles.size()};
    std::vector<glm::uvec3> keys;
    keys.reserve(mesh.triangles.size());
    result.triangles.reserve(mesh.triangles.size());
    result.triangle_group.reserve(mesh.triangles.size());
    result.triangle_source.reserve(mesh.triangles.size());

    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 source = mesh.triangles[i];
        const glm::uvec3 triangle{weld_vertex(source.x), weld_vertex(source.y),
                                  weld_vertex(source.z)};
        const glm::uvec3 key = sorted(triangle);
        if (key.x == key.y || key.y == key.z) continue;
        const auto fresh = static_cast<std::uint32_t>(keys.size());
        if (seen.find_or_add(key, fresh, mix(key.x, key.y, key.z), keys) != fresh) continue;
        keys.push_back(key);
        result.triangles.push_back(triangle);
        result.triangle_source.push_back(static_cast<std::uint32_t>(i));
        result.triangle_group.push_back(mesh.triangle_group.empty() ? 0 : mesh.triangle_group[i]);
    }
    for (const auto& polyline : mesh.polylines) {
        std::vector<std::uint32_t> welded, sources;
        for (const std::uint32_t index : polyline) {
            const std::uint32_t vertex = weld_vertex(index);
            if (!welded.empty() && welded.back() == vertex) continue;
            welded.push_back(vertex);
            sources.push_back(index);
        }
        if (welded.size() < 2) continue;
        result.polylines.push_back(std::move(welded));
        result.polyline_sources.push_back(std::move(sources));
    }
    result.vertices = std::move(weld_vertex.vertices);
    drop_unused_vertices(result);
    return result;
}

} // namespace lineatlas
