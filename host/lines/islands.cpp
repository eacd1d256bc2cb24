#include "islands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "base/vertex_sets.hpp"
#include "box_tree.hpp"

namespace lineatlas {
namespace {

/// If boxes meet more often, all parts count as one island: finding islands must not take longer
/// than copies save.
constexpr std::size_t most_meetings = 10'000'000;

/// The most originals of one size that islands of that size are compared with.
constexpr int most_originals = 8;

std::vector<Bounds> boxes_of_parts(const WeldedMesh& mesh, const MeshParts& parts) {
    std::vector<Bounds> boxes(parts.count);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        Bounds& box = boxes[parts.of_vertex[v]];
        box = {glm::min(box.min, mesh.vertices[v]), glm::max(box.max, mesh.vertices[v])};
    }
    return boxes;
}

/// Unites parts whose boxes meet. Returns whether it has looked at all of them.
bool unite_meeting(const std::vector<Bounds>& boxes, VertexSets& sets) {
    std::size_t meetings = 0;
    const BoxTree tree{boxes};
    const auto may = [&](std::uint32_t, std::uint32_t) { return meetings < most_meetings; };
    for (const BoxTree::NodePair part : tree.parts_of_pairs(may)) {
        ask_between_pieces();
        const auto unite = [&](std::uint32_t a, std::uint32_t b) {
            ++meetings;
            sets.unite(a, b);
        };
        tree.visit_meeting_pairs(part, unite, may);
    }
    return meetings < most_meetings;
}

/// Whether the two numbers are each other's in all pairs so far.
class Pairing {
  public:
    bool pair(std::uint32_t one, std::uint32_t other) {
        return of_one_.try_emplace(one, other).first->second == other &&
               of_other_.try_emplace(other, one).first->second == one;
    }

  private:
    std::unordered_map<std::uint32_t, std::uint32_t> of_one_, of_other_;
};

double largest_coordinate(const std::vector<glm::vec3>& vertices) {
    glm::vec3 most{0};
    for (const glm::vec3& vertex : vertices) most = glm::max(most, glm::abs(vertex));
    return std::max({most.x, most.y, most.z});
}

} // namespace

OfIslands::OfIslands(std::size_t islands, const std::vector<std::uint32_t>& island)
    : first_(islands + 1, 0), things_(island.size()), places_(island.size()) {
    for (const std::uint32_t own : island) ++first_[own + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t thing = 0; thing < island.size(); ++thing) {
        const std::uint32_t own = island[thing];
        places_[thing] = next[own] - first_[own];
        things_[next[own]++] = thing;
    }
}

Islands::Islands(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges, const MeshParts& parts,
                 const TriangleOwners& owners, double reach)
    : mesh_(mesh), mesh_edges_(edges), owners_(owners) {
    const std::uint32_t count = find_islands(parts, reach);
    if (count < 2) return;
    is_copy_.assign(count, false);
    const std::vector<Size> size = sizes(count);
    std::vector<std::uint32_t> islands;
    for (std::uint32_t island = 0; island < count; ++island)
        if (size[island].triangles > 0) islands.push_back(island);
    std::ranges::stable_sort(islands, {}, [&](std::uint32_t island) { return size[island]; });
    const auto next_size = [&](auto first) {
        return std::find_if(first, islands.end(),
                            [&](std::uint32_t island) { return size[island] != size[*first]; });
    };
    const auto are_alike = [&](std::uint32_t a, std::uint32_t b) { return size[a] == size[b]; };
    if (std::ranges::adjacent_find(islands, are_alike) == islands.end()) return;
    // Rounding moves each end by half a unit in the last place along each axis.
    rounding_ = 2 * std::numeric_limits<float>::epsilon() * largest_coordinate(mesh.vertices);
    list_things(count);
    for (auto first = islands.begin(); first != islands.end();) {
        const auto end = next_size(first);
        find_copies({first, end});
        first = end;
    }
    mark_copies();
}

