#include "line_tables.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "base/vertex_pairs.hpp"
#include "base/vertex_sets.hpp"
#include "compute/transfer.hpp"
#include "core/model_limits.hpp"

namespace lineatlas {
namespace {

bool is_candidate(const Segment& segment) {
    return (segment.tag & LA_TAG_KIND_MASK) == LA_KIND_SILHOUETTE && segment.from_start == 0 &&
           segment.to_end == 0 && segment.face_a != LA_NO_FACE && segment.face_b != LA_NO_FACE;
}

std::span<const Segment> candidates_of(std::span<const Segment> segments) {
    std::size_t first = segments.size();
    while (first > 0 && is_candidate(segments[first - 1])) --first;
    return segments.subspan(first);
}

/// Whether the device's buffers hold the contours of the line set, and all candidates together.
/// Frames add only as much as there are silhouettes.
bool has_room_for_contours(const LineSet& lines, std::span<const Segment> segments,
                           std::uint64_t largest_buffer) {
    const Contours& contours = lines.contours;
    return candidates_of(segments).size_bytes() <= largest_buffer &&
           contours.faces.size() * sizeof(compute::ContourFace) <= largest_buffer &&
           contours.corners.size() * sizeof(ContourCorner) <= largest_buffer;
}

/// Cuts segments into chunks. Candidates stay together if a buffer holds them: the few silhouettes
/// among them are chained, and any two may be neighbours.
std::vector<SegmentRange> cut_into_chunks(std::span<const Segment> segments, std::uint64_t usual,
                                          std::uint64_t largest_buffer) {
    const std::size_t candidates = candidates_of(segments).size();
    if (candidates == 0 || candidates > largest_buffer / sizeof(Segment))
        return cut_segments(segments, usual);
    const auto first = static_cast<std::uint32_t>(segments.size() - candidates);
    std::vector<SegmentRange> chunks = cut_segments(segments.first(first), usual);
    chunks.push_back({first, static_cast<std::uint32_t>(candidates)});
    return chunks;
}

/// Finds the candidates of a chunk. Uploads where the candidates that stay edges of the mesh meet
/// each other.
void add_candidates(compute::Device& device, std::span<const Segment> segments,
                    const Contours* contours, LineTables::Chunk& chunk) {
    const std::span<const Segment> candidates = candidates_of(segments);
    if (candidates.empty()) return;
    chunk.candidate_count = static_cast<std::uint32_t>(candidates.size());
    const std::size_t others =
        contours != nullptr ? contours->replaced + contours->faces.size() : 0;
    const std::span<const Segment> edges = candidates.first(candidates.size() - others);
    std::uint32_t last = 0;
    for (const Segment& edge : edges) last = std::max({last, edge.p, edge.q});
    const EdgeEnds found = ends_by_vertex(edges, std::size_t{last} + 2);
    chunk.end_offsets = compute::upload(device, found.offsets, compute::table::end_offsets);
    chunk.ends = compute::upload(device, found.ends, compute::table::ends);
}

void add_contours(compute::Device& device, const LineSet& lines, std::span<const Segment> segments,
                  LineTables::Chunk& chunk) {
    const Contours& contours = lines.contours;

    chunk.corners = compute::upload(device, contours.corners, compute::table::contour_corners);
    chunk.edges =
        compute::upload(device, contour_edges(contours, segments), compute::table::contour_edges);
    chunk.face_corners =
        compute::upload(device, contour_corners(contours), compute::table::contour_face_corners);
    chunk.faces = compute::upload(device, contour_faces(contours), compute::table::contour_faces);
    chunk.patches =
        compute::upload(device, contour_patches(lines, segments), compute::table::contour_patches);
    chunk.replaced = contours.replaced;
    chunk.vertex_count = static_cast<std::uint32_t>(lines.vertices.size());
}

/// Calls `each` with each face of contours, the number of a side of it, and the edge there.
template <class Each>
void for_each_side(const Contours& contours, Each&& each) {
    for (std::uint32_t i = 0; i < contours.faces.size(); ++i) {
        const glm::uvec3 face = contours.faces[i];
        if (face.x == face.y) continue; // stands in empty room, see Assembly
        for (std::uint32_t k = 0; k < 3; ++k) each(i, k, face[static_cast<int>(k)]);
    }
}

} // namespace

EdgeEnds ends_by_vertex(std::span<const Segment> edges, std::size_t offset_count) {
    // Calls `each` with every vertex where an edge ends, and the number of that end.
    const auto for_each_end = [&](const auto& each) {
        std::uint32_t end = 0;
        for (const Segment& edge : edges)
            for (const std::uint32_t vertex : {edge.p, edge.q}) each(vertex, end++);
    };
    EdgeEnds result{std::vector<std::uint32_t>(offset_count, 0),
                    std::vector<std::uint32_t>(2 * edges.size())};
    for_each_end([&](std::uint32_t vertex, std::uint32_t) { ++result.offsets[vertex + 1]; });
    std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
    std::vector<std::uint32_t> next = result.offsets;
    for_each_end(
        [&](std::uint32_t vertex, std::uint32_t end) { result.ends[next[vertex]++] = end; });
    return result;
}

std::vector<compute::ContourEdge> contour_edges(const Contours& contours,
                                                std::span<const Segment> segments) {
    std::vector<compute::ContourEdge> edges(contours.edges.size(),
                                            {.face_a = LA_NO_FACE, .face_b = LA_NO_FACE});
    const std::span faces = segments.last(contours.faces.size());
    for_each_side(contours, [&](std::uint32_t face, std::uint32_t, std::uint32_t side) {
        compute::ContourEdge& edge = edges[side & ~LA_CONTOUR_TURNED];
        (edge.face_a == LA_NO_FACE ? edge.face_a : edge.face_b) = faces[face].face_a;
    });
    // Beyond the border of a surface: as the line there has it.
    const auto vertex = [&](std::uint32_t corner) { return contours.corners[corner].vertex; };
    std::uint32_t vertices = 0;
    for (const ContourCorner& corner : contours.corners)
        vertices = std::max(vertices, corner.vertex + 1);
    const VertexPairs borders{vertices, edges.size(),
                              [&](std::size_t i) -> std::optional<glm::uvec2> {
                                  const glm::uvec2 ends = contours.edges[i];
                                  if (edges[i].face_b != LA_NO_FACE || ends.x == ends.y) return {};
                                  return glm::uvec2{vertex(ends.x), vertex(ends.y)};
                              }};
    for (const Segment& segment : segments.first(segments.size() - faces.size())) {
        if (segment.face_a == LA_NO_FACE || segment.face_b == LA_NO_FACE) continue;
        if (std::max(segment.p, segment.q) >= vertices) continue;
        for (const VertexPairs::Item& item : borders.between(segment.p, segment.q)) {
            compute::ContourEdge& edge = edges[item.index];
            const std::uint32_t flipped = segment.face_b & LA_FACE_FLIPPED;
            const bool is_own = edge.face_a == segment.face_a;
            edge.face_b = is_own ? segment.face_b : segment.face_a | flipped;
        }
    }
    return edges;
}

std::vector<glm::uvec3> contour_corners(const Contours& contours) {
    std::vector<glm::uvec3> corners(contours.faces.size(), glm::uvec3{0});
    for_each_side(contours, [&](std::uint32_t face, std::uint32_t k, std::uint32_t side) {
        const glm::uvec2 ends = contours.edges[side & ~LA_CONTOUR_TURNED];
        corners[face][static_cast<int>(k)] = (side & LA_CONTOUR_TURNED) != 0 ? ends.y : ends.x;
    });
    return corners;
}

std::vector<compute::ContourFace> contour_faces(const Contours& contours) {
    constexpr std::uint32_t none = LA_NO_FACE;
    std::vector<compute::ContourFace> faces(contours.faces.size());
    std::vector<glm::uvec2> first_sides(contours.edges.size(), glm::uvec2{none}); // face, and
                                                                                  // number of the
                                                                                  // side
    for_each_side(contours, [&](std::uint32_t face, std::uint32_t k, std::uint32_t side) {
        faces[face].edges[k] = side;
        faces[face].across[k] = none;
        glm::uvec2& first = first_sides[side & ~LA_CONTOUR_TURNED];
        if (first.x == none) {
            first = {face, k};
        } else {
            faces[face].across[k] = first.x;
            faces[first.x].across[first.y] = face;
        }
    });
    return faces;
}

std::vector<std::uint32_t> contour_patches(const LineSet& lines,
                                           std::span<const Segment> segments) {
    const std::vector<glm::uvec3>& faces = lines.contours.faces;
    VertexSets sets{lines.contours.edges.size()};
    for (const glm::uvec3& face : faces) {
        for (int k = 1; k < 3; ++k)
            sets.unite(face[0] & ~LA_CONTOUR_TURNED, face[k] & ~LA_CONTOUR_TURNED);
    }
    std::vector<std::uint32_t> patches(lines.triangles.size(), LA_NO_SURFACE);
    const std::span own = segments.last(faces.size());
    for_each_side(lines.contours, [&](std::uint32_t face, std::uint32_t k, std::uint32_t side) {
        if (k == 0) patches[own[face].face_a] = sets.find(side & ~LA_CONTOUR_TURNED);
    });
    return patches;
}

std::optional<compute::ContourTables> LineTables::Chunk::contours(compute::Buffer* turned) const {
    if (!faces) return {};
    return compute::ContourTables{
        .corners = turned != nullptr ? turned : corners.get(),
        .edges = edges.get(),
        .face_corners = face_corners.get(),
        .faces = faces.get(),
        .patches = patches.get(),
        .edge_count = static_cast<std::uint32_t>(edges->size() / sizeof(compute::ContourEdge)),
        .face_count = static_cast<std::uint32_t>(faces->size() / sizeof(compute::ContourFace)),
        .replaced = replaced,
        .vertex_count = vertex_count};
}

std::uint32_t LineTables::Chunk::corner_count() const {
    return corners ? static_cast<std::uint32_t>(corners->size() / sizeof(ContourCorner)) : 0;
}

std::uint32_t LineTables::most_fixed_segments() const {
    std::uint32_t most = 1; // a table must not be empty
    for (const Chunk& chunk : chunks) most = std::max(most, chunk.candidates().first);
    return most;
}

std::vector<LineTables::Chunk>
upload_segments(compute::Device& device, std::span<const Segment> segments, const LineSet* lines) {
    // The widest table per segment decides. If it must be cut, the strokes and intervals of a chunk
    // should fit too. There are several per segment if all are partly visible.
    constexpr std::uint64_t runs_per_segment = 4;
    const std::uint64_t largest = device.largest_buffer();
    const bool has_contours = lines != nullptr && !lines->contours.empty() &&
                              has_room_for_contours(*lines, segments, largest);
    // Without contours no candidate stands for a triangle.
    if (lines != nullptr && !has_contours)
        segments = segments.first(segments.size() - lines->contours.faces.size());
    const bool is_whole = segments.size() <= largest / sizeof(ClippedSegment);
    std::vector<LineTables::Chunk> chunks;
    const std::vector<SegmentRange> ranges =
        is_whole ? cut_segments(segments, segments.size())
                 : cut_into_chunks(segments, largest / (runs_per_segment * sizeof(Run)), largest);
    for (const SegmentRange& range : ranges) {
        const std::span<const Segment> part = segments.subspan(range.first, range.count);
        const bool is_last = range.first + range.count == segments.size();
        chunks.push_back({range, compute::upload(device, part, compute::table::line_segments)});
        add_candidates(device, part, has_contours && is_last ? &lines->contours : nullptr,
                       chunks.back());
    }
    if (has_contours) add_contours(device, *lines, segments, chunks.back());
    return chunks;
}

LineSet download_contours(compute::Device& device, const LineTables& lines,
                          std::uint32_t triangle_count) {
    LineSet result;
    const LineTables::Chunk& chunk = lines.contour_chunk();
    const std::optional<compute::ContourTables> tables = chunk.contours();
    if (!tables) return result;
    result.vertices.resize(tables->vertex_count);
    result.triangles.resize(triangle_count);
    Contours& contours = result.contours;
    contours.corners =
        compute::read_back<ContourCorner>(device, *tables->corners, chunk.corner_count());
    contours.edges.resize(tables->edge_count);
    const auto corners =
        compute::read_back<glm::uvec3>(device, *tables->face_corners, tables->face_count);
    for (const compute::ContourFace& face :
         compute::read_back<compute::ContourFace>(device, *tables->faces, tables->face_count)) {
        const glm::uvec3 own = corners[contours.faces.size()];
        contours.faces.emplace_back(face.edges[0], face.edges[1], face.edges[2]);
        if (own.x == own.y) continue; // stands in empty room, see Assembly
        for (int k = 0; k < 3; ++k)
            if ((face.edges[k] & LA_CONTOUR_TURNED) == 0)
                contours.edges[face.edges[k]] = {own[k], own[(k + 1) % 3]};
    }
    contours.replaced = tables->replaced;
    return result;
}

std::vector<Segment> download_segments(compute::Device& device, const LineTables& lines) {
    std::vector<Segment> segments(lines.segment_count());
    for (const LineTables::Chunk& chunk : lines.chunks) {
        const auto part = std::span{segments}.subspan(chunk.range.first, chunk.range.count);
        device.download(*chunk.segments, std::as_writable_bytes(part));
    }
    return segments;
}

LineTables upload_lines(compute::Device& device, const LineSet& lines) {
    check_counts({lines.vertices.size(), lines.triangles.size(), lines.segments.size()});
    LineTables result{.vertices = compute::upload(device, lines.vertices, compute::table::vertices),
                      .triangles =
                          compute::upload(device, lines.triangles, compute::table::triangles),
                      .chunks = upload_segments(device, lines.segments, &lines)};
    if (!lines.contours.surfaces.empty() && result.contour_chunk().contours())
        result.tracer = std::make_shared<ContourTracer>(lines);
    return result;
}

} // namespace lineatlas
