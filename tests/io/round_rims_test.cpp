// Rims of exact round bodies: their circles, their pens, and where other lines meet them.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <glm/geometric.hpp>
#include <gp.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include "brep_files.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"
#include "round_things_fixture.hpp"

namespace lineatlas::test {
namespace {

class RoundRims : public RoundThings {};

// One half of the bore is red, so that faces of two colours meet at half of its rim.
TEST_F(RoundRims, ACircleBesideTwoColoursIsOneCircle) {
    const TopoDS_Shape bore = BRepPrimAPI_MakeCylinder(5, 10).Shape();
    const TopoDS_Shape disc = BRepPrimAPI_MakeCylinder(20, 10).Shape();
    Mesh mesh = load("a.brep", to_brep(BRepAlgoAPI_Cut(disc, bore).Shape())).mesh;
    mesh.groups = {{.object = "", .material = "steel"}, {.object = "", .material = "paint"}};
    mesh.triangle_group.clear();
    for (const glm::uvec3& t : mesh.triangles) {
        const auto is_painted = [&](std::uint32_t corner) {
            const glm::vec3 at = mesh.positions[corner];
            return at.x > -1e-4F && glm::length(glm::vec2{at}) < 5.001F;
        };
        mesh.triangle_group.push_back(is_painted(t.x) && is_painted(t.y) && is_painted(t.z) ? 1
                                                                                            : 0);
    }
    const LineSet lines = extract_lines(mesh);
    const View view = frame_points_from(view_direction("top", up), lines.vertices, {800, 800},
                                        View{}.fov_y, Projection::orthographic);
    const Camera camera = make_camera(view, {800, 800}, lines.bounds);
    LineVisibility visibility{lines};
    const VectorDrawing drawing =
        make_vector_drawing(lines, camera, visibility.find(camera), {}, {.mesh = &mesh});
    EXPECT_EQ(drawing.paths.size(), 2U);
    for (const VectorPath& path : drawing.paths) EXPECT_NE(path.kind, LineKind::material);
    const std::vector<double> radii = circles(drawing, scale_of(view, 800));
    ASSERT_EQ(radii.size(), 2U);
    EXPECT_NEAR(radii[0], 5, 1e-4);
    EXPECT_NEAR(radii[1], 20, 1e-4);
}

/// A plate with a boss.
TopoDS_Shape plate_with_boss() {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, 0), gp_Pnt(20, 20, 8)).Shape();
    return BRepAlgoAPI_Fuse(plate, BRepPrimAPI_MakeCylinder(10, 20).Shape()).Shape();
}

/// The edges of the plate end at the rim of the boss, not at a chord of the rim.
TEST_F(RoundRims, EdgesEndAtTheRimThatHidesThem) {
    int met = 0;
    for (const char* direction : {"isometric", "75,35", "200,-45"}) {
        SCOPED_TRACE(direction);
        const VectorDrawing drawn = drawing("a.brep", to_brep(plate_with_boss()), direction,
                                            {1024, 768}, Projection::orthographic);
        for (const VectorPath& rim : drawn.paths)
            for (const VectorCurve& curve : rim.curves) {
                if (!rim.visible || curve.cubic) continue;
                VectorPath arc;
                constexpr int steps = 1000;
                for (int i = 0; i <= steps; ++i)
                    arc.points.push_back(
                        {.at = curve.arc.at(curve.arc.from + curve.arc.sweep * i / steps)});
                for (const VectorPath& path : drawn.paths) {
                    if (!path.visible || path.closed || &path == &rim) continue;
                    for (const VectorPoint& end : {path.points.front(), path.points.back()}) {
                        const double away = distance_to(arc, end.at);
                        EXPECT_TRUE(away < 0.02 || away > 1) << away;
                        met += away < 0.02 ? 1 : 0;
                    }
                }
            }
    }
    EXPECT_GT(met, 6);
}

/// The far half of a rim seen edge on is not drawn beside its end.
TEST_F(RoundRims, ARimSeenEdgeOnDoesNotTurnBack) {
    const TopoDS_Shape shaft = BRepPrimAPI_MakeCylinder(10, 40).Shape();
    const TopoDS_Shape tip =
        BRepPrimAPI_MakeCone(gp_Ax2{gp_Pnt{0, 0, 40}, gp::DZ()}, 10, 0, 8).Shape();
    const std::string drill = to_brep(BRepAlgoAPI_Fuse(shaft, tip).Shape());
    for (const std::string& direction : level) {
        SCOPED_TRACE(direction);
        const VectorDrawing drawn =
            drawing("a.brep", drill, direction, {1024, 768}, Projection::orthographic);
        int rims = 0;
        for (const VectorPath& path : drawn.paths) {
            if (!path.visible || path.kind == LineKind::silhouette) continue;
            EXPECT_EQ(path.points.size(), 2U);
            ++rims;
        }
        EXPECT_EQ(rims, 2);
    }
}