/// Returns how many there are; 1 if looking for more would take too long.
std::uint32_t Islands::find_islands(const MeshParts& parts, double reach) {
    VertexSets sets{parts.count};
    for (const std::vector<std::uint32_t>& polyline : mesh_.polylines)
        for (std::size_t i = 1; i < polyline.size(); ++i)
            sets.unite(parts.of_vertex[polyline[i - 1]], parts.of_vertex[polyline[i]]);
    std::vector<Bounds> boxes = boxes_of_parts(mesh_, parts);
    // A polyline runs from part to part.
    for (std::uint32_t part = 0; part < parts.count; ++part) {
        Bounds& all = boxes[sets.find(part)];
        all = {glm::min(all.min, boxes[part].min), glm::max(all.max, boxes[part].max)};
    }
    const auto half = static_cast<float>(reach / 2);
    for (Bounds& box : boxes) box = {box.min - half, box.max + half};
    if (!unite_meeting(boxes, sets)) return 1;
    std::uint32_t count = 0;
    std::vector<std::uint32_t> island(parts.count);
    for (std::uint32_t part = 0; part < parts.count; ++part) {
        const std::uint32_t name = sets.find(part); // the least part of the island
        island[part] = name == part ? count++ : island[name];
    }
    if (count < 2) return count;
    island_of_vertex_.resize(mesh_.vertices.size());
    for_each_index(island_of_vertex_.size(),
                   [&](std::size_t v) { island_of_vertex_[v] = island[parts.of_vertex[v]]; });
    return count;
}

/// Islands with polylines have size 0.
std::vector<Islands::Size> Islands::sizes(std::uint32_t count) const {
    std::vector<Size> size(count);
    for (const std::uint32_t island : island_of_vertex_) ++size[island].vertices;
    for (const glm::uvec3& t : mesh_.triangles) ++size[island_of_vertex_[t.x]].triangles;
    for (const MeshEdge& edge : mesh_edges_) ++size[island_of_vertex_[edge.p]].edges;
    for (const std::vector<std::uint32_t>& polyline : mesh_.polylines)
        size[island_of_vertex_[polyline.front()]] = {};
    return size;
}

void Islands::list_things(std::uint32_t count) {
    vertices_ = OfIslands{count, island_of_vertex_};
    std::vector<std::uint32_t> island(mesh_.triangles.size());
    for_each_index(island.size(),
                   [&](std::size_t i) { island[i] = island_of_vertex_[mesh_.triangles[i].x]; });
    triangles_ = OfIslands{count, island};
    island.resize(mesh_edges_.size());
    for_each_index(island.size(),
                   [&](std::size_t i) { island[i] = island_of_vertex_[mesh_edges_[i].p]; });
    edges_ = OfIslands{count, island};
}

/// `alike`: islands of one size.
void Islands::find_copies(std::vector<std::uint32_t> alike) {
    for (int i = 0; i < most_originals && alike.size() > 1; ++i) {
        const std::uint32_t original = alike.front();
        const Corners corners = far_corners(original);
        std::vector<char> is_same(alike.size(), 0);
        for_each_index(
            alike.size() - 1,
            [&](std::size_t k) {
                is_same[k + 1] = are_same(original, alike[k + 1]) &&
                                 have_same_shape(corners, original, alike[k + 1]);
            },
            1);
        std::vector<std::uint32_t> others;
        for (std::size_t k = 1; k < alike.size(); ++k) {
            if (is_same[k] != 0)
                copies_.push_back({original, alike[k]});
            else
                others.push_back(alike[k]);
        }
        alike = std::move(others);
    }
}

bool Islands::are_same(std::uint32_t original, std::uint32_t island) const {
    return have_same_triangles(original, island) && have_same_edges(original, island) &&
           have_same_owners(owners_.materials, original, island) &&
           have_same_owners(owners_.bodies, original, island) &&
           have_same_owners(owners_.objects, original, island);
}

