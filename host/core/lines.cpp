#include "lineatlas/lines.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <string>
#include <unordered_map>

#include <glm/common.hpp>

#include "chain.hpp"
#include "edges.hpp"
#include "known_edges.hpp"
#include "lineatlas/error.hpp"
#include "weld.hpp"

namespace lineatlas {
namespace {

/// A fixed line (always drawn) or a silhouette candidate, before it is chained.
struct Line {
    std::uint32_t p, q;
    std::uint32_t face_a = LA_NO_FACE;
    std::uint32_t face_b = LA_NO_FACE;
    LineKind kind;
    LineSource source{}; ///< from p to q
};

void check_angle(const char* name, float angle) {
    constexpr float most = std::numbers::pi_v<float> * 1.000001F; // of 180 degrees in floats
    if (angle >= 0 && angle <= most) return;                      // NaN is not
    throw UsageError("lines: " + std::string{name} + " must be from 0 to pi radians, not " +
                     std::to_string(angle));
}

std::uint64_t edge_key(std::uint32_t p, std::uint32_t q) {
    return std::uint64_t{std::min(p, q)} << 32U | std::max(p, q);
}

/// The segments of the file's polylines, each once.
std::vector<Line> file_lines(const WeldedMesh& mesh,
                             std::unordered_map<std::uint64_t, std::size_t>& line_of_edge) {
    std::vector<Line> lines;
    for (std::size_t k = 0; k < mesh.polylines.size(); ++k) {
        const std::vector<std::uint32_t>& polyline = mesh.polylines[k];
        const std::vector<std::uint32_t>& sources = mesh.polyline_sources[k];
        for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
            const std::uint64_t key = edge_key(polyline[i], polyline[i + 1]);
            if (!line_of_edge.emplace(key, lines.size()).second) continue;
            lines.push_back({.p = polyline[i],
                             .q = polyline[i + 1],
                             .kind = LineKind::file,
                             .source = {.from = sources[i], .to = sources[i + 1]}});
        }
    }
    return lines;
}

/// The edge from p to q of a welded triangle, in the mesh that was welded.
LineSource triangle_edge(const Mesh& mesh, const WeldedMesh& welded, std::uint32_t face,
                         std::uint32_t p, std::uint32_t q) {
    const glm::uvec3 corners = welded.triangles[face];
    LineSource result{.triangle = welded.triangle_source[face]};
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t position = mesh.triangles[result.triangle][i];
        if (corners[i] == p) result.from = position;
        if (corners[i] == q) result.to = position;
    }
    return result;
}

/// The colours of groups, and which one each triangle has.
void add_colors(const std::vector<MeshGroup>& groups,
                const std::vector<std::uint32_t>& triangle_group, LineSet& result) {
    std::map<std::array<float, 3>, std::uint16_t> known;
    const auto coded = [&](const MeshGroup& group) -> std::uint16_t {
        if (!group.color) return LineSet::no_color;
        const glm::vec3 color = *group.color;
        const auto found = known.find({color.x, color.y, color.z});
        if (found != known.end()) return found->second;
        if (known.size() == LineSet::no_color) return LineSet::no_color;
        const auto fresh = static_cast<std::uint16_t>(known.size());
        known[{color.x, color.y, color.z}] = fresh;
        result.colors.push_back(color);
        return fresh;
    };
    std::vector<std::uint16_t> color_of_group;
    color_of_group.reserve(groups.size());
    for (const MeshGroup& group : groups) color_of_group.push_back(coded(group));
    if (result.colors.empty()) return;
    result.triangle_color.reserve(triangle_group.size());
    for (const std::uint32_t group : triangle_group)
        result.triangle_color.push_back(color_of_group[group]);
}

class LineSetBuilder {
  public:
    explicit LineSetBuilder(const WeldedMesh& mesh) {
        edges_at_vertex_.assign(mesh.vertices.size(), 0);
    }

    void count_vertices(const std::vector<Line>& lines) {
        for (const Line& line : lines) {
            ++edges_at_vertex_[line.p];
            ++edges_at_vertex_[line.q];
        }
    }

    void append(const Line& line, bool reversed, std::uint32_t from_start, std::uint32_t to_end,
                bool closed) {
        std::uint32_t tag = static_cast<std::uint32_t>(line.kind);
        if (closed) tag |= LA_TAG_CLOSED;
        const bool alone = from_start == 0 && to_end == 0 && edges_at_vertex_[line.p] == 1 &&
                           edges_at_vertex_[line.q] == 1;
        if (alone) tag |= LA_TAG_LONE;
        result.segments.push_back({.p = reversed ? line.q : line.p,
                                   .q = reversed ? line.p : line.q,
                                   .face_a = line.face_a,
                                   .face_b = line.face_b,
                                   .from_start = from_start,
                                   .to_end = to_end,
                                   .path = result.path_count,
                                   .tag = tag});
        const LineSource& source = line.source;
        result.sources.push_back({reversed ? source.to : source.from,
                                  reversed ? source.from : source.to, source.triangle});
        ++result.kind_counts[static_cast<std::size_t>(line.kind)];
    }