/// Paths by the pens of a style that tells outlines from other lines.
std::vector<VectorPath> paths_by_outline(const Mesh& mesh, const char* direction,
                                         Projection projection) {
    constexpr glm::ivec2 size{1024, 768};
    const LineSet lines = extract_lines(mesh);
    Style style;
    style.pens = {{.match = {.kinds = {"outline"}}, .width = 4.0F}};
    const View view = frame_points_from(view_direction(direction, up), lines.vertices, size,
                                        View{}.fov_y, projection);
    const Camera camera = make_camera(view, size, lines.bounds);
    LineVisibility visibility{lines};
    const std::vector<Interval> intervals =
        visibility.find(camera, {.hidden = true, .outlines = true});
    return make_vector_drawing(lines, camera, intervals, style,
                               {.mesh = &mesh, .outlines = visibility.outlines()})
        .paths;
}

/// The pen of a rim changes where a silhouette ends on the rim: all of them end at one point.
TEST_F(RoundRims, OutlinesLeaveARimWhereSilhouettesEnd) {
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(10, 0, 20).Shape();
    const Mesh mesh = load("a.brep", to_brep(cone), {.pixels = 1024}).mesh;
    for (const char* direction : {"130,-20", "40,-45", "200,-30"}) {
        SCOPED_TRACE(direction);
        const std::vector<VectorPath> paths =
            paths_by_outline(mesh, direction, Projection::perspective);
        ASSERT_EQ(paths.size(), 4U); // two halves of the rim, and two lines
        for (const VectorPath& silhouette : paths) {
            if (silhouette.kind != LineKind::silhouette) continue;
            const bool starts_at_tip = silhouette.points.front().world.z > 10;
            const glm::dvec2 end =
                (starts_at_tip ? silhouette.points.back() : silhouette.points.front()).at;
            for (const VectorPath& rim : paths) {
                if (rim.kind == LineKind::silhouette) continue;
                EXPECT_LT(std::min(glm::distance(rim.points.front().at, end),
                                   glm::distance(rim.points.back().at, end)),
                          1e-4);
            }
        }
    }
}

/// The outer end of a rim seen edge on is no outline, though the background is beside it.
TEST_F(RoundRims, ARimSeenEdgeOnHasOnePen) {
    const TopoDS_Shape shaft = BRepPrimAPI_MakeCylinder(10, 40).Shape();
    const TopoDS_Shape tip =
        BRepPrimAPI_MakeCone(gp_Ax2{gp_Pnt{0, 0, 40}, gp::DZ()}, 10, 0, 8).Shape();
    const TopoDS_Shape drill = BRepAlgoAPI_Fuse(shaft, tip).Shape();
    const Mesh mesh = load("a.brep", to_brep(drill), {.pixels = 1024}).mesh;
    for (const std::string& direction : level) {
        SCOPED_TRACE(direction);
        // Two rims, and two lines down from the tip.
        EXPECT_EQ(paths_by_outline(mesh, direction.c_str(), Projection::orthographic).size(), 4U);
    }
}

/// Where an outline leaves a rim, both end at the same point.
TEST_F(RoundRims, RimsAndSilhouettesMeet) {
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(10, 4, 15).Shape();
    for (const std::string& direction : aslant) {
        SCOPED_TRACE(direction);
        const std::vector<VectorPath> paths =
            drawing("a.brep", to_brep(cone), direction, {1024, 768}, Projection::perspective).paths;
        int met = 0;
        for (const VectorPath& line : paths) {
            if (line.kind != LineKind::silhouette || !line.visible) continue;
            for (const VectorPoint& end : {line.points.front(), line.points.back()})
                for (const VectorPath& rim : paths) {
                    if (rim.kind == LineKind::silhouette || !rim.visible || rim.closed) continue;
                    for (const VectorPoint& other : {rim.points.front(), rim.points.back()})
                        met += glm::distance(other.at, end.at) < 1e-4 ? 1 : 0;
                }
        }
        const auto is_open_rim = [](const VectorPath& path) {
            return path.kind != LineKind::silhouette && path.visible && !path.closed;
        };
        EXPECT_EQ(met, 2 * std::ranges::count_if(paths, is_open_rim));
        EXPECT_GT(met, 0);
    }
}

