#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lineatlas/io.hpp"

namespace lineatlas {

/// A part's name, preceded by the names of all parts that contain it.
struct PartPath {
    std::vector<std::string> names;

    /// "assembly/Bolt"
    std::string whole() const;
};

/// The parts of a model that have triangles or lines: those of its tree, or if it has no tree its
/// groups by name.
struct PartPaths {
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    std::vector<PartPath> paths;
    std::vector<std::uint32_t> of_triangle; ///< per triangle an index into `paths`
    std::vector<std::uint32_t> of_polyline; ///< per polyline an index into `paths`, or `none`
};
PartPaths part_paths(const LoadedMesh& loaded);

/// Removes parts from the mesh. `wanted`: per path of `paths` whether its part stays.
/// `loose_lines`: whether lines of no part stay. Positions stay as they are.
void keep_parts(Mesh& mesh, const PartPaths& paths, const std::vector<bool>& wanted,
                bool loose_lines);

} // namespace lineatlas
