#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// A plane that cuts a model.
struct SectionPlane {
    glm::dvec3 point{0};        ///< on it
    glm::dvec3 normal{0, 0, 1}; ///< of any length; what lies on the side that it points to is gone
    bool side_is_given = true;  ///< else the side of the eye is meant, if there is one
    std::string name{};         ///< as it was written, for messages
};

/// A plane as written: an axis and a position, "z=0.3" or "x=50%" (of `bounds`, from its least
/// coordinate), or a point and a normal, "1,2,3/0,0,1". What is beyond is gone; "-z=0.3" leaves
/// that and takes what is before. With "z=0.3" alone the side is not given. Throws UsageError.
LINEATLAS_API SectionPlane parse_section(std::string_view text, const Bounds& bounds);

/// How the faces of cuts are hatched (ISO 128-50).
struct Hatching {
    double spacing = 0; ///< between lines, model units; 0: a fortieth of the size of the cut, less
                        ///< on small parts
    double angle = 45;  ///< degrees, of the first part; others are turned against each other
    bool none = false;  ///< faces stay blank
};

/// A mesh that was cut.
struct Section {
    /// What is left, with faces where it was cut, and polylines along their outlines and across
    /// them. Positions of the uncut mesh keep their numbers.
    Mesh mesh;
    std::vector<std::string> notes; ///< where a cut does not close, a line each
};

/// The most planes that cut_mesh() takes.
inline constexpr std::size_t most_sections = 6;

/// Cuts a mesh, by one plane after the other. Each part is closed by a face of its own: objects of
/// the mesh's groups if they have names, and what hangs together by edges. Where a part's cut does
/// not close, it stays open, and a note says so. Throws UsageError for a plane that misses the
/// model, no normal, more than `most_sections` planes, and hatching without end.
LINEATLAS_API Section cut_mesh(const Mesh& mesh, std::span<const SectionPlane> planes,
                               const Hatching& hatching = {});

} // namespace lineatlas
