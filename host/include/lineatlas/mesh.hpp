#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace lineatlas {

/// What a triangle belongs to. A mesh edge between two different groups is a material line.
struct MeshGroup {
    std::string object;   ///< OBJ `o`/`g` name; empty where the file names none
    std::string material; ///< OBJ `usemtl` name; empty where the file names none
    /// Diffuse colour as on the screen (sRGB-coded), each channel 0 to 1; nothing where none is
    /// known.
    std::optional<glm::vec3> color{};
};

/// An indexed triangle soup with optional polylines, as read from a file or built by a program.
///
/// Equal positions need not share an index: `weld()` (lines.hpp) merges them. Nothing is assumed
/// about manifoldness, orientation or closedness.
struct Mesh {
    std::vector<glm::vec3> positions;          ///< finite, in model units
    std::vector<glm::uvec3> triangles;         ///< indices into `positions`
    std::vector<std::uint32_t> triangle_group; ///< per triangle, index into `groups`; or empty
    std::vector<MeshGroup> groups;             ///< empty when `triangle_group` is empty
    std::vector<std::vector<std::uint32_t>> polylines; ///< lines given in the file (OBJ `l`)

    bool empty() const { return triangles.empty() && polylines.empty(); }
};

/// An axis-aligned box. A box that holds nothing has min > max.
struct Bounds {
    glm::vec3 min{std::numeric_limits<float>::infinity()};
    glm::vec3 max{-std::numeric_limits<float>::infinity()};
};

/// The box around the positions that triangles or polylines use.
Bounds bounds_of(const Mesh& mesh);

} // namespace lineatlas
