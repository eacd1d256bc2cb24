// Drawings of round bodies agree with rays and with the bodies' own surfaces, from all sides and in
// level views.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <glm/gtc/matrix_transform.hpp>
#include <gp_Ax2.hxx>

#include "brep_files.hpp"
#include "brep_fixture.hpp"
#include "lineatlas/section.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"
#include "truth/model_truth.hpp"

namespace lineatlas::test {
namespace {

const std::vector<std::string> directions{"front", "top", "isometric", "130,-20"};

class RoundTruth : public Brep {
  protected:
    /// The mesh of a shape for pictures of 1024 pixels.
    Mesh mesh_of(const TopoDS_Shape& shape) const {
        return load("a.brep", to_brep(shape), {.pixels = 1024}).mesh;
    }

    /// Expects right drawings by the method `exact`.
    static void expect_right(const Mesh& mesh, const LineSet& lines, double most_off = 0.05) {
        const ModelTruth model{mesh, lines, {.lines = usual_line_kinds}};
        LineVisibility visibility{lines};
        for (const std::string& direction : directions) {
            SCOPED_TRACE(direction);
            constexpr glm::ivec2 size{1024, 768};
            const View view =
                frame_points_from(view_direction(direction, {0, 0, 1}), lines.vertices, size,
                                  View{}.fov_y, Projection::perspective);
            const Camera camera = make_camera(view, size, lines.bounds);
            const VectorDrawing drawing =
                make_vector_drawing(lines, camera, visibility.find(camera), {}, {.mesh = &mesh});
            const Certificate found =
                model.certify(model.seen(camera), camera, drawn_lines(drawing));
            EXPECT_GT(found.narrow.visible, 500);
            EXPECT_LT(found.narrow.missed_share(), 0.0005);
            EXPECT_LT(found.narrow.false_share(), most_off / 500);
            EXPECT_LT(found.narrow.off, most_off) << certificate_table(found, 3);
        }
    }
};

TopoDS_Shape filleted(const TopoDS_Shape& shape, double radius) {
    BRepFilletAPI_MakeFillet fillet(shape);
    for (TopExp_Explorer edges(shape, TopAbs_EDGE); edges.More(); edges.Next())
        fillet.Add(radius, TopoDS::Edge(edges.Current()));
    return fillet.Shape();
}

TEST_F(RoundTruth, OfSolids) {
    const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(10).Shape();
    const TopoDS_Shape block = BRepPrimAPI_MakeBox(20, 15, 10).Shape();
    const TopoDS_Shape plate = BRepPrimAPI_MakeCylinder(25, 6).Shape();
    const TopoDS_Shape bore = BRepPrimAPI_MakeCone(gp_Ax2{}, 12, 7, 6).Shape();
    const std::vector<std::pair<const char*, TopoDS_Shape>> solids{
        {"sphere", sphere},
        {"sphere of splines", BRepBuilderAPI_NurbsConvert(sphere).Shape()},
        {"torus", BRepPrimAPI_MakeTorus(20, 5).Shape()},
        {"cone", BRepPrimAPI_MakeCone(10, 0, 20).Shape()},
        {"tall cylinder", BRepPrimAPI_MakeCylinder(3, 60).Shape()},
        {"block with fillets", filleted(block, 2)},
        {"block with thin fillets", filleted(block, 0.3)},
        {"plate with a conical hole", BRepAlgoAPI_Cut(plate, bore).Shape()}};
    for (const auto& [name, shape] : solids) {
        SCOPED_TRACE(name);
        const Mesh mesh = mesh_of(shape);
        ASSERT_FALSE(mesh.surfaces.empty());
        expect_right(mesh, extract_lines(mesh, {.lines = usual_line_kinds}));
    }
}

/// The rest of a surface after a cut is still that surface. The line of the cut is chords, up to a
/// third of a pixel behind the surface.
TEST_F(RoundTruth, OfSections) {
    const Mesh mesh = mesh_of(BRepPrimAPI_MakeTorus(20, 5).Shape());
    const std::vector<SectionPlane> planes{{.point = {0, 3, 0}, .normal = {0, -1, 0}}};
    const Section section = cut_mesh(mesh, planes, {.none = true});
    ASSERT_FALSE(section.mesh.surfaces.empty());
    expect_right(section.mesh, extract_lines(section.mesh), 0.35);
}

/// When objects move, their surfaces move with them.
TEST_F(RoundTruth, OfMovedObjects) {
    Mesh mesh = mesh_of(BRepPrimAPI_MakeTorus(20, 5).Shape());
    const glm::mat4 turn =
        glm::rotate(glm::translate(glm::mat4{1}, {4, 5, 6}), 0.7F, {1, 0.5F, 0.2F});
    LineSet moved = extract_lines(mesh, {.separate_objects = true});
    move_objects(moved, std::vector{turn});
    for (glm::vec3& position : mesh.positions) position = glm::vec3{turn * glm::vec4{position, 1}};
    for (glm::vec3& normal : mesh.corner_normals) normal = glm::mat3{turn} * normal;
    for (std::optional<EdgeCurve>& curve : mesh.edge_curves) {
        if (!curve) continue;
        const glm::dmat4 exact{turn};
        *curve = {.center = exact * glm::dvec4{curve->center, 1},
                  .u = exact * glm::dvec4{curve->u, 0},
                  .v = exact * glm::dvec4{curve->v, 0}};
    }
    for (PlacedSurface& surface : mesh.surfaces.surfaces)
        surface.model_from_shape =
            glm::dmat4x3{glm::dmat4{turn} * glm::dmat4{surface.model_from_shape}};
    expect_right(mesh, moved);
}

} // namespace
} // namespace lineatlas::test
