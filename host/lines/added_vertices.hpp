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
    /// The mesh must outlive it, and is changed by insert() alone.
    explicit AddedVertices(WeldedMesh& mesh) : mesh_(mesh) {}

    /// A number for the vertex at `share` of the way between two of the mesh, which are of one
    /// object; the same for the same place.
    std::uint32_t at(std::uint32_t from, std::uint32_t to, double share);

    /// A number for a place that is on no edge, in the object of a vertex of the mesh: it comes
    /// from where that does (LineSet::vertex_sources).
    std::uint32_t beside(std::uint32_t vertex, glm::vec3 position);

    /// Puts them into the mesh, each behind the vertices of its object; one that lies where the
    /// mesh has a vertex becomes that. Returns the new number of every vertex, those added last.
    std::vector<std::uint32_t> insert();

    /// What was inserted, by its new numbers.
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
    std::vector<CutVertex> cuts_; ///< of a place on no edge both ends are one
    std::unordered_map<Place, std::uint32_t, PlaceHash> known_; ///< into places_
};

} // namespace lineatlas
