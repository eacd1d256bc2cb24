#include "shape_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include <BRep_Tool.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Polygon3D.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeUpgrade_ShapeDivideContinuity.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_DataMapOfShapeShape.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include "edge_curve.hpp"
#include "edge_kind.hpp"
#include "face_surface.hpp"
#include "surface_normal.hpp"
#include "triangulate.hpp"

namespace lineatlas::brep {

namespace {

constexpr std::uint32_t unknown = 0xFFFFFFFFU;

glm::dvec3 point_of(const gp_Pnt& point, const TopLoc_Location& location) {
    const gp_Pnt moved =
        location.IsIdentity() ? point : point.Transformed(location.Transformation());
    return {moved.X(), moved.Y(), moved.Z()};
}

/// Whether a surface may have kinks. Only surfaces made of curves can.
bool may_have_kinks(const Handle(Geom_Surface) & surface) {
    switch (GeomAdaptor_Surface(surface).GetType()) {
    case GeomAbs_Plane:
    case GeomAbs_Cylinder:
    case GeomAbs_Cone:
    case GeomAbs_Sphere:
    case GeomAbs_Torus:
        return false;
    default:
        return true;
    }
}

/// Joins the triangulations of faces along the edges that they share.
class Stitcher {
  public:
    explicit Stitcher(const TopoDS_Shape& shape) {
        TopExp::MapShapes(shape, TopAbs_VERTEX, vertices_);
        TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, edges_);
        TopExp::MapShapes(shape, TopAbs_FACE, faces_);
        position_of_vertex_.assign(static_cast<std::size_t>(vertices_.Extent()), unknown);
        points_of_edge_.resize(static_cast<std::size_t>(edges_.Extent()));
    }

    /// Whether a face has kinks, so that its normals are not known. Call after stitch().
    bool has_kinks() const { return has_kinks_; }

    ShapeMesh stitch() {
        for (int i = 1; i <= faces_.Extent(); ++i) add_face(TopoDS::Face(faces_(i)));
        for (int i = 1; i <= edges_.Extent(); ++i) add_edge(i);
        return std::move(mesh_);
    }

  private:
    std::uint32_t add_position(glm::dvec3 position) {
        mesh_.positions.push_back(position);
        return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
    }

    /// The position of a vertex, which is that of its first point.
    std::uint32_t at_vertex(const TopoDS_Vertex& vertex, glm::dvec3 position) {
        const int index = vertex.IsNull() ? 0 : vertices_.FindIndex(vertex);
        if (index == 0) return add_position(position);
        std::uint32_t& known = position_of_vertex_[static_cast<std::size_t>(index - 1)];
        if (known == unknown) known = add_position(position);
        return known;
    }

    /// One position per point of an edge, the same for all faces beside it. `point(i)` is the place
    /// for the first face.
    template <class Point>
    std::vector<std::uint32_t> make_points(const TopoDS_Edge& edge, int count, const Point& point) {
        TopoDS_Vertex first, last;
        TopExp::Vertices(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), first, last);
        std::vector<std::uint32_t> points;
        for (int i = 0; i < count; ++i) {
            if (BRep_Tool::Degenerated(edge) || i == 0)
                points.push_back(at_vertex(first, point(i)));
            else if (i == count - 1)
                points.push_back(at_vertex(last, point(i)));
            else
                points.push_back(add_position(point(i)));
        }
        return points;
    }

