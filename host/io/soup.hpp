#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/loaded_mesh.hpp"

namespace lineatlas {

/// Polygons as a reader finds them, before any of them is judged.
struct Soup {
    std::vector<glm::dvec3> positions;     ///< may hold NaN and infinity
    glm::dvec3 origin{0};                  ///< the reader has already subtracted it from them
    std::vector<std::uint32_t> corners;    ///< of all faces, one after another
    std::vector<std::size_t> face_ends;    ///< per face, one past its last corner in `corners`
    std::vector<std::uint32_t> face_group; ///< per face, or empty
    std::vector<MeshGroup> groups;
    std::vector<std::vector<std::uint32_t>> polylines;
    std::vector<std::uint32_t> face_object{};     ///< per face, or empty
    std::vector<std::uint32_t> polyline_object{}; ///< per polyline, or empty
    std::vector<KnownEdge> known_edges{};
    std::vector<std::optional<EdgeCurve>> edge_curves{}; ///< as in Mesh::edge_curves
    std::vector<std::uint32_t> edge_entities{};          ///< as in Mesh::edge_entities
    std::vector<glm::vec3>
        corner_normals{};     ///< three per face if all faces are triangles, or empty
    KnownSurfaces surfaces{}; ///< one per face if all faces are triangles, or empty
    std::vector<ModelPart> parts{};
    std::string format{};
    std::optional<glm::vec3> up{};
    std::optional<double> unit{}; ///< millimetres
    double deflection = 0;        ///< as in LoadedMesh::deflection
    double precision = 0;         ///< as in Mesh::precision
    std::vector<std::string> notes;
    std::size_t not_finite_faces = 0; ///< faces that the reader has already left out

    void add_face(std::span<const std::uint32_t> face) {
        corners.insert(corners.end(), face.begin(), face.end());
        end_face();
    }
    /// Makes a face of the corners that have been appended since the last one.
    void end_face() { face_ends.push_back(corners.size()); }
};

/// Judges and triangulates. Drops what cannot be drawn with a note each; throws FileError for
/// indices out of range, for a file most of whose faces are not finite, and for one that holds
/// nothing to draw.
LoadedMesh finish(Soup&& soup, const std::string& path);

} // namespace lineatlas
