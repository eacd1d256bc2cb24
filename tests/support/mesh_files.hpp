#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

// Meshes written as files of every type, with anything wrong that a test asks for.
namespace lineatlas::test {

struct Model {
    std::vector<std::array<double, 3>> points;
    std::vector<std::vector<long long>> faces;

    Model moved(double scale, std::array<double, 3> origin) const;
};

/// A cube with a small block on it, of quads.
Model block_on_cube();
/// The same, of triangles.
Model triangles_of(const Model& model);

/// Values that are written in place of the true ones.
struct Lies {
    std::string vertices{}, faces{}; ///< counts, as text; empty: the truth
    std::string coordinate{};        ///< the first one
    std::string index{};             ///< the first one; in OBJ counted from 1 as well
};

struct MeshType {
    std::string name, extension;
    bool binary = false;
    bool counts = true; ///< the type tells the numbers of vertices and faces
    bool exact = false; ///< the type has more digits than a float
    std::function<std::string(const Model&, const Lies&)> write;
};

/// Every type, text and binary. Types of triangles get triangles.
std::vector<MeshType> mesh_types();

} // namespace lineatlas::test