    void add_face(const TopoDS_Face& face) {
        TopLoc_Location location;
        const Handle(Poly_Triangulation)& triangulation = BRep_Tool::Triangulation(face, location);
        if (triangulation.IsNull() || triangulation->NbTriangles() == 0) {
            ++mesh_.failed_faces;
            return;
        }
        const int nodes = triangulation->NbNodes();
        std::vector<std::uint32_t> positions(static_cast<std::size_t>(nodes) + 1, unknown);
        // A seam comes twice, in both directions, with other nodes each time.
        for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
            const Handle(Poly_PolygonOnTriangulation)& polygon =
                BRep_Tool::PolygonOnTriangulation(edge, triangulation, location);
            if (polygon.IsNull()) continue;
            const int count = polygon->NbNodes();
            const auto point = [&](int i) {
                return point_of(triangulation->Node(polygon->Node(i + 1)), location);
            };
            std::vector<std::uint32_t>& shared =
                points_of_edge_[static_cast<std::size_t>(edges_.FindIndex(edge) - 1)];
            if (shared.empty()) shared = make_points(edge, count, point);
            // If the numbers of points differ, the face does not share the other face's points, and
            // a gap may be seen.
            if (shared.size() != static_cast<std::size_t>(count)) continue;
            for (int i = 0; i < count; ++i)
                positions[static_cast<std::size_t>(polygon->Node(i + 1))] =
                    shared[static_cast<std::size_t>(i)];
        }
        for (int i = 1; i <= nodes; ++i) {
            std::uint32_t& position = positions[static_cast<std::size_t>(i)];
            if (position == unknown)
                position = add_position(point_of(triangulation->Node(i), location));
        }
        add_triangles(*triangulation, positions, face);
    }

    /// Normals of the face at the corners of a triangle.
    static std::array<glm::dvec3, 3>
    normals_of(const Geom_Surface& surface, const std::array<gp_Pnt2d, 3>& corners, double sign) {
        std::array<glm::dvec3, 3> normals{};
        for (std::size_t i = 0; i < 3; ++i) {
            std::optional<gp_Vec> normal = normal_of(surface, corners[i]);
            if (!normal)
                normal = normal_beside(surface, corners[i],
                                       (corners[(i + 1) % 3].XY() + corners[(i + 2) % 3].XY()) / 2);
            if (normal) normals[i] = sign * glm::dvec3{normal->X(), normal->Y(), normal->Z()};
        }
        return normals;
    }

    /// Whether a triangle lies along the surface at its corners, within 20 degrees. Chords of a
    /// circle are off by 7.5 degrees. A triangle that is hardly wider than its allowed distance
    /// from the surface counts as lying along it.
    bool lies_along(const std::array<std::uint32_t, 3>& corners,
                    const std::array<glm::dvec3, 3>& normals, double deflection) const {
        const double least_cosine = std::cos(20 * std::numbers::pi / 180);
        const glm::dvec3 a = mesh_.positions[corners[0]], b = mesh_.positions[corners[1]],
                         c = mesh_.positions[corners[2]];
        const glm::dvec3 across = glm::cross(b - a, c - a);
        const double longest =
            std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
        const double twice_area = glm::length(across);
        if (twice_area <= 5 * deflection * longest) return true;
        return std::ranges::all_of(normals, [&](const glm::dvec3& normal) {
            return normal == glm::dvec3{0} || glm::dot(normal, across) > least_cosine * twice_area;
        });
    }

    void add_triangles(const Poly_Triangulation& triangulation,
                       const std::vector<std::uint32_t>& positions, const TopoDS_Face& face) {
        const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
        const bool has_normals = !surface.IsNull() && triangulation.HasUVNodes();
        const bool may_kink = has_normals && may_have_kinks(surface);
        bool has_kinks = false; // then normals at corners do not describe the surface between them
        const std::size_t first = mesh_.normals.size();
        const auto number = static_cast<std::uint32_t>(mesh_.faces.size());
        mesh_.faces.push_back(face);
        const bool reversed = face.Orientation() == TopAbs_REVERSED;
        mesh_.turned.push_back(reversed);
        mesh_.surfaces.push_back(has_normals ? surface_of(face) : std::nullopt);
        for (int i = 1; i <= triangulation.NbTriangles(); ++i) {
            int a = 0, b = 0, c = 0;
            triangulation.Triangle(i).Get(a, b, c);
            if (reversed) std::swap(b, c);
            const std::array corners{positions[static_cast<std::size_t>(a)],
                                     positions[static_cast<std::size_t>(b)],
                                     positions[static_cast<std::size_t>(c)]};
            // At the tip of a cone two corners are one.
            if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
                continue;
            mesh_.triangles.push_back(corners);
            mesh_.triangle_face.push_back(number);
            mesh_.normals.push_back({});
            mesh_.parameters.push_back({});
            if (!has_normals) continue;
            const std::array places{triangulation.UVNode(a), triangulation.UVNode(b),
                                    triangulation.UVNode(c)};
            mesh_.normals.back() = normals_of(*surface, places, reversed ? -1 : 1);
            for (std::size_t k = 0; k < 3; ++k)
                mesh_.parameters.back()[k] = {places[k].X(), places[k].Y()};
            if (may_kink && !lies_along(corners, mesh_.normals.back(), triangulation.Deflection()))
                has_kinks = true;
        }
        has_kinks_ = has_kinks_ || has_kinks;
        if (!has_kinks) return;
        std::fill(mesh_.normals.begin() + static_cast<std::ptrdiff_t>(first), mesh_.normals.end(),
                  std::array<glm::dvec3, 3>{});
        mesh_.surfaces.back().reset();
    }

    void add_edge(int index) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges_.FindKey(index));
        const TopTools_ListOfShape& faces = edges_(index);
        if (faces.IsEmpty()) return add_line(edge);
        const std::optional<KnownEdge::Kind> kind = kind_of(edge, faces);
        const std::vector<std::uint32_t>& points =
            points_of_edge_[static_cast<std::size_t>(index - 1)];
        if (kind) add_known(edge, points, *kind);
    }

    void add_known(const TopoDS_Edge& edge, const std::vector<std::uint32_t>& points,
                   KnownEdge::Kind kind) {
        const std::uint32_t number = mesh_.edge_count++;
        mesh_.edge_curves.push_back(curve_of(edge));
        mesh_.edge_shapes.push_back(edge);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            mesh_.edges.push_back({points[i], points[i + 1], kind, number});
    }

    void add_line(const TopoDS_Edge& edge) {
        TopLoc_Location location;
        const Handle(Poly_Polygon3D)& polygon = BRep_Tool::Polygon3D(edge, location);
        if (polygon.IsNull() || polygon->NbNodes() < 2) return;
        mesh_.lines.push_back(make_points(edge, polygon->NbNodes(), [&](int i) {
            return point_of(polygon->Nodes()(i + 1), location);
        }));
        add_known(edge, mesh_.lines.back(), KnownEdge::Kind::wire);
    }

    TopTools_IndexedMapOfShape vertices_, faces_;
    TopTools_IndexedDataMapOfShapeListOfShape edges_;
    std::vector<std::uint32_t> position_of_vertex_;
    std::vector<std::vector<std::uint32_t>> points_of_edge_;
    ShapeMesh mesh_;
    bool has_kinks_ = false;
};

