#pragma once

#include <optional>

#include <TopoDS_Face.hxx>

#include "lineatlas/surface.hpp"

namespace lineatlas::brep {

/// The surface of a face with Open CASCADE's parameters. Nothing for a surface made of curves other
/// than lines, ellipses and splines.
std::optional<SurfaceShape> surface_of(const TopoDS_Face& face);

} // namespace lineatlas::brep
