#include "soup.hpp"

#include <algorithm>
#include <cmath>

#include "base/exact_bounds.hpp"
#include "polygon/polygon.hpp"
#include "source_file.hpp"

namespace lineatlas {

namespace {

// These stand in place of the index of a position that cannot be drawn.
constexpr std::uint32_t not_finite = 0xFFFFFFFFU;
constexpr std::uint32_t too_large = 0xFFFFFFFEU;

bool is_dropped(std::uint32_t index) {
    return index >= too_large;
}

struct FaceCounts {
    std::size_t faces = 0;
    std::size_t few_corners = 0;
    std::size_t repeated = 0;
    std::size_t not_finite = 0;
    std::size_t too_large = 0;
};

constexpr std::string_view why_not_finite = "with coordinates that are no finite numbers";
constexpr std::string_view why_too_large = "with coordinates beyond 1e15";

void check_indices(const Soup& soup, const std::string& path) {
    const auto vertices = soup.positions.size();
    const auto bad = std::find_if(soup.corners.begin(), soup.corners.end(),
                                  [&](std::uint32_t index) { return index >= vertices; });
    if (bad == soup.corners.end()) return;
    const auto place = static_cast<std::size_t>(bad - soup.corners.begin());
    const auto face = std::upper_bound(soup.face_ends.begin(), soup.face_ends.end(), place);
    throw read_error(path, "face " + std::to_string(face - soup.face_ends.begin()) +
                               " refers to vertex " + std::to_string(*bad) + ", the file has " +
                               counted(vertices, "vertex", "vertices") + " from 0");
}

/// The box of all positions that are used and can be drawn.
ExactBounds bounds_of(const Soup& soup) {
    ExactBounds bounds;
    bounds.add_drawable(soup.positions, soup.corners);
    for (const auto& polyline : soup.polylines) bounds.add_drawable(soup.positions, polyline);
    return bounds;
}

/// Keeps the positions that can be drawn, relative to `origin`. Returns the new index of each.
std::vector<std::uint32_t> keep_drawable(const Soup& soup, glm::dvec3 origin,
                                         std::vector<glm::vec3>& positions) {
    std::vector<std::uint32_t> moved;
    moved.reserve(soup.positions.size());
    positions.reserve(soup.positions.size());
    for (const glm::dvec3& position : soup.positions) {
        if (is_drawable(position)) {
            moved.push_back(static_cast<std::uint32_t>(positions.size()));
            positions.emplace_back(position - origin);
        } else {
            moved.push_back(is_finite(position) ? too_large : not_finite);
        }
    }
    return moved;
}

/// Merges equal neighbours: a quad exported with one corner twice is a triangle. Repeats that are
/// not neighbours stay, because a hole that is joined to its outline by a bridge has them.
void merge_repeats(std::vector<std::uint32_t>& face) {
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
}

FaceCounts triangulate_faces(const Soup& soup, const std::vector<std::uint32_t>& moved,
                             Mesh& mesh) {
    FaceCounts counts{.faces = soup.face_ends.size()};
    mesh.triangles.reserve(soup.corners.size() > 2 * counts.faces
                               ? soup.corners.size() - 2 * counts.faces
                               : counts.faces);
    std::vector<std::uint32_t> face;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < counts.faces; ++i) {
        const std::size_t end = soup.face_ends[i];
        face.clear();
        for (std::size_t c = begin; c < end; ++c) face.push_back(moved[soup.corners[c]]);
        begin = end;
        if (const auto bad = std::ranges::find_if(face, is_dropped); bad != face.end()) {
            ++(*bad == not_finite ? counts.not_finite : counts.too_large);
            continue;
        }
        if (face.size() < 3) {
            ++counts.few_corners;
            continue;
        }
        merge_repeats(face);
        if (face.size() < 3) {
            ++counts.repeated;
            continue;
        }
        const std::size_t before = mesh.triangles.size();
        triangulate(mesh.positions, face, mesh.triangles);
        if (mesh.triangles.size() == before) ++counts.repeated;
        if (!soup.face_group.empty())
            mesh.triangle_group.resize(mesh.triangles.size(), soup.face_group[i]);
        if (!soup.face_object.empty())
            mesh.triangle_object.resize(mesh.triangles.size(), soup.face_object[i]);
        if (!soup.corner_normals.empty() && mesh.triangles.size() > before)
            mesh.corner_normals.insert(mesh.corner_normals.end(), &soup.corner_normals[3 * i],
                                       &soup.corner_normals[3 * i] + 3);
        if (!soup.surfaces.empty() && mesh.triangles.size() > before)
            mesh.surfaces.add_triangle(soup.surfaces.of_triangle[i], soup.surfaces.parameters[i]);
    }
    return counts;
}

std::size_t keep_polylines(Soup& soup, const std::vector<std::uint32_t>& moved, Mesh& mesh) {
    std::size_t lost = 0;
    for (std::size_t i = 0; i < soup.polylines.size(); ++i) {
        std::vector<std::uint32_t>& line = soup.polylines[i];
        for (std::uint32_t& index : line) index = moved[index];
        if (std::ranges::any_of(line, is_dropped)) {
            ++lost;
            continue;
        }
        line.erase(std::unique(line.begin(), line.end()), line.end());
        if (line.size() < 2) {
            ++lost;
            continue;
        }
        mesh.polylines.push_back(std::move(line));
        if (!soup.polyline_object.empty()) mesh.polyline_object.push_back(soup.polyline_object[i]);
    }
    return lost;
}

void keep_known_edges(const Soup& soup, const std::vector<std::uint32_t>& moved, Mesh& mesh) {
    for (const KnownEdge& edge : soup.known_edges) {
        const std::uint32_t from = moved[edge.from], to = moved[edge.to];
        if (!is_dropped(from) && !is_dropped(to))
            mesh.known_edges.push_back({from, to, edge.kind, edge.edge});
    }
}

/// Leaves out groups without triangles, so that a file with one `o` and no `usemtl` before its
/// first face gets no nameless group beside the real one.
void keep_used_groups(const std::vector<MeshGroup>& groups, Mesh& mesh) {
    constexpr std::uint32_t unknown = 0xFFFFFFFFU;
    std::vector<std::uint32_t> moved(groups.size(), unknown);
    for (std::uint32_t& group : mesh.triangle_group) {
        if (moved[group] == unknown) {
            moved[group] = static_cast<std::uint32_t>(mesh.groups.size());
            mesh.groups.push_back(groups[group]);
        }
        group = moved[group];
    }
}

void refuse_if_most_are_bad(const FaceCounts& counts, const std::string& path) {
    if (2 * (counts.not_finite + counts.too_large) <= counts.faces) return;
    const bool large = counts.too_large > counts.not_finite;
    throw read_error(
        path, std::to_string(large ? counts.too_large : counts.not_finite) + " of " +
                  counted(counts.faces, "face", "faces") + " have coordinates " +
                  (large ? "beyond 1e15; scale the model down" : "that are no finite numbers"));
}

void refuse_if_too_small(const ExactBounds& bounds, const std::string& path) {
    const double extent = bounds.extent();
    if (extent == 0.0) throw read_error(path, "all of its corners are at one place");
    if (extent < smallest_extent)
        throw read_error(path, "it is smaller than 1e-20; scale the model up");
}

void add_notes(LoadedMesh& loaded, const FaceCounts& counts, std::size_t lost_lines) {
    const auto note = [&](std::size_t count, std::string_view what) {
        if (count > 0)
            loaded.notes.push_back(counted(count, "face", "faces") + ' ' + std::string(what) +
                                   " dropped");
    };
    note(counts.few_corners, "with fewer than 3 corners");
    note(counts.repeated, "with equal corners");
    note(counts.not_finite, why_not_finite);
    note(counts.too_large, why_too_large);
    if (lost_lines > 0)
        loaded.notes.push_back(
            counted(lost_lines, "line", "lines") +
            " without length or with coordinates that are no finite numbers dropped");
    if (loaded.origin != glm::dvec3{0}) loaded.notes.push_back(note_of_origin(loaded.origin));
}

std::string why_empty(const Soup& soup, const FaceCounts& counts,
                      const std::vector<std::string>& notes) {
    if (soup.positions.empty() && counts.not_finite == 0) return "it holds no vertex and no face";
    if (counts.faces == 0 && soup.polylines.empty())
        return "it holds points only, no face and no line";
    std::string why = "nothing in it can be drawn";
    for (const std::string& note : notes) why += (&note == notes.data() ? ": " : "; ") + note;
    return why;
}

} // namespace