bool Islands::have_same_triangles(std::uint32_t original, std::uint32_t island) const {
    return std::ranges::equal(
        triangles_[original], triangles_[island], [&](std::uint32_t a, std::uint32_t b) {
            const glm::uvec3 one = mesh_.triangles[a], other = mesh_.triangles[b];
            return vertices_.place(one.x) == vertices_.place(other.x) &&
                   vertices_.place(one.y) == vertices_.place(other.y) &&
                   vertices_.place(one.z) == vertices_.place(other.z);
        });
}

bool Islands::have_same_edges(std::uint32_t original, std::uint32_t island) const {
    const auto same_face = [&](std::uint32_t a, std::uint32_t b) {
        if (a == LA_NO_FACE || b == LA_NO_FACE) return a == b;
        return (a & LA_FACE_FLIPPED) == (b & LA_FACE_FLIPPED) &&
               triangles_.place(a & LA_FACE_INDEX) == triangles_.place(b & LA_FACE_INDEX);
    };
    return std::ranges::equal(
        edges_[original], edges_[island], [&](std::uint32_t a, std::uint32_t b) {
            const MeshEdge &one = mesh_edges_[a], &other = mesh_edges_[b];
            return vertices_.place(one.p) == vertices_.place(other.p) &&
                   vertices_.place(one.q) == vertices_.place(other.q) &&
                   one.face_count == other.face_count && same_face(one.face_a, other.face_a) &&
                   same_face(one.face_b, other.face_b);
        });
}

/// Whether the same triangles have an owner in common.
bool Islands::have_same_owners(std::span<const std::uint32_t> owners, std::uint32_t original,
                               std::uint32_t island) const {
    if (owners.empty()) return true;
    Pairing pairing;
    constexpr std::uint32_t nobody = 0xFFFFFFFF;
    std::uint32_t last_a = nobody, last_b = nobody;
    return std::ranges::equal(triangles_[original], triangles_[island],
                              [&](std::uint32_t a, std::uint32_t b) {
                                  if (owners[a] == last_a && owners[b] == last_b) return true;
                                  last_a = owners[a];
                                  last_b = owners[b];
                                  return pairing.pair(last_a, last_b);
                              });
}

/// The first corner, the corner farthest from it, and the corner farthest from their line.
Islands::Corners Islands::far_corners(std::uint32_t island) const {
    const auto farthest = [&](const auto& distance) {
        std::uint32_t best = 0;
        double most = -1;
        for (std::uint32_t k = 0; k < vertices_[island].size(); ++k) {
            const double own = distance(at(island, k));
            if (own <= most) continue;
            most = own;
            best = k;
        }
        return best;
    };
    const glm::dvec3 origin = at(island, 0);
    const std::uint32_t second =
        farthest([&](glm::dvec3 point) { return glm::distance(point, origin); });
    const glm::dvec3 along = at(island, second) - origin;
    const std::uint32_t third =
        farthest([&](glm::dvec3 point) { return glm::length(glm::cross(along, point - origin)); });
    return {0, second, third};
}

/// Nothing if the corners are so near to one line that they give no frame.
std::optional<Islands::Frame> Islands::frame_of(std::uint32_t island,
                                                const Corners& corners) const {
    const glm::dvec3 origin = at(island, corners[0]);
    const glm::dvec3 along = at(island, corners[1]) - origin;
    const glm::dvec3 normal = glm::cross(along, at(island, corners[2]) - origin);
    constexpr double least = 1e-3; // distance of the third corner, as a share of that of the second
    if (!(glm::length(normal) > least * glm::dot(along, along))) return {};
    const glm::dvec3 x = glm::normalize(along), z = glm::normalize(normal);
    return Frame{origin, {x, glm::cross(z, x), z}};
}

