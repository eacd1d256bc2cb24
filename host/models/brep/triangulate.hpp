#pragma once

#include <IMeshTools_Parameters.hxx>
#include <TopoDS_Shape.hxx>

namespace lineatlas::brep {

/// Triangulates the faces of a shape by the first of two algorithms whose triangles end where a
/// face's edges run (IMeshTools_Parameters::MeshAlgo is ignored). Faces that share an edge share
/// its points. Throws exceptions of Open CASCADE.
void triangulate(const TopoDS_Shape& shape, IMeshTools_Parameters parameters);

} // namespace lineatlas::brep
