#pragma once

#include <string>

#include <NCollection_DataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Shape.hxx>

#include "assembly.hpp"

namespace lineatlas::brep {

/// The file's names of shapes, without their locations.
using ShapeNames = NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher>;

/// Files of surfaces (IGES) have faces that share no edges: each is trimmed by curves of its own.
/// Sews faces that lie in one group together where their edges run within `tolerance` millimetres,
/// or within a hundred-thousandth of the group's size. Groups within groups become parts; faces and
/// curves that are in no group become one part each.
void sew_bodies(Assembly& assembly, const ShapeNames& names, double tolerance);

/// Files of solids (STEP, BREP): of a part that holds several solids each becomes a part in it,
/// and so does what lies beside them. Nothing is sewn.
void part_bodies(Assembly& assembly, const ShapeNames& names);

} // namespace lineatlas::brep
