#pragma once

#include <string>

#include <NCollection_DataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Shape.hxx>

#include "assembly.hpp"

namespace lineatlas::brep {

/// The file's names of shapes, without their locations.
using ShapeNames = NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher>;

/// For files of surfaces (IGES), whose faces share no edges: each face is trimmed by curves of its
/// own. Sews faces of one group together if their edges run within `tolerance` millimetres of each
/// other, or within a hundred-thousandth of the group's size. Groups within groups become parts.
/// Faces in no group become one part, and so do curves in no group.
void sew_bodies(Assembly& assembly, const ShapeNames& names, double tolerance);

/// For files of solids (STEP, BREP): if a part has several solids, each becomes a part in it, and
/// so do the shapes beside them. Nothing is sewn.
void part_bodies(Assembly& assembly, const ShapeNames& names);

} // namespace lineatlas::brep
