// Axes, centre marks and tangent edges of exact bodies.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <glm/geometric.hpp>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include "brep_files.hpp"
#include "brep_fixture.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"
#include "vector/paths.hpp"

namespace lineatlas::test {
namespace {

constexpr float overhang = 20; // pixels
constexpr int height = 768;

/// Draws hidden centre lines as visible ones.
Style with_centre_lines() {
    Style style;
    style.hidden = true;
    style.hidden_pen = style.pen;
    style.more_lines = mask_of(LineKind::centre) | mask_of(LineKind::tangent);
    return style;
}

/// A plate of 40 by 40 by 10 with a round hole of radius 5 through its middle.
TopoDS_Shape plate() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, 0), 40, 40, 10).Shape();
    const gp_Ax2 axis(gp_Pnt(0, 0, -1), gp_Dir(0, 0, 1));
    return BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeCylinder(axis, 5, 12).Shape()).Shape();
}

class CentreLines : public Brep {
  protected:
    LineSet lines_of(const TopoDS_Shape& shape, LineKindMask kinds = all_line_kinds) const {
        return extract_lines(load("a.brep", to_brep(shape)).mesh, {.lines = kinds});
    }

    std::uint32_t count(const TopoDS_Shape& shape, LineKind kind) const {
        return lines_of(shape).kind_counts.at(static_cast<std::size_t>(kind));
    }

    /// The lengths of the lines of a kind in a parallel view, in pixels.
    std::vector<double> lengths(const TopoDS_Shape& shape, const std::string& direction,
                                const Style& style = with_centre_lines(),
                                LineKind kind = LineKind::centre) {
        const LineSet lines = lines_of(shape);
        const View view = frame_points_from(view_direction(direction, {0, 0, 1}), lines.vertices,
                                            {1024, height}, View{}.fov_y, Projection::orthographic);
        pixels_per_unit_ = height / static_cast<double>(shown_height(view));
        const Camera camera = make_camera(view, {1024, height}, lines.bounds);
        LineVisibility visibility{lines};
        const VectorDrawing drawing = make_vector_drawing(
            lines, camera,
            visibility.find(camera, {.lines = usual_line_kinds | style.more_lines,
                                     .hidden = true,
                                     .centre_overhang = overhang}),
            style);
        std::vector<double> found;
        for (const VectorPath& path : drawing.paths)
            if (path.kind == kind) found.push_back(length_of(path));
        return found;
    }

    double with_ends(double units) const { return units * pixels_per_unit_ + 2 * double{overhang}; }

    double pixels_per_unit_ = 0;
};

TEST_F(CentreLines, OfAHoleSeenFromTheSideAreItsAxis) {
    for (const std::string direction : {"front", "left"}) {
        const std::vector<double> found = lengths(plate(), direction);
        ASSERT_EQ(found.size(), 1U) << direction;
        EXPECT_NEAR(found[0], with_ends(10), 0.01);
    }
}

TEST_F(CentreLines, OfAHoleSeenEndOnAreAMark) {
    for (const std::string direction : {"top", "bottom"}) {
        const std::vector<double> found = lengths(plate(), direction);
        ASSERT_EQ(found.size(), 2U) << direction;
        for (const double length : found) EXPECT_NEAR(length, with_ends(10), 0.01);
    }
}

TEST_F(CentreLines, AreHiddenAsOtherLinesAre) {
    Style style = with_centre_lines();
    style.hidden = false;
    const std::vector<double> found = lengths(plate(), "front", style);
    ASSERT_EQ(found.size(), 2U);
    for (const double length : found) EXPECT_NEAR(length, double{overhang}, 0.01);
    style.hidden = true;
    style.hidden_pen.color = {1, 0, 0};
    EXPECT_EQ(lengths(plate(), "front", style).size(), 3U);
}

TEST_F(CentreLines, AreDrawnForStylesThatAskForThem) {
    Style style = with_centre_lines();
    style.more_lines = 0;
    EXPECT_TRUE(lengths(plate(), "front", style).empty());
}

