#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/mesh.hpp"

/// @file
/// The content of a model's file.
/// @code{.cpp}
/// const LoadedMesh model = load_mesh("gearbox.step");
/// for (const ModelPart& part : model.parts) std::cout << part.name << '\n';
/// @endcode

namespace lineatlas {

/// A part of a model: a node of a glTF scene, or an instance in an assembly.
struct ModelPart {
    static constexpr std::uint32_t none = 0xFFFFFFFF; ///< there is none
    std::string name;            ///< its name in the file; if it has none, another name that the
                                 ///< file gives it
    std::uint32_t parent = none; ///< index of the part that contains it, less than its own; none:
                                 ///< no part
    /// Its number in Mesh::triangle_object and Mesh::polyline_object; none: it only holds others.
    std::uint32_t object = none;
    std::uint32_t shape = none; ///< an equal number for instances of the same shape
};

/// A mesh from a file, with notes on what was repaired or dropped.
struct LoadedMesh {
    Mesh mesh; ///< the contents of the file; indices are in range, positions finite
    std::vector<std::string>
        notes; ///< one line each, e.g. "12 faces with fewer than 3 corners dropped"
    /// The origin that was subtracted from every position. Zero, unless the model lies so far from
    /// zero, compared with its size, that floats could not hold its details.
    glm::dvec3 origin{0};
    std::string format{};           ///< "glTF 2.0", "STEP AP214", "OBJ"
    std::optional<glm::vec3> up{};  ///< the upward axis, if the format or the file says it
    std::optional<double> unit{};   ///< millimetres in one unit of length, if the file says it
    std::vector<ModelPart> parts{}; ///< a tree in the order of the file; empty if the file has no
                                    ///< parts
    /// For STEP, IGES and BREP LoadOptions::deflection, as it was given or computed; else 0.
    double deflection = 0;
};

} // namespace lineatlas
