#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "edges.hpp"
#include "intersections.hpp"
#include "lineatlas/lines.hpp"
#include "parts.hpp"
#include "seams.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Numbered things, such as triangles, grouped by island. Numbers of an island ascend.
class OfIslands {
  public:
    OfIslands() = default;
    /// `island`: that of each thing.
    OfIslands(std::size_t islands, const std::vector<std::uint32_t>& island);

    std::span<const std::uint32_t> operator[](std::size_t island) const {
        return std::span{things_}.subspan(first_[island], first_[island + 1] - first_[island]);
    }
    /// The place of a thing among those of its island.
    std::uint32_t place(std::uint32_t thing) const { return places_[thing]; }

  private:
    std::vector<std::uint32_t> first_, things_, places_;
};

/// The material, body and object of each triangle. They decide which lines are found between parts.
struct TriangleOwners {
    std::span<const std::uint32_t> materials; ///< materials_of()
    std::span<const std::uint32_t> bodies;    ///< bodies_of()
    std::span<const std::uint32_t> objects;   ///< objects_of(); may be empty
};

/// Islands of a model: sets of parts that may touch each other and touch no other part. Seams,
/// intersections and buried triangles never lie between two islands. So they are found once for
/// islands that are copies of each other, such as the machines of a hall.
///
/// An island is a copy of an earlier one if three conditions hold. It has the same triangles and
/// edges in the same order. Distances between its corners are equal but for the rounding of floats.
/// The same triangles are of one material and of one body. It may be turned, but not mirrored or
/// scaled. Islands with polylines are no copies, nor are islands that are hardly wider than a line.
class Islands {
  public:
    /// `reach`: parts whose boxes are no farther apart are of one island. `mesh`, `edges` and what
    /// `owners` names must outlive this object.
    Islands(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges, const MeshParts& parts,
            const TriangleOwners& owners, double reach);

    bool has_copies() const { return !copies_.empty(); }

    /// Drops copies whose edges are of other kinds than those of their originals. Returns true if
    /// there were any.
    bool tell_apart(std::span<const std::optional<LineKind>> kinds);

    bool is_copy(std::uint32_t vertex) const {
        return has_copies() && is_copy_[island_of_vertex_[vertex]];
    }
    /// Per triangle, per edge whether it is of a copy. Empty if there are no copies.
    std::vector<bool> copied_triangles() const;
    std::vector<bool> copied_edges() const;

    /// Adds the same for copies to what was found at their originals.
    void add_copies(Seams& seams) const;
    void add_copies(std::vector<Intersection>& intersections) const;

  private:
    /// An island, and the one that it is a copy of.
    struct Copy {
        std::uint32_t original, island;
    };
    struct Size {
        std::uint32_t vertices = 0, triangles = 0, edges = 0;
        auto operator<=>(const Size&) const = default;
    };
    /// Three vertices that lie far from each other, by their places.
    using Corners = std::array<std::uint32_t, 3>;
    struct Frame {
        glm::dvec3 origin;
        glm::dmat3 axes; ///< orthonormal and right-handed
        glm::dvec3 at(glm::dvec3 point) const { return (point - origin) * axes; }
    };

    std::uint32_t find_islands(const MeshParts& parts, double reach);
    std::vector<Size> sizes(std::uint32_t count) const;
    void list_things(std::uint32_t count);
    void find_copies(std::vector<std::uint32_t> alike);
    bool are_same(std::uint32_t original, std::uint32_t island) const;
    bool have_same_triangles(std::uint32_t original, std::uint32_t island) const;
    bool have_same_edges(std::uint32_t original, std::uint32_t island) const;
    bool have_same_owners(std::span<const std::uint32_t> owners, std::uint32_t original,
                          std::uint32_t island) const;
    Corners far_corners(std::uint32_t island) const;
    std::optional<Frame> frame_of(std::uint32_t island, const Corners& corners) const;
    bool have_same_shape(const Corners& corners, std::uint32_t original,
                         std::uint32_t island) const;
    glm::dvec3 at(std::uint32_t island, std::uint32_t place) const {
        return mesh_.vertices[vertices_[island][place]];
    }
    void mark_copies();
    Intersection in_copy(const Intersection& one, std::uint32_t island) const;
    EdgePlace in_copy(const EdgePlace& place, std::uint32_t island) const;

    const WeldedMesh& mesh_;
    const std::vector<MeshEdge>& mesh_edges_;
    TriangleOwners owners_;
    double rounding_ = 0; ///< of a distance between two vertices
    std::vector<std::uint32_t> island_of_vertex_;
    OfIslands vertices_, triangles_, edges_;
    std::vector<Copy> copies_; ///< by island, ascending
    std::vector<bool> is_copy_;
};

} // namespace lineatlas
