#include "check_lines.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

std::string numbered(const char* what, std::size_t number) {
    return std::string{what} + " " + std::to_string(number);
}

[[noreturn]] void refuse(const std::string& what) {
    throw UsageError("line set: " + what);
}

/// Throws if an index that "`of` `place`" holds names none of `count` things.
void check_index(std::size_t index, std::size_t count, const char* things, const char* of,
                 std::size_t place) {
    if (index < count) return;
    refuse(numbered(of, place) + " has the index " + std::to_string(index) + ", but there are " +
           std::to_string(count) + " " + things);
}

void check_size(std::size_t size, std::size_t wanted, const char* table, const char* things) {
    if (size == 0 || size == wanted) return;
    refuse("there are " + std::to_string(wanted) + " " + things + ", but " + table + " has " +
           std::to_string(size) + " values");
}

void check_vertices(const LineSet& lines) {
    const auto is_finite = [](const glm::vec3& v) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    const auto wrong = std::ranges::find_if_not(lines.vertices, is_finite);
    if (wrong == lines.vertices.end()) return;
    refuse(numbered("vertex", static_cast<std::size_t>(wrong - lines.vertices.begin())) +
           " is not finite");
}

void check_triangles(const LineSet& lines) {
    const std::size_t vertices = lines.vertices.size(), triangles = lines.triangles.size();
    for (std::size_t i = 0; i < triangles; ++i) {
        const glm::uvec3 t = lines.triangles[i];
        check_index(std::max({t.x, t.y, t.z}), vertices, "vertices", "triangle", i);
    }
    check_size(lines.triangle_color.size(), triangles, "triangle_color", "triangles");
    for (std::size_t i = 0; i < lines.triangle_color.size(); ++i) {
        if (lines.triangle_color[i] != LineSet::no_color)
            check_index(lines.triangle_color[i], lines.colors.size(), "colors", "triangle_color",
                        i);
    }
    check_size(lines.triangle_group.size(), triangles, "triangle_group", "triangles");
    for (std::size_t i = 0; i < lines.triangle_group.size(); ++i)
        check_index(lines.triangle_group[i], lines.groups.size(), "groups", "triangle_group", i);
}

/// Checks that the segments of a path are neighbours and count each other.
void check_path(const LineSet& lines, std::size_t i) {
    const Segment& segment = lines.segments[i];
    const bool is_last = i + 1 == lines.segments.size();
    const std::uint32_t after = is_last ? 0 : lines.segments[i + 1].from_start;
    const bool is_first = i == 0 && segment.from_start != 0;
    const bool goes_on = segment.to_end > 0 && !is_last;
    const bool agrees = goes_on ? after == segment.from_start + 1 &&
                                      lines.segments[i + 1].to_end == segment.to_end - 1
                                : segment.to_end == 0 && after == 0;
    if (is_first || !agrees)
        refuse(numbered("segment", i) + " has other neighbours than from_start and to_end say");
}

void check_segments(const LineSet& lines) {
    const std::size_t vertices = lines.vertices.size(), triangles = lines.triangles.size();
    for (std::size_t i = 0; i < lines.segments.size(); ++i) {
        const Segment& segment = lines.segments[i];
        check_index(std::max(segment.p, segment.q), vertices, "vertices", "segment", i);
        for (const std::uint32_t face : {segment.face_a, segment.face_b}) {
            if (face != LA_NO_FACE)
                check_index(face & LA_FACE_INDEX, triangles, "triangles", "segment", i);
        }
        check_path(lines, i);
    }
}

void check_contours(const LineSet& lines) {
    const Contours& contours = lines.contours;
    const std::size_t silhouettes = contours.faces.size() + contours.replaced;
    if (silhouettes > lines.segments.size())
        refuse("contours stand for " + std::to_string(silhouettes) + " segments, but there are " +
               std::to_string(lines.segments.size()));
    for (std::size_t i = lines.segments.size() - silhouettes; i < lines.segments.size(); ++i) {
        const Segment& segment = lines.segments[i];
        if ((segment.tag & LA_TAG_KIND_MASK) != LA_KIND_SILHOUETTE || segment.to_end != 0 ||
            segment.from_start != 0 || segment.face_a == LA_NO_FACE || segment.face_b == LA_NO_FACE)
            refuse(numbered("segment", i) +
                   " stands for a contour, but is no silhouette between two triangles");
    }
    for (std::size_t i = 0; i < contours.corners.size(); ++i)
        check_index(contours.corners[i].vertex, lines.vertices.size(), "vertices", "corner", i);
    for (std::size_t i = 0; i < contours.edges.size(); ++i) {
        const glm::uvec2 edge = contours.edges[i];
        check_index(std::max(edge.x, edge.y), contours.corners.size(), "corners", "edge", i);
    }
    for (std::size_t i = 0; i < contours.faces.size(); ++i) {
        const glm::uvec3 edges = contours.faces[i] & ~LA_CONTOUR_TURNED;
        check_index(std::max({edges.x, edges.y, edges.z}), contours.edges.size(), "edges", "face",
                    i);
    }
}

void check_objects(const LineSet& lines) {
    const std::size_t vertices = lines.vertices.size();
    for (std::size_t i = 0; i < lines.objects.size(); ++i) {
        const LineObject& object = lines.objects[i];
        if (std::size_t{object.first_vertex} + object.vertex_count > vertices)
            refuse(numbered("object", i) + " has vertices up to " +
                   std::to_string(std::size_t{object.first_vertex} + object.vertex_count) +
                   ", but there are " + std::to_string(vertices));
    }
    for (std::size_t i = 0; i < lines.cut_vertices.size(); ++i) {
        const CutVertex& cut = lines.cut_vertices[i];
        check_index(std::max({cut.vertex, cut.from, cut.to}), vertices, "vertices", "cut vertex",
                    i);
    }
}

} // namespace

void check_lines(const LineSet& lines) {
    check_vertices(lines);
    check_triangles(lines);
    check_segments(lines);
    check_contours(lines);
    check_objects(lines);
}

} // namespace lineatlas