TEST_F(CentreLines, AreThoseOfHolesAndShaftsAndNotOfFillets) {
    constexpr std::uint32_t axis_and_marks = 1 + 2 * 2;
    EXPECT_EQ(count(BRepPrimAPI_MakeCylinder(3, 10).Shape(), LineKind::centre), axis_and_marks);
    EXPECT_EQ(count(BRepPrimAPI_MakeSphere(3).Shape(), LineKind::centre), 0U);
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
    EXPECT_EQ(count(box, LineKind::centre), 0U);
    BRepFilletAPI_MakeFillet rounded(box);
    for (TopExp_Explorer edges(box, TopAbs_EDGE); edges.More(); edges.Next())
        rounded.Add(2, TopoDS::Edge(edges.Current()));
    EXPECT_EQ(count(rounded.Shape(), LineKind::centre), 0U);
}

TEST_F(CentreLines, SurfacesOfOneAxisShareIt) {
    const gp_Ax2 above(gp_Pnt(0, 0, 10), gp_Dir(0, 0, 1));
    const TopoDS_Shape stepped = BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(6, 10).Shape(),
                                                  BRepPrimAPI_MakeCylinder(above, 3, 10).Shape())
                                     .Shape();
    std::vector<double> found = lengths(stepped, "front");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0], with_ends(20), 0.01);
    found = lengths(stepped, "top");
    ASSERT_EQ(found.size(), 2U);
    for (const double length : found) EXPECT_NEAR(length, with_ends(6), 0.01) << "of the near end";
}

TEST_F(CentreLines, FarApartEachHasItsOwn) {
    gp_Trsf far;
    far.SetTranslation(gp_Vec(0, 0, 100));
    const TopoDS_Shape one = BRepPrimAPI_MakeCylinder(3, 10).Shape();
    const TopoDS_Shape other = BRepBuilderAPI_Transform(one, far).Shape();
    const std::vector<double> found = lengths(BRepAlgoAPI_Fuse(one, other).Shape(), "front");
    ASSERT_EQ(found.size(), 2U);
    for (const double length : found) EXPECT_NEAR(length, with_ends(10), 0.01);
}

/// A cube with one rounded edge.
TopoDS_Shape rounded_cube() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
    BRepFilletAPI_MakeFillet rounded(box);
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(box, TopAbs_EDGE, edges);
    rounded.Add(2, TopoDS::Edge(edges(1)));
    return rounded.Shape();
}

TEST_F(CentreLines, AnOpacityOfZeroTakesLinesAway) {
    Style style = with_centre_lines();
    const auto tangents = [&] {
        return lengths(rounded_cube(), "isometric", style, LineKind::tangent).size();
    };
    EXPECT_GT(tangents(), 0U);
    style.pens = {{.match = {.kinds = {"tangent"}}, .opacity = 0.0F},
                  {.match = {.kinds = {"tangent"}, .hidden = true}, .opacity = 0.0F}};
    EXPECT_EQ(tangents(), 0U);
}

TEST_F(CentreLines, TangentEdgesAreThoseWhereFilletsEnd) {
    const TopoDS_Shape shape = rounded_cube();
    EXPECT_EQ(count(shape, LineKind::tangent), 2U);
    const LineKindMask usual = usual_line_kinds;
    const LineSet with = lines_of(shape), without = lines_of(shape, usual);
    for (std::size_t kind = 0; kind < LA_KIND_COUNT; ++kind) {
        if ((usual & 1U << kind) == 0) continue;
        EXPECT_EQ(with.kind_counts[kind], without.kind_counts[kind]) << line_kind_names[kind];
    }
}

TEST_F(CentreLines, ACylinderCutInTwoHasNoTangentEdge) {
    const gp_Ax2 axis(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
    const gp_Ax2 turned(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(-1, 0, 0));
    constexpr double half = 3.14159265358979323846;
    const TopoDS_Shape whole =
        BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(axis, 5, 10, half).Shape(),
                         BRepPrimAPI_MakeCylinder(turned, 5, 10, half).Shape())
            .Shape();
    ASSERT_EQ(edges_of(load("a.brep", to_brep(whole)).mesh)[1], 2U + 2 + 2)
        << "smooth: of the wall, and of top and bottom";
    EXPECT_EQ(count(whole, LineKind::tangent), 0U);
    EXPECT_EQ(count(whole, LineKind::centre), 1U + 2 * 2);
}

} // namespace
} // namespace lineatlas::test
