#include "added_vertices.hpp"

#include <algorithm>
#include <bit>
#include <limits>

namespace lineatlas {

std::size_t AddedVertices::PlaceHash::operator()(const Place& place) const {
    std::uint64_t hash = place.object;
    for (int axis = 0; axis < 3; ++axis) {
        hash = (hash ^ std::bit_cast<std::uint32_t>(place.position[axis])) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 29U;
    }
    return hash;
}

std::uint32_t AddedVertices::object_of(std::uint32_t vertex) const {
    const auto& ends = mesh_.object_ends;
    return static_cast<std::uint32_t>(std::ranges::upper_bound(ends, vertex) - ends.begin());
}

std::uint32_t AddedVertices::at(std::uint32_t from, std::uint32_t to, double share) {
    const glm::dvec3 p{mesh_.vertices[from]}, q{mesh_.vertices[to]};
    if (share <= 0) return from;
    if (share >= 1) return to;
    const glm::vec3 position = glm::vec3{p + (q - p) * share} + 0.0F; // -0 becomes 0
    return add({position, object_of(from)},
               {.vertex = 0, .from = from, .to = to, .share = static_cast<float>(share)});
}

std::uint32_t AddedVertices::beside(std::uint32_t vertex, glm::vec3 position) {
    return add({position + 0.0F, object_of(vertex)},
               {.vertex = 0, .from = vertex, .to = vertex, .share = 0});
}

std::uint32_t AddedVertices::add(const Place& place, const CutVertex& cut) {
    const auto fresh = static_cast<std::uint32_t>(places_.size());
    const auto [known, is_new] = known_.emplace(place, fresh);
    if (is_new) {
        places_.push_back(place);
        cuts_.push_back(cut);
    }
    return static_cast<std::uint32_t>(mesh_.vertices.size()) + known->second;
}

std::vector<std::uint32_t> AddedVertices::insert() {
    const auto count = static_cast<std::uint32_t>(mesh_.vertices.size());
    constexpr std::uint32_t unknown = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(count + places_.size(), unknown);
    std::vector<std::uint32_t> equal(places_.size(), unknown); // vertex of the mesh
    WeldedMesh& mesh = mesh_;
    if (!places_.empty()) {
        std::uint32_t object = 0;
        for (std::uint32_t v = 0; v < count; ++v) {
            while (v >= mesh.object_ends[object]) ++object;
            const auto known = known_.find({mesh.vertices[v], object});
            if (known != known_.end()) equal[known->second] = v;
        }
    }
    std::vector<std::vector<std::uint32_t>> of_object(mesh.object_ends.size());
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
        if (equal[i] == unknown) of_object[places_[i].object].push_back(i);
    }
    std::vector<glm::vec3> vertices;
    std::vector<std::uint32_t> sources;
    std::vector<CutVertex> cuts;
    std::uint32_t next = 0;
    for (std::size_t object = 0; object < of_object.size(); ++object) {
        for (; next < mesh.object_ends[object]; ++next) {
            number[next] = static_cast<std::uint32_t>(vertices.size());
            vertices.push_back(mesh.vertices[next]);
            sources.push_back(mesh.vertex_sources[next]);
        }
        for (const std::uint32_t i : of_object[object]) {
            CutVertex cut = cuts_[i];
            number[count + i] = cut.vertex = static_cast<std::uint32_t>(vertices.size());
            vertices.push_back(places_[i].position);
            sources.push_back(mesh.vertex_sources[cut.share < 0.5F ? cut.from : cut.to]);
            if (cut.from != cut.to) cuts.push_back(cut);
        }
        mesh.object_ends[object] = static_cast<std::uint32_t>(vertices.size());
    }
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
        if (equal[i] != unknown) number[count + i] = number[equal[i]];
    }
    for (CutVertex& cut : cuts) {
        cut.from = number[cut.from];
        cut.to = number[cut.to];
    }
    cuts_ = std::move(cuts);
    mesh.vertices = std::move(vertices);
    mesh.vertex_sources = std::move(sources);
    for (glm::uvec3& t : mesh.triangles) t = {number[t.x], number[t.y], number[t.z]};
    return number;
}

} // namespace lineatlas
