#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/lines.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Vertices where lines begin or end that run along no edge of the mesh.
class AddedVertices {
  public:
    /// The mesh must outlive this object. Only insert() changes it.
    explicit AddedVertices(WeldedMesh& mesh) : mesh_(mesh) {}

    /// A number for the vertex at `share` of the way between two vertices of the mesh, which are of
    /// one object. The same place has the same number.
    std::uint32_t at(std::uint32_t from, std::uint32_t to, double share);

    /// A number for a place that is on no edge. Its object and its source (LineSet::vertex_sources)
    /// are those of `vertex`.
    std::uint32_t beside(std::uint32_t vertex, glm::vec3 position);

    /// Puts the vertices into the mesh, each behind the vertices of its object. A vertex at the
    /// place of one of the mesh becomes that one. Returns the new number of every vertex; added
    /// vertices come last.
    std::vector<std::uint32_t> insert();

    /// The inserted vertices, by their new numbers.
    const std::vector<CutVertex>& cuts() const { return cuts_; }

  private:
    struct Place {
        glm::vec3 position;
        std::uint32_t object;
        bool operator==(const Place&) const = default;
    };
    struct PlaceHash {
        std::size_t operator()(const Place& place) const;
    };

    std::uint32_t object_of(std::uint32_t vertex) const;
    std::uint32_t add(const Place& place, const CutVertex& cut);

    WeldedMesh& mesh_;
    std::vector<Place> places_;
    std::vector<CutVertex> cuts_; ///< both ends are one vertex for a place on no edge
    std::unordered_map<Place, std::uint32_t, PlaceHash> known_; ///< into places_
};

} // namespace lineatlas
