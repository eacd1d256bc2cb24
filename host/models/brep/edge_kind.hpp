#pragma once

#include <optional>

#include <TopTools_ListOfShape.hxx>
#include <TopoDS_Edge.hxx>

#include "lineatlas/mesh.hpp"

namespace lineatlas::brep {

/// The kind of an edge between its faces. Nothing if the edge is a point, as at the tip of a cone.
/// An edge is smooth where the normals on its two sides differ by less than a degree at five
/// places.
std::optional<KnownEdge::Kind> kind_of(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces);

} // namespace lineatlas::brep
