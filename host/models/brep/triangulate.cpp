#include "triangulate.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_MeshAlgoType.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include "core/pair_key.hpp"

namespace lineatlas::brep {

namespace {

using Sides = std::vector<std::uint64_t>; ///< sorted; pairs of nodes by pair_key()

std::uint64_t side(int a, int b) {
    return pair_key(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
}

/// The sides of all triangles. A side that two triangles share comes twice.
Sides sides_of(const Poly_Triangulation& triangulation) {
    Sides sides;
    sides.reserve(3 * static_cast<std::size_t>(triangulation.NbTriangles()));
    for (int i = 1; i <= triangulation.NbTriangles(); ++i) {
        int a = 0, b = 0, c = 0;
        triangulation.Triangle(i).Get(a, b, c);
        sides.insert(sides.end(), {side(a, b), side(b, c), side(c, a)});
    }
    std::ranges::sort(sides);
    return sides;
}

/// The pieces of a face's edges, each once.
Sides edges_of(const TopoDS_Face& face, const Handle(Poly_Triangulation) & triangulation,
               const TopLoc_Location& location) {
    Sides pieces;
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
        const Handle(Poly_PolygonOnTriangulation)& polygon = BRep_Tool::PolygonOnTriangulation(
            TopoDS::Edge(edges.Current()), triangulation, location);
        if (polygon.IsNull()) continue;
        for (int i = 1; i < polygon->NbNodes(); ++i)
            if (polygon->Node(i) != polygon->Node(i + 1))
                pieces.push_back(side(polygon->Node(i), polygon->Node(i + 1)));
    }
    std::ranges::sort(pieces);
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
    return pieces;
}

/// True if the triangles of a face end along all of its edges, and nowhere else.
bool is_filled(const TopoDS_Face& face) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation)& triangulation = BRep_Tool::Triangulation(face, location);
    if (triangulation.IsNull() || triangulation->NbTriangles() == 0) return false;
    const Sides sides = sides_of(*triangulation);
    Sides ends;
    for (auto at = sides.begin(); at != sides.end();) {
        const auto next = std::find_if(at, sides.end(), [&](auto each) { return each != *at; });
        if (next - at > 2) return false;
        if (next - at == 1) ends.push_back(*at);
        at = next;
    }
    const Sides edges = edges_of(face, triangulation, location);
    return std::ranges::includes(edges, ends) && std::ranges::includes(sides, edges);
}

} // namespace

// Watson's algorithm takes time n² for n holes in a face. Delabella's does not. Each of the two
// fails at a few faces that the other fills, such as faces with spikes, for which triangles are
// missing or lie outside.
void triangulate(const TopoDS_Shape& shape, IMeshTools_Parameters parameters) {
    parameters.MeshAlgo = IMeshTools_MeshAlgoType_Delabella;
    BRepMesh_IncrementalMesh{shape, parameters};
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    bool are_filled = true;
    for (int i = 1; i <= faces.Extent(); ++i) {
        if (is_filled(TopoDS::Face(faces(i)))) continue;
        are_filled = false;
        BRepTools::Clean(faces(i));
    }
    if (are_filled) return;
    // This leaves faces alone that have their triangles.
    parameters.MeshAlgo = IMeshTools_MeshAlgoType_Watson;
    BRepMesh_IncrementalMesh{shape, parameters};
}

} // namespace lineatlas::brep
