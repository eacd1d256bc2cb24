#pragma once

#include <optional>

#include <TopoDS_Edge.hxx>

#include "lineatlas/mesh.hpp"

namespace lineatlas::brep {

/// The circle or ellipse that an edge is a part of; nothing for other edges.
std::optional<EdgeCurve> curve_of(const TopoDS_Edge& edge);

} // namespace lineatlas::brep
