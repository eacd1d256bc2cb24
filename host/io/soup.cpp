#include "soup.hpp"

#include <algorithm>
#include <cmath>

#include "polygon.hpp"
#include "source_file.hpp"

namespace lineatlas {

namespace {

constexpr std::uint32_t dropped = 0xFFFFFFFFU;

bool is_finite(const glm::vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

struct FaceCounts {
    std::size_t faces = 0;
    std::size_t few_corners = 0;
    std::size_t repeated = 0;
    std::size_t not_finite = 0;
};

void check_indices(const Soup& soup, const std::filesystem::path& path) {
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

/// Moves the finite positions together and returns where each one went.
std::vector<std::uint32_t> keep_finite(std::vector<glm::vec3>& positions) {
    std::vector<std::uint32_t> moved(positions.size(), dropped);
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!is_finite(positions[i])) continue;
        positions[kept] = positions[i];
        moved[i] = kept++;
    }
    positions.resize(kept);
    return moved;
}

/// A quad exported with one corner twice is a triangle; repeats that are no neighbours stay, since
/// a hole joined to its outline by a bridge has them.
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
        if (std::find(face.begin(), face.end(), dropped) != face.end()) {
            ++counts.not_finite;
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
    }
    return counts;
}

std::size_t keep_polylines(Soup& soup, const std::vector<std::uint32_t>& moved, Mesh& mesh) {
    std::size_t lost = 0;
    for (std::vector<std::uint32_t>& line : soup.polylines) {
        for (std::uint32_t& index : line) index = moved[index];
        if (std::find(line.begin(), line.end(), dropped) != line.end()) {
            ++lost;
            continue;
        }
        line.erase(std::unique(line.begin(), line.end()), line.end());
        if (line.size() < 2)
            ++lost;
        else
            mesh.polylines.push_back(std::move(line));
    }
    return lost;
}

/// Groups that no triangle is in are left out, so that a file with one `o` and no `usemtl` before
/// its first face does not get a nameless group beside the real one.
void keep_used_groups(const std::vector<MeshGroup>& groups, Mesh& mesh) {
    std::vector<std::uint32_t> moved(groups.size(), dropped);
    for (std::uint32_t& group : mesh.triangle_group) {
        if (moved[group] == dropped) {
            moved[group] = static_cast<std::uint32_t>(mesh.groups.size());
            mesh.groups.push_back(groups[group]);
        }
        group = moved[group];
    }
}

std::string why_empty(const FaceCounts& counts, const Soup& soup) {
    if (soup.positions.empty() && counts.not_finite == 0) return "it holds no vertex and no face";
    if (counts.faces == 0 && soup.polylines.empty())
        return "it holds points only, no face and no line";
    return "none of its " + counted(counts.faces + soup.polylines.size(), "element", "elements") +
           " can be drawn: corners are too few or equal";
}

} // namespace

LoadedMesh finish(Soup&& soup, const std::filesystem::path& path) {
    check_indices(soup, path);

    LoadedMesh loaded{.mesh = {}, .notes = std::move(soup.notes)};
    Mesh& mesh = loaded.mesh;
    const std::vector<std::uint32_t> moved = keep_finite(soup.positions);
    mesh.positions = std::move(soup.positions);

    FaceCounts counts = triangulate_faces(soup, moved, mesh);
    counts.faces += soup.not_finite_faces;
    counts.not_finite += soup.not_finite_faces;
    if (2 * counts.not_finite > counts.faces)
        throw read_error(path, std::to_string(counts.not_finite) + " of " +
                                   counted(counts.faces, "face", "faces") +
                                   " have coordinates that are no finite numbers");
    const std::size_t lost_lines = keep_polylines(soup, moved, mesh);
    if (mesh.empty()) {
        soup.positions = std::move(mesh.positions);
        throw read_error(path, why_empty(counts, soup));
    }
    keep_used_groups(soup.groups, mesh);

    const auto note = [&](std::size_t count, std::string_view what) {
        if (count > 0)
            loaded.notes.push_back(counted(count, "face", "faces") + ' ' + std::string(what) +
                                   " dropped");
    };
    note(counts.few_corners, "with fewer than 3 corners");
    note(counts.repeated, "with equal corners");
    note(counts.not_finite, "with coordinates that are no finite numbers");
    if (lost_lines > 0)
        loaded.notes.push_back(
            counted(lost_lines, "line", "lines") +
            " without length or with coordinates that are no finite numbers dropped");
    return loaded;
}

} // namespace lineatlas
