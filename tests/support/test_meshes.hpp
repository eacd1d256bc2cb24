#pragma once

// Small meshes with known edges, for the tests of host/core.

#include <cstdint>
#include <random>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "lineatlas/mesh.hpp"

namespace lineatlas::test {

/// Random numbers that are the same on every machine and in every run.
class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}

    float between(float low, float high) {
        return low + (high - low) * static_cast<float>(engine_() / 4294967296.0);
    }
    std::uint32_t below(std::uint32_t limit) {
        return static_cast<std::uint32_t>(engine_() % limit);
    }
    bool coin() { return below(2) != 0; }
    /// A point in a cube of half-width `reach` around the origin.
    glm::vec3 point(float reach);
    glm::vec3 direction();
    /// Any rotation, then a move by up to `reach` along each axis.
    glm::mat4 placement(float reach);

  private:
    std::mt19937 engine_;
};

// Closed and oriented outwards.
Mesh cube();                                     ///< corners at +-1; 12 creases, 6 flat diagonals
Mesh tetrahedron();                              ///< 6 creases
Mesh sphere(int level);                          ///< an octahedron divided `level` times, radius 1
Mesh cylinder(std::uint32_t sides, bool capped); ///< radius 1, along y from -1 to 1

// Open.
Mesh open_strip(std::uint32_t quads); ///< flat, one row of unit squares
Mesh height_field(Random& random, std::uint32_t quads, float height); ///< quads x quads, rough
Mesh two_sided_quad(); ///< 4 triangles: both halves of the quad, once per side

/// Two triangles bent by `angle` radians along the y axis; `flipped`: the second one's winding
/// disagrees.
Mesh bent_pair(float angle, bool flipped);

/// A band of `quads` quads with a half twist, in which exactly one pair of triangles must disagree.
Mesh moebius_band(std::uint32_t quads);

/// Triangles around one common edge, the edge from vertex 0 to vertex 1.
Mesh faces_on_an_edge(std::uint32_t faces);

/// A T-junction closed by a sliver: the edge from vertex 0 to vertex 1 is whole on one side and
/// split at vertex 2 on the other, which is bent away by `angle`. Triangle 1 is the sliver.
Mesh split_edge(float angle);

/// Random triangles over few vertices, with non-manifold edges, any winding, repeated corners and
/// repeated faces.
Mesh random_soup(Random& random, std::uint32_t vertices, std::uint32_t triangles);

// The same mesh, changed.
Mesh moved(Mesh mesh, const glm::mat4& placement);
Mesh with_own_corners(const Mesh& mesh);                      ///< no two triangles share an index
Mesh with_random_windings(Mesh mesh, Random& random);         ///< every other triangle turned over
Mesh with_random_radii(Mesh mesh, Random& random, float low); ///< positions scaled by low to 1
Mesh with_random_groups(Mesh mesh, Random& random, std::uint32_t groups);

} // namespace lineatlas::test
