#include "objects_apart.hpp"

#include <algorithm>
#include <span>

namespace lineatlas {
namespace {

std::uint32_t count_of(std::size_t size) {
    return static_cast<std::uint32_t>(size);
}

template <class T>
std::span<const T> in(const std::vector<T>& table, std::uint32_t first, std::uint32_t count) {
    return std::span{table}.subspan(first, count);
}

/// Gives every contour to its part. object_of: per vertex.
void take_apart(const LineSet& lines, std::span<const std::uint32_t> object_of,
                std::vector<LineSet>& parts) {
    const Contours& all = lines.contours;
    std::vector<std::uint32_t> corner_number, edge_number; // within their part
    const auto object_at = [&](std::uint32_t corner) {
        return object_of[all.corners[corner].vertex];
    };
    for (ContourCorner corner : all.corners) {
        const std::uint32_t object = object_of[corner.vertex];
        corner_number.push_back(count_of(parts[object].contours.corners.size()));
        corner.vertex -= lines.objects[object].first_vertex;
        parts[object].contours.corners.push_back(corner);
    }
    for (const glm::uvec2 edge : all.edges) {
        Contours& own = parts[object_at(edge.x)].contours;
        edge_number.push_back(count_of(own.edges.size()));
        own.edges.emplace_back(corner_number[edge.x], corner_number[edge.y]);
    }
    for (glm::uvec3 face : all.faces) {
        Contours& own = parts[object_at(all.edges[face.x & ~LA_CONTOUR_TURNED].x)].contours;
        for (int k = 0; k < 3; ++k)
            face[k] = edge_number[face[k] & ~LA_CONTOUR_TURNED] | (face[k] & LA_CONTOUR_TURNED);
        own.faces.push_back(face);
    }
    const std::size_t first = lines.segments.size() - all.faces.size() - all.replaced;
    for (const Segment& segment : std::span{lines.segments}.subspan(first, all.replaced))
        ++parts[object_of[segment.p]].contours.replaced;
}

} // namespace

std::vector<LineSet> objects_apart(const LineSet& lines) {
    std::vector<LineSet> parts(lines.objects.size());
    std::vector<std::uint32_t> object_of(lines.vertices.size());
    std::vector<std::uint32_t> number_of(lines.triangles.size()); // within its object
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const LineObject& object = lines.objects[i];
        const std::span vertices = in(lines.vertices, object.first_vertex, object.vertex_count);
        std::ranges::fill(std::span{object_of}.subspan(object.first_vertex, object.vertex_count),
                          count_of(i));
        LineSet& part = parts[i];
        part.objects = {{object.name, 0, object.vertex_count}};
        part.vertices.assign(vertices.begin(), vertices.end());
        const std::span sources =
            in(lines.vertex_sources, object.first_vertex, object.vertex_count);
        part.vertex_sources.assign(sources.begin(), sources.end());
        part.groups = lines.groups;
        part.colors = lines.colors;
    }
    for (std::uint32_t i = 0; i < lines.triangles.size(); ++i) {
        const std::uint32_t object = object_of[lines.triangles[i].x];
        LineSet& part = parts[object];
        number_of[i] = count_of(part.triangles.size());
        part.triangles.push_back(lines.triangles[i] - lines.objects[object].first_vertex);
        part.triangle_sources.push_back(lines.triangle_sources[i]);
        if (!lines.triangle_group.empty()) part.triangle_group.push_back(lines.triangle_group[i]);
        if (!lines.triangle_color.empty()) part.triangle_color.push_back(lines.triangle_color[i]);
    }
    const auto renumbered = [&](std::uint32_t face) {
        return face == LA_NO_FACE ? face
                                  : number_of[face & LA_FACE_INDEX] | (face & LA_FACE_FLIPPED);
    };
    for (std::uint32_t i = 0; i < lines.segments.size(); ++i) {
        Segment segment = lines.segments[i];
        const std::uint32_t object = object_of[segment.p];
        segment.p -= lines.objects[object].first_vertex;
        segment.q -= lines.objects[object].first_vertex;
        segment.face_a = renumbered(segment.face_a);
        segment.face_b = renumbered(segment.face_b);
        parts[object].segments.push_back(segment);
        parts[object].sources.push_back(lines.sources[i]);
    }
    take_apart(lines, object_of, parts);
    return parts;
}

} // namespace lineatlas