LoadedMesh finish(Soup&& soup, const std::string& path) {
    check_indices(soup, path);

    LoadedMesh loaded{.mesh = {}, .notes = std::move(soup.notes)};
    Mesh& mesh = loaded.mesh;
    const ExactBounds bounds = bounds_of(soup);
    const glm::dvec3 origin = origin_for(bounds);
    loaded.origin = soup.origin + origin;
    const std::vector<std::uint32_t> moved = keep_drawable(soup, origin, mesh.positions);

    FaceCounts counts = triangulate_faces(soup, moved, mesh);
    counts.faces += soup.not_finite_faces;
    counts.not_finite += soup.not_finite_faces;
    refuse_if_most_are_bad(counts, path);
    const std::size_t lost_lines = keep_polylines(soup, moved, mesh);
    keep_known_edges(soup, moved, mesh);
    mesh.edge_curves = std::move(soup.edge_curves);
    mesh.edge_entities = std::move(soup.edge_entities);
    for (std::optional<EdgeCurve>& curve : mesh.edge_curves)
        if (curve) curve->center -= origin;
    mesh.surfaces.shapes = std::move(soup.surfaces.shapes);
    mesh.surfaces.surfaces = std::move(soup.surfaces.surfaces);
    for (PlacedSurface& surface : mesh.surfaces.surfaces) surface.model_from_shape[3] -= origin;
    loaded.format = std::move(soup.format);
    loaded.up = soup.up;
    loaded.unit = soup.unit;
    loaded.deflection = soup.deflection;
    mesh.precision = static_cast<float>(soup.precision);
    loaded.parts = std::move(soup.parts);
    add_notes(loaded, counts, lost_lines);
    if (mesh.empty()) throw read_error(path, why_empty(soup, counts, loaded.notes));
    refuse_if_too_small(bounds, path);
    keep_used_groups(soup.groups, mesh);
    return loaded;
}

} // namespace lineatlas