/// Both frames are right-handed, so mirrored islands differ. The second corner is the farthest
/// vertex from the first, the third the farthest from the line of both. So an error of a corner
/// moves no vertex by more than the corner itself, and a vertex differs by at most about its own
/// rounding and those of three corners.
bool Islands::have_same_shape(const Corners& corners, std::uint32_t original,
                              std::uint32_t island) const {
    const std::optional<Frame> one = frame_of(original, corners), other = frame_of(island, corners);
    if (!one || !other) return false;
    for (std::uint32_t k = 0; k < vertices_[original].size(); ++k) {
        const glm::dvec3 apart = glm::abs(one->at(at(original, k)) - other->at(at(island, k)));
        if (!(std::max({apart.x, apart.y, apart.z}) <= 4 * rounding_)) return false;
    }
    return true;
}

void Islands::mark_copies() {
    std::ranges::sort(copies_, {}, &Copy::island);
    is_copy_.assign(is_copy_.size(), false);
    for (const Copy& copy : copies_) is_copy_[copy.island] = true;
}

bool Islands::tell_apart(std::span<const std::optional<LineKind>> kinds) {
    const auto same_kind = [&](std::uint32_t a, std::uint32_t b) { return kinds[a] == kinds[b]; };
    const std::size_t gone = std::erase_if(copies_, [&](const Copy& copy) {
        return !std::ranges::equal(edges_[copy.original], edges_[copy.island], same_kind);
    });
    if (gone > 0) mark_copies();
    return gone > 0;
}

std::vector<bool> Islands::copied_triangles() const {
    if (!has_copies()) return {};
    std::vector<bool> copied(mesh_.triangles.size());
    for (std::size_t i = 0; i < copied.size(); ++i) copied[i] = is_copy(mesh_.triangles[i].x);
    return copied;
}

std::vector<bool> Islands::copied_edges() const {
    if (!has_copies()) return {};
    std::vector<bool> copied(mesh_edges_.size());
    for (std::size_t i = 0; i < copied.size(); ++i) copied[i] = is_copy(mesh_edges_[i].p);
    return copied;
}

void Islands::add_copies(Seams& seams) const {
    const auto island_of = [&](std::uint32_t edge) {
        return island_of_vertex_[mesh_edges_[edge].p];
    };
    std::vector<std::vector<std::uint32_t>> cut(is_copy_.size());
    for (const std::uint32_t edge : seams.cut) cut[island_of(edge)].push_back(edge);
    std::vector<std::vector<EdgePart>> left(is_copy_.size());
    for (const EdgePart& part : seams.left) left[island_of(part.edge)].push_back(part);
    for (const Copy& copy : copies_) {
        const std::span<const std::uint32_t> own = edges_[copy.island];
        for (const std::uint32_t edge : edges_[copy.original])
            if (seams.of_edge[edge]) seams.of_edge[own[edges_.place(edge)]] = true;
        for (const std::uint32_t edge : cut[copy.original])
            seams.cut.push_back(own[edges_.place(edge)]);
        for (const EdgePart& part : left[copy.original])
            seams.left.push_back({own[edges_.place(part.edge)], part.from, part.to});
    }
    std::ranges::sort(seams.cut);
    std::ranges::stable_sort(seams.left, {}, &EdgePart::edge);
}

EdgePlace Islands::in_copy(const EdgePlace& place, std::uint32_t island) const {
    const auto vertex = [&](std::uint32_t v) { return vertices_[island][vertices_.place(v)]; };
    return {vertex(place.from), vertex(place.to), place.share};
}

Intersection Islands::in_copy(const Intersection& one, std::uint32_t island) const {
    const auto triangle = [&](std::uint32_t t) { return triangles_[island][triangles_.place(t)]; };
    return {in_copy(one.p, island), in_copy(one.q, island), triangle(one.face_a),
            triangle(one.face_b)};
}

void Islands::add_copies(std::vector<Intersection>& intersections) const {
    std::vector<std::vector<Intersection>> of_island(is_copy_.size());
    for (const Intersection& one : intersections)
        of_island[island_of_vertex_[one.p.from]].push_back(one);
    for (const Copy& copy : copies_)
        for (const Intersection& one : of_island[copy.original])
            intersections.push_back(in_copy(one, copy.island));
}

} // namespace lineatlas
