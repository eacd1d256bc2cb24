#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/export.hpp"
#include "lineatlas/io.hpp"

/// @file
/// Parts of a model that stand apart.
/// @code{.cpp}
/// LoadedMesh model = load_mesh("gearbox.step");
/// explode(model, {.factor = 1.5, .moves = {{.part = "Bolt*", .by = {0, 0, 20}}}});
/// @endcode

namespace lineatlas {

/// A move of a part by hand, in place of the move outwards.
struct PartMove {
    /// A name, or consecutive names of its path: "Bolt*" moves every bolt with all parts inside it.
    /// `*` stands for any letters, `?` for one.
    std::string part;
    glm::dvec3 by{0}; ///< in model units, in addition to the move of the assembly that holds it
};

/// How far parts of a model stand apart.
struct Explosion {
    /// Each part stands this many times as far from the middle of its assembly, 1 to 100. Middles
    /// are those of boxes along the axes.
    double factor = 1;
    std::vector<PartMove> moves{}; ///< the last one that names a part counts for it
    bool trails =
        true; ///< polylines (PolylineKind::trail) from where parts belong to where they are
};

/// Moves the parts of a model apart, by its tree (LoadedMesh::parts) or, where it has none, by the
/// names of its groups. Surfaces, curves and lines of a part go with it; a position that several
/// parts share becomes several. Throws UsageError for a factor out of range, a move that is not
/// finite, and a name that no part has.
LINEATLAS_API void explode(LoadedMesh& model, const Explosion& explosion);

} // namespace lineatlas