/// A bored plate, turned and far from the origin, as a file of millimetres and of inches. Every
/// visible rim is one circle, one ellipse or a part of these, as wide as in the file.
TEST_F(RoundRims, RimsAreTheFilesOwnCircles) {
    gp_Trsf place;
    place.SetTranslation(gp_Vec(300, -200, 100));
    const TopoDS_Shape plate = BRepPrimAPI_MakeCylinder(25, 4).Shape();
    const TopoDS_Shape bore = BRepPrimAPI_MakeCylinder(7.5, 4).Shape();
    const TopoDS_Shape bored = BRepAlgoAPI_Cut(plate, bore).Shape();
    const std::string millimetres = to_step({{"plate", bored, {place}}});
    for (const bool inches : {false, true}) {
        const std::string file = inches ? in_inches(millimetres) : millimetres;
        const double unit = inches ? 25.4 : 1;
        const VectorDrawing top =
            drawing("a.step", file, "top", {1000, 800}, Projection::orthographic);
        const double scale = scale_of(view_, 800);
        const std::vector<double> radii = circles(top, scale);
        ASSERT_EQ(radii.size(), 2U);
        EXPECT_NEAR(radii[0] / (7.5 * unit), 1, 1e-6);
        EXPECT_NEAR(radii[1] / (25 * unit), 1, 1e-6);
        const VectorDrawing aslant =
            drawing("a.step", file, "isometric", {1000, 800}, Projection::orthographic);
        int ellipses = 0;
        for (const VectorPath& path : aslant.paths) {
            if (path.kind == LineKind::silhouette || !path.visible) continue;
            ASSERT_EQ(path.curves.size(), 1U);
            const VectorArc& arc = path.curves[0].arc;
            const double radius = glm::length(arc.major) / scale_of(view_, 800) / unit;
            EXPECT_NEAR(radius / (radius > 15 ? 25 : 7.5), 1, 1e-6);
            EXPECT_NEAR(arc.ratio, std::sqrt(1.0 / 3), 1e-5); // the direction is of floats
            ++ellipses;
        }
        EXPECT_EQ(ellipses, 4); // both upper rims, and the visible parts of the lower ones
    }
}

/// A rim in an edge on view ends at the ends of the silhouettes that it meets.
TEST_F(RoundRims, RimsSeenEdgeOnAreAsWideAsTheyAre) {
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(10, 40).Shape();
    for (const double angle : {0.0, 17.0}) {
        gp_Trsf turn;
        turn.SetRotation(gp_Ax1(), angle * std::numbers::pi / 180);
        const VectorDrawing front = drawing("a.step", to_step({{"pin", cylinder, {turn}}}), "front",
                                            {1000, 800}, Projection::orthographic);
        int rims = 0;
        for (const VectorPath& path : front.paths) {
            if (path.kind == LineKind::silhouette || !path.visible) continue;
            const double width = glm::distance(path.points.front().at, path.points.back().at);
            EXPECT_NEAR(width / scale_of(view_, 800), 20, 1e-4);
            ++rims;
        }
        EXPECT_EQ(rims, 2);
    }
}

/// Splines in the form of circles become circles.
TEST_F(RoundRims, RimsOfSplinesAreCirclesToo) {
    const TopoDS_Shape disc = BRepPrimAPI_MakeCylinder(25, 4).Shape();
    const TopoDS_Shape splines = BRepBuilderAPI_NurbsConvert(disc).Shape();
    const VectorDrawing top =
        drawing("a.brep", to_brep(splines), "top", {1000, 800}, Projection::orthographic);
    ASSERT_EQ(top.paths.size(), 1U);
    ASSERT_EQ(top.paths[0].curves.size(), 1U);
    EXPECT_NEAR(top.paths[0].curves[0].arc.major.x / scale_of(view_, 800) / 25, 1, 1e-6);
}

/// A bored plate with a circle of the file's own, turned about the axis, at one height of the bore.
TopoDS_Shape plate_with_a_wire(double height) {
    const TopoDS_Shape plate = BRepPrimAPI_MakeCylinder(25, 4).Shape();
    const TopoDS_Shape bore = BRepPrimAPI_MakeCylinder(7.5, 4).Shape();
    TopoDS_Compound all;
    BRep_Builder builder;
    builder.MakeCompound(all);
    builder.Add(all, BRepAlgoAPI_Cut(plate, bore).Shape());
    const gp_Ax2 turned(gp_Pnt(0, 0, height), gp::DZ(), gp_Dir(1, 0.3, 0));
    builder.Add(all, BRepBuilderAPI_MakeEdge(gp_Circ(turned, 7.5)).Edge());
    return all;
}

/// Curves that coincide in the drawing are drawn once, although their chords do not coincide.
TEST_F(RoundRims, ACurveOfTheFileOverARimIsOneCircle) {
    for (const double height : {0.0, 2.0, 4.0, 6.0}) {
        SCOPED_TRACE(height);
        const VectorDrawing top = drawing("a.brep", to_brep(plate_with_a_wire(height)), "top",
                                          {1000, 800}, Projection::orthographic);
        const std::vector<double> radii = circles(top, scale_of(view_, 800));
        ASSERT_EQ(radii.size(), 2U);
        EXPECT_NEAR(radii[0] / 7.5, 1, 1e-6);
        EXPECT_NEAR(radii[1] / 25, 1, 1e-6);
    }
}

} // namespace
} // namespace lineatlas::test