/// Meshes a shape with its faces parted at kinks, which become edges. A part keeps the number of
/// its face in ShapeMesh::faces.
ShapeMesh mesh_in_parts(const TopoDS_Shape& shape, const IMeshTools_Parameters& parameters) {
    ShapeUpgrade_ShapeDivideContinuity divide(shape);
    divide.SetBoundaryCriterion(GeomAbs_C1);
    divide.SetPCurveCriterion(GeomAbs_C1);
    divide.SetSurfaceCriterion(GeomAbs_C1);
    divide.Perform();
    const TopoDS_Shape parts = divide.Result();
    triangulate(parts, parameters);
    ShapeMesh mesh = Stitcher{parts}.stitch();
    TopTools_DataMapOfShapeShape whole;
    for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
        const TopoDS_Shape own = divide.GetContext()->Apply(faces.Current());
        for (TopExp_Explorer each(own, TopAbs_FACE); each.More(); each.Next())
            whole.Bind(each.Current(), faces.Current());
    }
    for (TopoDS_Shape& face : mesh.faces)
        if (whole.IsBound(face)) face = whole.Find(face);
    return mesh;
}

} // namespace

ShapeMesh mesh_shape(const TopoDS_Shape& shape, const Fineness& fineness) {
    const TopoDS_Shape here = shape.Located(TopLoc_Location());
    IMeshTools_Parameters parameters;
    parameters.Deflection = fineness.deflection;
    parameters.Angle = fineness.angle;
    // By default it would be twice as much within faces. Then a fillet would have two strips, and
    // its outline teeth.
    parameters.AngleInterior = fineness.angle;
    triangulate(here, parameters);
    Stitcher stitcher{here};
    ShapeMesh mesh = stitcher.stitch();
    if (!stitcher.has_kinks()) return mesh;
    try {
        ShapeMesh in_parts = mesh_in_parts(here, parameters);
        if (in_parts.failed_faces <= mesh.failed_faces) return in_parts;
    } catch (const Standard_Failure&) { // damaged faces stay as they are
    }
    return mesh;
}

} // namespace lineatlas::brep
