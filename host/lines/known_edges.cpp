#include "known_edges.hpp"

#include <numbers>
#include <string>

#include "core/pair_key.hpp"
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

KnownEdges::KnownEdges(const Mesh& mesh, const WeldedMesh& welded) {
    if (mesh.known_edges.empty()) return;
    const std::vector<std::uint32_t> vertices = vertices_of_positions(mesh, welded);
    kinds_.reserve(mesh.known_edges.size());
    for (const KnownEdge& edge : mesh.known_edges) {
        check_index(edge.from, mesh.positions.size());
        check_index(edge.to, mesh.positions.size());
        if (edge.kind == KnownEdge::Kind::wire) continue;
        const std::uint32_t p = vertices[edge.from], q = vertices[edge.to];
        if (p == unused || q == unused || p == q) continue;
        all_ = all_ || edge.kind != KnownEdge::Kind::marked;
        // Where parts touch, two edges may be in one place. The one that is a line wins.
        const auto [entry, fresh] = kinds_.try_emplace(pair_key(p, q), edge.kind);
        if (!fresh && is_crease(edge.kind)) entry->second = edge.kind;
    }
}

bool KnownEdges::smooth(const MeshEdge& edge) const {
    if (kinds_.empty()) return false;
    const auto found = kinds_.find(pair_key(edge.p, edge.q));
    return found != kinds_.end() && found->second == KnownEdge::Kind::smooth;
}

bool KnownEdges::drawn(const MeshEdge& edge) const {
    if (kinds_.empty()) return false;
    const auto found = kinds_.find(pair_key(edge.p, edge.q));
    return found != kinds_.end() && is_crease(found->second);
}

std::optional<LineKind> KnownEdges::classify(const MeshEdge& edge, const WeldedMesh& mesh,
                                             double bend, const LineOptions& options) const {
    const auto found = kinds_.find(pair_key(edge.p, edge.q));
    const KnownEdge::Kind kind =
        found != kinds_.end() ? found->second : KnownEdge::Kind::seam; // within a face
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
