#include "known_edges.hpp"

#include <numbers>
#include <string>
#include <vector>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

constexpr std::uint32_t unused = LineSource::none;

bool is_crease(KnownEdge::Kind kind) {
    return kind == KnownEdge::Kind::sharp || kind == KnownEdge::Kind::marked;
}

/// Per position of the mesh the vertex that triangles use in its place.
std::vector<std::uint32_t> vertices_of_positions(const Mesh& mesh, const WeldedMesh& welded) {
    std::vector<std::uint32_t> vertices(mesh.positions.size(), unused);
    for (std::size_t i = 0; i < welded.triangles.size(); ++i) {
        const glm::uvec3 source = mesh.triangles[welded.triangle_source[i]];
        for (int k = 0; k < 3; ++k)
            vertices[source[welded.source_corner(i, k)]] = welded.triangles[i][k];
    }
    return vertices;
}

void check_index(std::uint32_t index, std::size_t count) {
    if (index < count) return;
    throw UsageError("mesh: a known edge has the index " + std::to_string(index) +
                     ", but there are " + std::to_string(count) + " positions, counted from 0");
}

} // namespace

KnownEdges::KnownEdges(const Mesh& mesh, const WeldedMesh& welded) : edges_(mesh.known_edges) {
    if (edges_.empty()) return;
    const std::vector<std::uint32_t> vertices = vertices_of_positions(mesh, welded);
    for (const KnownEdge& edge : edges_) {
        check_index(edge.from, vertices.size());
        check_index(edge.to, vertices.size());
    }
    const auto ends_of = [&](std::size_t i) -> std::optional<glm::uvec2> {
        const KnownEdge& edge = edges_[i];
        const glm::uvec2 ends{vertices[edge.from], vertices[edge.to]};
        if (edge.kind == KnownEdge::Kind::wire || ends.x == unused || ends.y == unused ||
            ends.x == ends.y)
            return {};
        return ends;
    };
    for (std::size_t i = 0; i < edges_.size() && !all_; ++i)
        all_ = edges_[i].kind != KnownEdge::Kind::marked && ends_of(i);
    by_vertices_.emplace(welded.vertices.size(), edges_.size(), ends_of);
}

std::optional<KnownEdge::Kind> KnownEdges::kind_of(const MeshEdge& edge) const {
    if (!by_vertices_) return {};
    const auto found = by_vertices_->between(edge.p, edge.q);
    if (found.empty()) return {};
    // Where parts touch, two edges may be in one place. The one that is a line wins.
    for (const VertexPairs::Item& item : found)
        if (is_crease(edges_[item.index].kind)) return edges_[item.index].kind;
    return edges_[found.front().index].kind;
}

bool KnownEdges::smooth(const MeshEdge& edge) const {
    return kind_of(edge) == KnownEdge::Kind::smooth;
}

bool KnownEdges::drawn(const MeshEdge& edge) const {
    const std::optional<KnownEdge::Kind> kind = kind_of(edge);
    return kind && is_crease(*kind);
}

std::optional<LineKind> KnownEdges::classify(const MeshEdge& edge, const WeldedMesh& mesh,
                                             double bend, const LineOptions& options) const {
    const KnownEdge::Kind kind = kind_of(edge).value_or(KnownEdge::Kind::seam); // within a face
    MeshEdge seen = edge;
    LineOptions rule = options;
    const bool is_line =
        is_crease(kind) || (kind == KnownEdge::Kind::smooth && options.smooth_edges);
    if (is_line && (options.lines & mask_of(LineKind::crease)) != 0) {
        // Faces of other parts at the same edge do not make it a boundary.
        if (edge.face_count >= 2 || (options.lines & mask_of(LineKind::boundary)) == 0)
            return LineKind::crease;
    }
    if (kind == KnownEdge::Kind::free) seen.face_count = 1;
    // Where parts touch, a triangle may stand for two, or an edge may have four. A face that goes
    // on in the file does not end there.
    if (kind == KnownEdge::Kind::seam) {
        if (edge.face_count < 2) return std::nullopt;
        seen.face_count = 2;
    }
    rule.crease = std::numbers::pi_v<float>; // no angle is larger
    return lineatlas::classify(seen, mesh, bend, rule);
}

} // namespace lineatlas