    /// Fixed lines, chained.
    void append_paths(const std::vector<Line>& lines, const std::vector<Chain>& chains) {
        for (const Chain& chain : chains) {
            const auto count = static_cast<std::uint32_t>(chain.steps.size());
            for (std::uint32_t i = 0; i < count; ++i) {
                const ChainStep step = chain.steps[i];
                append(lines[step.edge], step.reversed, i, count - 1 - i, chain.closed);
            }
            ++result.path_count;
        }
    }

    /// Silhouette candidates: which of them are silhouettes changes from frame to frame, so each is
    /// a path of its own (§4.1).
    void append_candidates(const std::vector<Line>& candidates) {
        for (const Line& line : candidates) {
            append(line, false, 0, 0, false);
            ++result.path_count;
        }
    }

    LineSet result;

  private:
    std::vector<std::uint32_t> edges_at_vertex_;
};

} // namespace

LineSet extract_lines(const Mesh& mesh, const LineOptions& options) {
    check_angle("crease_angle", options.crease_angle);
    check_angle("chain_angle", options.chain_angle);
    const MeshObjects objects = options.separate_objects ? find_objects(mesh) : MeshObjects{};
    WeldedMesh welded = weld(mesh, objects);
    std::vector<MeshEdge> edges = mesh_edges(welded);
    std::vector<std::uint32_t> first_face; // before a neighbour stands for a sliver
    first_face.reserve(edges.size());
    for (const MeshEdge& edge : edges) first_face.push_back(edge.face_a);
    replace_slivers(welded, edges);
    const std::vector<glm::dvec3> normals = face_normals(welded);

    const KnownEdges known{mesh, welded};
    std::vector<Line> fixed;
    std::vector<Line> candidates;
    std::unordered_map<std::uint64_t, std::size_t> line_of_edge;
    if ((options.kinds & mask_of(LineKind::file)) != 0) fixed = file_lines(welded, line_of_edge);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const MeshEdge& edge = edges[i];
        if (!line_of_edge.empty()) {
            const auto found = line_of_edge.find(edge_key(edge.p, edge.q));
            if (found != line_of_edge.end()) {
                fixed[found->second].face_a = edge.face_a;
                fixed[found->second].face_b = edge.face_b;
                continue;
            }
        }
        const std::optional<LineKind> kind = known.any()
                                                 ? known.classify(edge, welded, normals, options)
                                                 : classify(edge, welded, normals, options);
        if (!kind) continue;
        (*kind == LineKind::silhouette ? candidates : fixed)
            .push_back({edge.p, edge.q, edge.face_a, edge.face_b, *kind,
                        triangle_edge(mesh, welded, first_face[i], edge.p, edge.q)});
    }

    std::vector<ChainEdge> to_chain;
    to_chain.reserve(fixed.size());
    for (const Line& line : fixed) {
        to_chain.push_back({line.p, line.q, static_cast<std::uint32_t>(line.kind)});
    }
    LineSetBuilder builder{welded};
    builder.count_vertices(fixed);
    builder.count_vertices(candidates);
    builder.result.segments.reserve(fixed.size() + candidates.size());
    builder.result.sources.reserve(fixed.size() + candidates.size());
    builder.append_paths(fixed, chain_edges(welded.vertices, to_chain, options.chain_angle));
    builder.append_candidates(candidates);

    LineSet result = std::move(builder.result);
    result.odd = welded.odd;
    result.odd.flat = flat_face_count(welded, normals);
    result.vertices = std::move(welded.vertices);
    result.triangles = std::move(welded.triangles);
    result.vertex_sources = std::move(welded.vertex_sources);
    for (std::size_t i = 0; i < objects.names.size(); ++i) {
        const std::uint32_t first = i > 0 ? welded.object_ends[i - 1] : 0;
        result.objects.push_back({objects.names[i], first, welded.object_ends[i] - first});
    }
    add_colors(mesh.groups, welded.triangle_group, result);
    for (const glm::vec3& v : result.vertices) {
        result.bounds.min = glm::min(result.bounds.min, v);
        result.bounds.max = glm::max(result.bounds.max, v);
    }
    return result;
}

} // namespace lineatlas
