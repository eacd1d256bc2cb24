#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/mesh.hpp"

/// @file
/// Meshes cut by planes, closed and hatched.
/// @code{.cpp}
/// const SectionPlane plane = parse_section("+x=50%", bounds_of(mesh));
/// const Section half = cut_mesh(mesh, {{plane}}, {.angle = 30});
/// const LineSet its_lines = extract_lines(half.mesh);
/// @endcode

namespace lineatlas {

/// A plane that cuts a model.
struct SectionPlane {
    glm::dvec3 point{0};        ///< a point on the plane
    glm::dvec3 normal{0, 0, 1}; ///< of any length; the side that it points to is cut away
    bool side_is_given = true;  ///< false: the side towards the eye is cut away, if there is an eye
    std::string name{};         ///< the plane as the user wrote it, for messages
};

/// A plane from its text: an axis and a position, "z=0.3" or "x=50%" (a share of `bounds`, from its
/// least coordinate), or a point and a normal, "1,2,3/0,0,1". "+z=0.3" cuts away larger
/// coordinates, "-z=0.3" smaller ones. With "z=0.3" the side is not given. Throws UsageError.
LINEATLAS_API SectionPlane parse_section(std::string_view text, const Bounds& bounds);

/// How the faces of cuts are hatched (ISO 128-50).
struct Hatching {
    double spacing = 0; ///< between lines, model units; 0: a fortieth of the size of the cut, less
                        ///< on small parts
    double angle = 45;  ///< degrees, for the first part; other parts have other angles
    bool none = false;  ///< faces stay blank
};

/// A mesh that was cut.
struct Section {
    /// The rest of the mesh, with faces where it was cut, and polylines along the outlines of these
    /// faces and across them. Positions of the uncut mesh keep their numbers.
    Mesh mesh;
    std::vector<std::string> notes; ///< a line for each place where a cut does not close
};

/// The most planes that cut_mesh() takes.
inline constexpr std::size_t most_sections = 6;

/// Cuts a mesh by one plane after the other. Each part is closed by a face of its own. Parts are
/// objects of the mesh's groups if they have names, and triangles that are connected by edges. If a
/// part's cut does not close, the part stays open, and a note says so. Parts named by `uncut` stay
/// whole, as bolts, shafts and ribs do by ISO 128-50; `*` and `?` stand for any letters, and the
/// parts inside a part count too. Throws UsageError for a plane that misses the model or goes
/// through uncut parts alone, for a plane without a normal, for more than `most_sections` planes,
/// for an empty name and one that no part has, and for too many hatching lines.
LINEATLAS_API Section cut_mesh(const Mesh& mesh, std::span<const SectionPlane> planes,
                               const Hatching& hatching = {},
                               std::span<const std::string> uncut = {});

} // namespace lineatlas
