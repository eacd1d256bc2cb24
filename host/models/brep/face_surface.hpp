#pragma once

#include <optional>

#include <TopoDS_Face.hxx>

#include "lineatlas/surface.hpp"

namespace lineatlas::brep {

/// The surface of a face, by Open CASCADE's parameters; nothing for a surface that is made of other
/// curves than lines, ellipses and splines.
std::optional<SurfaceShape> surface_of(const TopoDS_Face& face);

} // namespace lineatlas::brep
