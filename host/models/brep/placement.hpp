#pragma once

#include "assembly.hpp"
#include "io/soup.hpp"

namespace lineatlas::brep {

/// How closely triangles must follow curved faces.
struct Drawn {
    double deflection = 0; ///< how far a chord may be off; 0: a quarter of a pixel
    double pixels = 1;     ///< length of the whole assembly's diagonal in the drawing
};

/// Meshes every shape once and puts its instances in their places.
Soup place(Assembly&& assembly, const Drawn& drawn);

} // namespace lineatlas::brep
