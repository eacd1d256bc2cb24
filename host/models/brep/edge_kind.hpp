#pragma once

#include <optional>

#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Edge.hxx>

#include "lineatlas/mesh.hpp"

namespace lineatlas::brep {

/// What an edge is between the faces that have it. Nothing where it is a point: the tip of a cone
/// has such an edge. An edge is smooth where the normals on its two sides differ by less than a
/// degree at five places.
std::optional<KnownEdge::Kind> kind_of(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces);

} // namespace lineatlas::brep
