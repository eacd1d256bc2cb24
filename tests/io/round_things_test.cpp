// Drawings of exact round bodies with known silhouettes, in views from all sides and in level
// views, where silhouettes are hardest to find.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
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
#include "brep_fixture.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/section.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::vec3 up{0, 0, 1};

/// Pixels per unit of length.
double scale_of(const View& view, int height) {
    return height / static_cast<double>(shown_height(view));
}

const std::vector<std::string> level{"front", "back", "left", "right"};
const std::vector<std::string> aslant{"isometric", "30,20", "75,35", "130,-20", "250,10"};

/// The radii of the drawing's lines, which must be whole circles: smallest first, in the model's
/// units.
std::vector<double> circles(const VectorDrawing& drawing, double scale) {
    std::vector<double> radii;
    for (const VectorPath& path : drawing.paths) {
        if (!path.visible) continue;
        EXPECT_TRUE(path.closed);
        EXPECT_EQ(path.curves.size(), 1U);
        if (path.curves.size() != 1) return {};
        EXPECT_FALSE(path.curves[0].cubic);
        EXPECT_EQ(path.curves[0].arc.ratio, 1);
        radii.push_back(path.curves[0].arc.major.x / scale);
    }
    std::ranges::sort(radii);
    return radii;
}

class RoundThings : public Brep {
  protected:
    /// A drawing of a file.
    VectorDrawing drawing(const std::string& name, const std::string& file,
                          const std::string& direction, glm::ivec2 size, Projection projection,
                          const std::vector<SectionPlane>& planes = {}) const {
        const Mesh mesh =
            cut_mesh(
                load(name, file, {.pixels = static_cast<double>(std::max(size.x, size.y))}).mesh,
                planes, {.none = true})
                .mesh;
        const LineSet lines = extract_lines(mesh);
        view_ = frame_points_from(view_direction(direction, up), lines.vertices, size, View{}.fov_y,
                                  projection);
        const Camera camera = make_camera(view_, size, lines.bounds);
        LineVisibility visibility{lines};
        return make_vector_drawing(lines, camera, visibility.find(camera, {.hidden = true}), {},
                                   {.mesh = &mesh});
    }

    std::vector<VectorPath> silhouettes(const TopoDS_Shape& shape, const std::string& direction,
                                        glm::ivec2 size) const {
        std::vector<VectorPath> paths =
            drawing("a.brep", to_brep(shape), direction, size, Projection::perspective).paths;
        std::erase_if(paths, [](const VectorPath& path) {
            return !path.visible || path.kind != LineKind::silhouette;
        });
        return paths;
    }

    mutable View view_; ///< of the last drawing

    /// Calls `check` with the silhouettes from every side.
    template <class Check>
    void from_all_sides(const TopoDS_Shape& shape, const Check& check) const {
        for (const auto& directions : {level, aslant})
            for (const std::string& direction : directions) {
                SCOPED_TRACE(direction);
                check(silhouettes(shape, direction, {1024, 768}));
            }
    }
};

// One half of the bore is red, so that faces of two colours meet at half of its rim.
TEST_F(RoundThings, ACircleBesideTwoColoursIsOneCircle) {
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

TEST_F(RoundThings, AConeHasTwoLinesThatMeetAtItsTip) {
    constexpr double height = 20;
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(10, 0, height).Shape();
    from_all_sides(cone, [&](const std::vector<VectorPath>& paths) {
        ASSERT_EQ(paths.size(), 2U);
        std::vector<glm::dvec2> tips;
        for (const VectorPath& path : paths)
            for (const VectorPoint& end : {path.points.front(), path.points.back()})
                if (end.world.z > height / 2) tips.push_back(end.at);
        ASSERT_EQ(tips.size(), 2U);
        EXPECT_LT(glm::distance(tips[0], tips[1]), 1e-9);
    });
}

TEST_F(RoundThings, ASphereIsOneClosedCurve) {
    const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(10).Shape();
    from_all_sides(sphere, [&](const std::vector<VectorPath>& paths) {
        ASSERT_EQ(paths.size(), 1U);
        EXPECT_TRUE(paths[0].closed);
    });
}

// Its silhouette then goes through both poles, where all meridians meet.
TEST_F(RoundThings, ASphereSeenAcrossItsAxisIsOneCircle) {
    constexpr double radius = 10;
    for (const gp_Dir& axis : {gp::DZ(), gp::DX()}) {
        const TopoDS_Shape sphere =
            BRepPrimAPI_MakeSphere(gp_Ax2{gp_Pnt{3, -2, 5}, axis}, radius).Shape();
        for (const char* direction : {"front", "back", "left", "right", "top", "30,0", "77,0"}) {
            SCOPED_TRACE(direction);
            const VectorDrawing drawn = drawing("a.brep", to_brep(sphere), direction, {1024, 768},
                                                Projection::orthographic);
            const std::vector<double> radii = circles(drawn, scale_of(view_, 768));
            ASSERT_EQ(radii.size(), 1U);
            EXPECT_NEAR(radii[0], radius, 1e-3);
        }
    }
}

TEST_F(RoundThings, ATallCylinderHasTwoStraightLines) {
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(10, 300).Shape();
    from_all_sides(cylinder, [&](const std::vector<VectorPath>& paths) {
        ASSERT_EQ(paths.size(), 2U);
        for (const VectorPath& path : paths) {
            const glm::dvec2 a = path.points.front().at;
            const glm::dvec2 way = path.points.back().at - a;
            for (const VectorPoint& point : path.points) {
                const glm::dvec2 to = point.at - a;
                EXPECT_NEAR((way.x * to.y - way.y * to.x) / glm::length(way), 0, 0.05);
            }
        }
    });
}

/// A fillet may be so thin that its triangles lie aslant. It and other surfaces keep their
/// silhouettes.
TEST_F(RoundThings, ThinFilletsAreNotTorn) {
    for (const double radius : {0.3, 0.5}) {
        SCOPED_TRACE(radius);
        const TopoDS_Shape pillar = BRepPrimAPI_MakeCylinder(20, 40).Shape();
        BRepFilletAPI_MakeFillet fillet(pillar);
        for (TopExp_Explorer edges(pillar, TopAbs_EDGE); edges.More(); edges.Next()) {
            const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
            TopoDS_Vertex first, last;
            TopExp::Vertices(edge, first, last);
            if (first.IsSame(last) && BRep_Tool::Pnt(first).Z() > 39) {
                fillet.Add(radius, edge);
                break;
            }
        }
        const TopoDS_Shape rounded = fillet.Shape();
        for (const std::string& direction : aslant) {
            SCOPED_TRACE(direction);
            // One path around the upper rim and down both sides, or less in a view from below.
            EXPECT_LE(silhouettes(rounded, direction, {1024, 768}).size(), 3U);
        }
    }
}

/// A torus about the z axis, of radii 20 and 5. On its silhouette the normal is at a right angle to
/// the view. No part of the silhouette is left out where chords of triangles would take another
/// way.
TEST_F(RoundThings, ATorusIsDrawnWhereItsSurfaceTurnsAway) {
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(20, 5).Shape();
    for (const glm::ivec2 size : {glm::ivec2{1024, 768}, glm::ivec2{4000, 3000}}) {
        for (const auto& directions : {level, aslant})
            for (const std::string& direction : directions) {
                SCOPED_TRACE(direction);
                const std::vector<VectorPath> paths = silhouettes(torus, direction, size);
                // A level view has only the outline, and a view from above both rims. An oblique
                // view through the hole has the outline, the near rim of the hole, and the far one.
                const bool is_level = std::ranges::find(level, direction) != level.end();
                EXPECT_LE(paths.size(), is_level ? 2U : 5U);
                const glm::dvec3 eye{view_.eye};
                for (const VectorPath& path : paths) {
                    for (const VectorPoint& point : path.points) {
                        const glm::dvec3 at = point.world;
                        const double out = std::hypot(at.x, at.y);
                        const glm::dvec3 spine = glm::dvec3{at.x, at.y, 0} * (20 / out);
                        EXPECT_NEAR(glm::distance(at, spine), 5, 1e-3);
                        const double cosine =
                            glm::dot(glm::normalize(at - spine), glm::normalize(eye - at));
                        // Such a turn of the normal moves the line by 5 times as much, in pixels.
                        EXPECT_LT(std::abs(cosine) * 5 * scale_of(view_, size.y), 0.05);
                    }
                }
            }
    }
}

/// Pixels from a place to the nearest point of a path.
double distance_to(const VectorPath& path, glm::dvec2 at) {
    double nearest = INFINITY;
    for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
        const glm::dvec2 a = path.points[i].at, way = path.points[i + 1].at - a;
        const double share = std::clamp(glm::dot(at - a, way) / glm::dot(way, way), 0.0, 1.0);
        nearest = std::min(nearest, glm::distance(at, a + share * way));
    }
    return nearest;
}

/// The far side of the hole ends where it goes behind the near side. Triangles end before that, by
/// less or more than the chord of the silhouette that ends there. The near side itself ends in
/// cusps, far from other lines.
TEST_F(RoundThings, ASilhouetteEndsAtTheOneThatHidesIt) {
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(20, 5).Shape();
    int met = 0;
    for (int azimuth = 20; azimuth < 35; azimuth += 3) {
        const std::string direction =
            std::to_string(azimuth) + "," + std::to_string(16 + azimuth / 6);
        SCOPED_TRACE(direction);
        const VectorDrawing drawn =
            drawing("a.brep", to_brep(torus), direction, {1024, 768}, Projection::orthographic);
        for (const VectorPath& path : drawn.paths) {
            if (!path.visible || path.closed) continue;
            for (const VectorPoint& end : {path.points.front(), path.points.back()})
                for (const VectorPath& other : drawn.paths) {
                    if (!other.visible || &other == &path) continue;
                    const double away = distance_to(other, end.at);
                    EXPECT_TRUE(away < 0.08 || away > 5) << away;
                    met += away < 0.08 ? 1 : 0;
                }
        }
    }
    EXPECT_EQ(met, 2 * 5);
}

/// The edges of a bar end behind a box. The outline of a pipe before the box is 1.25 to 2.5 pixels
/// away from there, and hides what is farther away.
TEST_F(RoundThings, ASilhouetteNearTheEndOfALineDoesNotMoveIt) {
    constexpr double gap = 0.2, radius = 5;
    const TopoDS_Shape far = BRepPrimAPI_MakeBox(gp_Pnt(-50, 40, 0), gp_Pnt(50, 50, 20)).Shape();
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, -10), gp_Pnt(30, 10, 30)).Shape();
    for (const double side : {-1.0, 1.0}) {
        SCOPED_TRACE(side);
        const gp_Ax2 axis{gp_Pnt{side * (gap + radius), -20, -10}, gp::DZ()};
        TopoDS_Compound all;
        const BRep_Builder builder;
        builder.MakeCompound(all);
        builder.Add(all, far);
        builder.Add(all, box);
        builder.Add(all, BRepPrimAPI_MakeCylinder(axis, radius, 40).Shape());
        const VectorDrawing drawn =
            drawing("a.brep", to_brep(all), "front", {1000, 800}, Projection::orthographic);
        const double scale = scale_of(view_, 800);
        const auto place = [&](double x) {
            return 500 + (x - static_cast<double>(view_.target.x)) * scale;
        };
        const auto is_of_bar = [&](glm::dvec2 at) {
            const double z = static_cast<double>(view_.target.z) + (400 - at.y) / scale;
            return std::abs(z) < 0.01 || std::abs(z - 20) < 0.01;
        };
        EXPECT_GT(gap * scale, 1.25);
        EXPECT_LT(gap * scale, 2.5);
        int ends = 0, starts = 0;
        for (const VectorPath& path : drawn.paths) {
            const glm::dvec2 a = path.points.front().at, b = path.points.back().at;
            if (!path.visible || !is_of_bar(a) || !is_of_bar(b)) continue;
            for (const double x : {a.x, b.x}) {
                ends += std::abs(x - place(0)) < 0.05 ? 1 : 0;
                starts += std::abs(x - place(-gap)) < 0.05 ? 1 : 0;
            }
        }
        EXPECT_EQ(ends, 2);                  // the upper and the lower edge
        EXPECT_EQ(starts, side < 0 ? 2 : 0); // between the pipe and the box
    }
}

/// A plate with a boss.
TopoDS_Shape plate_with_boss() {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, 0), gp_Pnt(20, 20, 8)).Shape();
    return BRepAlgoAPI_Fuse(plate, BRepPrimAPI_MakeCylinder(10, 20).Shape()).Shape();
}

/// The edges of the plate end at the rim of the boss, not at a chord of the rim.
TEST_F(RoundThings, EdgesEndAtTheRimThatHidesThem) {
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
TEST_F(RoundThings, ARimSeenEdgeOnDoesNotTurnBack) {
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

/// All silhouettes become curves, and a sphere's outline becomes a circle.
TEST_F(RoundThings, SilhouettesLeaveAsCurves) {
    const TopoDS_Shape sphere = BRepPrimAPI_MakeSphere(10).Shape();
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const VectorDrawing ball =
            drawing("a.brep", to_brep(sphere), "30,20", {1000, 800}, projection);
        ASSERT_EQ(ball.paths.size(), 1U);
        ASSERT_EQ(ball.paths[0].curves.size(), 1U);
        EXPECT_FALSE(ball.paths[0].curves[0].cubic);
        EXPECT_NEAR(ball.paths[0].curves[0].arc.sweep * ball.paths[0].curves[0].arc.sweep,
                    4 * std::numbers::pi * std::numbers::pi, 1e-6);
        if (projection == Projection::perspective) continue;
        EXPECT_NEAR(ball.paths[0].curves[0].arc.major.x / scale_of(view_, 800) / 10, 1, 1e-6);
    }
    const VectorDrawing ring = drawing("a.brep", to_brep(BRepPrimAPI_MakeTorus(20, 5).Shape()),
                                       "isometric", {1000, 800}, Projection::perspective);
    ASSERT_EQ(ring.paths.size(), 2U);
    for (const VectorPath& path : ring.paths) {
        std::uint32_t covered = 0;
        for (const VectorCurve& curve : path.curves) {
            EXPECT_TRUE(curve.cubic);
            EXPECT_EQ(curve.edge, VectorCurve::none);
            covered += curve.last - curve.first;
        }
        EXPECT_EQ(covered + 1, path.points.size());
        EXPECT_LT(5 * path.curves.size(), path.points.size());
    }
}

/// A mesh with normals alone has curves through the points that the normals give.
TEST_F(RoundThings, SilhouettesOfMeshesLeaveAsCurvesToo) {
    Mesh mesh = load("a.brep", to_brep(BRepPrimAPI_MakeSphere(10).Shape()), {.pixels = 1000}).mesh;
    mesh.surfaces = {};
    const LineSet lines = extract_lines(mesh);
    const glm::ivec2 size{1000, 800};
    const View view = frame_points_from(view_direction("30,20", up), lines.vertices, size,
                                        View{}.fov_y, Projection::orthographic);
    const Camera camera = make_camera(view, size, lines.bounds);
    LineVisibility visibility{lines};
    const VectorDrawing ball = make_vector_drawing(
        lines, camera, visibility.find(camera, {.hidden = true}), {}, {.mesh = &mesh});
    ASSERT_EQ(ball.paths.size(), 1U);
    const VectorPath& path = ball.paths[0];
    std::uint32_t covered = 0;
    for (const VectorCurve& curve : path.curves) {
        ASSERT_TRUE(curve.cubic);
        covered += curve.last - curve.first;
        const glm::dvec2 middle = (path.points[curve.first].at + 3.0 * curve.cubic->first_control +
                                   3.0 * curve.cubic->last_control + path.points[curve.last].at) /
                                  8.0;
        const double radius = glm::distance(middle, glm::dvec2{size} * 0.5);
        EXPECT_NEAR(radius, 10 * scale_of(view, size.y), 0.25); // the error of the triangles
    }
    EXPECT_GT(5 * covered, 4 * path.points.size()); // chords stay between points that are off
    EXPECT_LT(2 * path.curves.size(), path.points.size());
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
TEST_F(RoundThings, OutlinesLeaveARimWhereSilhouettesEnd) {
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
TEST_F(RoundThings, ARimSeenEdgeOnHasOnePen) {
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
TEST_F(RoundThings, RimsAndSilhouettesMeet) {
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
TEST_F(RoundThings, RimsAreTheFilesOwnCircles) {
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
TEST_F(RoundThings, RimsSeenEdgeOnAreAsWideAsTheyAre) {
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
TEST_F(RoundThings, RimsOfSplinesAreCirclesToo) {
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
TEST_F(RoundThings, ACurveOfTheFileOverARimIsOneCircle) {
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

/// In a view along its axis the silhouettes of a torus are two circles.
TEST_F(RoundThings, SilhouettesAroundTheAxisOfViewAreCircles) {
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(20, 5).Shape();
    const VectorDrawing top =
        drawing("a.brep", to_brep(torus), "top", {1000, 800}, Projection::orthographic);
    const std::vector<double> radii = circles(top, scale_of(view_, 800));
    ASSERT_EQ(radii.size(), 2U);
    EXPECT_NEAR(radii[0] / 15, 1, 1e-5);
    EXPECT_NEAR(radii[1] / 25, 1, 1e-5);
}

/// What a drawing's lines are: the arcs, and the length of what is straight, both in the model's
/// units.
struct Parts {
    std::vector<VectorArc> arcs;
    double straight = 0;
};

Parts parts_of(const VectorDrawing& drawing, double scale) {
    Parts parts;
    for (const VectorPath& path : drawing.paths) {
        if (!path.visible) continue;
        std::vector<bool> is_straight(path.points.size() - 1, true);
        for (const VectorCurve& curve : path.curves) {
            EXPECT_FALSE(curve.cubic);
            for (std::uint32_t i = curve.first; i < curve.last; ++i) is_straight[i] = false;
            VectorArc arc = curve.arc;
            arc.major /= scale;
            parts.arcs.push_back(arc);
        }
        for (std::size_t i = 0; i + 1 < path.points.size(); ++i)
            if (is_straight[i])
                parts.straight += glm::distance(path.points[i].at, path.points[i + 1].at) / scale;
    }
    return parts;
}

/// Of radius 10 and height 30, with a fillet of 3 around its top.
TopoDS_Shape rounded_cylinder() {
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(10, 30).Shape();
    BRepFilletAPI_MakeFillet fillet{cylinder};
    for (TopExp_Explorer edges{cylinder, TopAbs_EDGE}; edges.More(); edges.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
        const TopoDS_Vertex vertex = TopExp::FirstVertex(edge);
        if (BRep_Tool::Pnt(vertex).Z() > 29 && TopExp::LastVertex(edge).IsSame(vertex))
            fillet.Add(3, edge);
    }
    return fillet.Shape();
}

/// Views at right angles to the axis; the triangles of a body have meridians there in the first two
/// alone.
const std::vector<std::string> across{"front", "right", "37,0", "101.3,0"};

// There meridians and parallels of the silhouette cross.
TEST_F(RoundThings, ATorusSeenAcrossItsAxisIsTwoLinesAndTwoHalfCircles) {
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(20, 5).Shape();
    for (const std::string& direction : across) {
        SCOPED_TRACE(direction);
        const VectorDrawing drawn =
            drawing("a.brep", to_brep(torus), direction, {1000, 800}, Projection::orthographic);
        ASSERT_EQ(drawn.paths.size(), 1U);
        EXPECT_TRUE(drawn.paths[0].closed);
        const Parts parts = parts_of(drawn, scale_of(view_, 800));
        ASSERT_EQ(parts.arcs.size(), 2U);
        for (const VectorArc& arc : parts.arcs) {
            EXPECT_EQ(arc.ratio, 1);
            EXPECT_NEAR(arc.major.x, 5, 1e-6);
            EXPECT_NEAR(std::abs(arc.sweep), std::numbers::pi, 1e-4);
        }
        EXPECT_NEAR(parts.straight, 80, 1e-3);
    }
}

// The fillet's meridians are quarters of circles between straight ones of the cylinder and the rim
// of the flat top.
TEST_F(RoundThings, ARoundedCylinderSeenAcrossItsAxisIsLinesAndQuarters) {
    for (const std::string& direction : across) {
        SCOPED_TRACE(direction);
        const VectorDrawing drawn = drawing("a.brep", to_brep(rounded_cylinder()), direction,
                                            {1000, 800}, Projection::orthographic);
        const Parts parts = parts_of(drawn, scale_of(view_, 800));
        ASSERT_EQ(parts.arcs.size(), 2U);
        for (const VectorArc& arc : parts.arcs) {
            EXPECT_NEAR(arc.major.x, 3, 1e-6);
            EXPECT_NEAR(std::abs(arc.sweep), 0.5 * std::numbers::pi, 1e-4);
        }
        EXPECT_NEAR(parts.straight, 20 + 2 * 27 + 14, 1e-3);
    }
}

// The outline of the cut, seen at right angles to the plane.
TEST_F(RoundThings, SectionsAlongTheAxisAreLinesAndQuarters) {
    const VectorDrawing drawn =
        drawing("a.brep", to_brep(rounded_cylinder()), "front", {1000, 800},
                Projection::orthographic, {{.point = {0, 0, 0}, .normal = {0, -1, 0}}});
    const Parts parts = parts_of(drawn, scale_of(view_, 800));
    ASSERT_EQ(parts.arcs.size(), 2U);
    for (const VectorArc& arc : parts.arcs) {
        EXPECT_NEAR(arc.major.x, 3, 1e-5);
        EXPECT_NEAR(std::abs(arc.sweep), 0.5 * std::numbers::pi, 1e-4);
    }
    EXPECT_NEAR(parts.straight, 20 + 2 * 27 + 14, 1e-3);
}

/// The places of outlines of cuts.
std::vector<glm::dvec3> places_of_cut(const Mesh& mesh) {
    std::vector<glm::dvec3> places;
    for (std::size_t i = 0; i < mesh.polylines.size(); ++i)
        if (mesh.polyline_kind[i] == PolylineKind::section)
            for (const std::uint32_t position : mesh.polylines[i])
                places.emplace_back(mesh.positions[position]);
    return places;
}

// Where its flat meets the round, the cut's curve ends on a line at a sharp angle.
TEST_F(RoundThings, SteepCutsOfAShaftKeepItsCorners) {
    const TopoDS_Shape round = BRepPrimAPI_MakeCylinder(10, 200).Shape();
    const TopoDS_Shape flat = BRepPrimAPI_MakeBox(gp_Pnt(8, -20, -1), 20, 40, 300).Shape();
    const Mesh shaft = load("a.brep", to_brep(BRepAlgoAPI_Cut(round, flat).Shape())).mesh;
    for (int turn = 0; turn < 180; turn += 10) {
        SCOPED_TRACE(turn);
        const double angle = turn * std::numbers::pi / 180;
        const glm::dvec3 normal{4 * std::cos(angle), 4 * std::sin(angle), 1}; // 76 degrees
        const Mesh cut =
            cut_mesh(shaft, std::vector<SectionPlane>{{.point = {0, 0, 100}, .normal = normal}})
                .mesh;
        std::size_t corners = 0;
        for (const glm::dvec3& place : places_of_cut(cut)) {
            const double radius = std::hypot(place.x, place.y);
            EXPECT_TRUE(std::abs(radius - 10) < 1e-4 || std::abs(place.x - 8) < 1e-4);
            EXPECT_LT(std::max(radius - 10, place.x - 8), 1e-4);
            corners += std::abs(radius - 10) < 1e-4 && std::abs(place.x - 8) < 1e-4 ? 1 : 0;
        }
        EXPECT_GE(corners, 2U);
    }
}

// Two pipes meet along a spline, where two ellipses of the cut cross.
TEST_F(RoundThings, CutsOfATeeStayOnItsPipes) {
    const TopoDS_Shape one =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -30), gp_Dir(0, 0, 1)), 5, 60).Shape();
    const TopoDS_Shape other =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-30, 0, 0), gp_Dir(1, 0, 0)), 4, 60).Shape();
    const Mesh tee = load("a.brep", to_brep(BRepAlgoAPI_Fuse(one, other).Shape())).mesh;
    const std::vector<glm::dvec3> normals{{1, 0, 1}, {1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1, 3, 1}};
    for (const glm::dvec3& normal : normals) {
        SCOPED_TRACE(normal.x * 100 + normal.y * 10 + normal.z);
        const Mesh cut = cut_mesh(tee, std::vector<SectionPlane>{{.normal = normal}}).mesh;
        for (const glm::dvec3& place : places_of_cut(cut)) {
            const double off_one = std::hypot(place.x, place.y) - 5;
            const double off_other = std::hypot(place.y, place.z) - 4;
            EXPECT_NEAR(std::min(off_one, off_other), 0, 0.01) << place.x << "," << place.y;
        }
    }
}

/// A bottle, whose curve is a spline.
TopoDS_Shape bottle() {
    TColgp_Array1OfPnt poles(1, 4);
    poles.SetValue(1, gp_Pnt(5, 0, 0));
    poles.SetValue(2, gp_Pnt(12, 0, 5));
    poles.SetValue(3, gp_Pnt(2, 0, 12));
    poles.SetValue(4, gp_Pnt(6, 0, 20));
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(new Geom_BezierCurve(poles)).Edge();
    return BRepPrimAPI_MakeRevol(edge, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))).Shape();
}

// As files have them that write splines alone.
TEST_F(RoundThings, SectionsOfSplinesAreCurvesWhereTheyAreRound) {
    const auto sections = [&](const TopoDS_Shape& shape, glm::dvec3 normal) {
        const TopoDS_Shape spline = BRepBuilderAPI_NurbsConvert(shape).Shape();
        VectorDrawing drawn = drawing(
            "a.brep", to_brep(spline), "isometric", {1000, 800}, Projection::orthographic,
            {{.point = normal.z == 1 ? glm::dvec3{0, 0, 2} : glm::dvec3{0}, .normal = normal}});
        std::erase_if(drawn.paths, [](const VectorPath& path) {
            return !path.visible || path.kind != LineKind::section;
        });
        return parts_of(drawn, scale_of(view_, 800));
    };
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(20, 5).Shape();
    for (const glm::dvec3& normal : {glm::dvec3{0, 0, 1}, glm::dvec3{-1, 1, 0}}) {
        const Parts parts = sections(torus, normal);
        EXPECT_GE(parts.arcs.size(), 2U);
        EXPECT_EQ(parts.straight, 0);
    }
    const Parts across = sections(bottle(), {0, 0, 1});
    EXPECT_GE(across.arcs.size(), 1U);
    EXPECT_EQ(across.straight, 0);
}

/// Of the bottle's curve at a share of its way.
glm::dvec2 place_of_bottle(double share) {
    const double t = share, s = 1 - share;
    return s * s * s * glm::dvec2{5, 0} + 3 * s * s * t * glm::dvec2{12, 5} +
           3 * s * t * t * glm::dvec2{2, 12} + t * t * t * glm::dvec2{6, 20};
}

TEST_F(RoundThings, ObliqueCutsOfSplinesAreSmoothCurves) {
    const glm::dvec3 normal{-1, 1, 0.5};
    const TopoDS_Shape spline = BRepBuilderAPI_NurbsConvert(bottle()).Shape();
    const VectorDrawing drawn = drawing("a.brep", to_brep(spline), "isometric", {1000, 800},
                                        Projection::orthographic, {{.normal = normal}});
    double length = 0;
    for (const VectorPath& path : drawn.paths) {
        if (!path.visible || path.kind != LineKind::section) continue;
        std::uint32_t covered = 0;
        for (const VectorCurve& curve : path.curves) covered += curve.last - curve.first;
        EXPECT_EQ(covered + 1, path.points.size());
        EXPECT_LT(2 * path.curves.size(), path.points.size());
        for (std::size_t i = 0; i < path.points.size(); ++i) {
            const glm::dvec3 at = path.points[i].world;
            const glm::dvec2 seen{std::hypot(at.x, at.y), at.z};
            double off = INFINITY;
            for (int k = 0; k <= 10'000; ++k)
                off = std::min(off, glm::distance(seen, place_of_bottle(k / 1e4)));
            EXPECT_LT(off, 2e-3);
            EXPECT_NEAR(glm::dot(at, normal), 0, 1e-4);
            if (i > 0) length += glm::distance(at, glm::dvec3{path.points[i - 1].world});
        }
    }
    EXPECT_GT(length, 20); // one of its sides hides a part of the other
}

/// A hexagonal nut of 20 across its flats and 8 high, with a bore of 10 and a chamfer of 30 degrees
/// around the top.
TopoDS_Shape nut() {
    BRepBuilderAPI_MakePolygon outline;
    const double reach = 10 / std::cos(std::numbers::pi / 6);
    for (int i = 0; i < 6; ++i) {
        const double angle = (i + 0.5) * std::numbers::pi / 3;
        outline.Add(gp_Pnt(reach * std::cos(angle), reach * std::sin(angle), 0));
    }
    outline.Close();
    const TopoDS_Shape prism =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 0, 8))
            .Shape();
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(9.5 + 8 * std::numbers::sqrt3, 9.5, 8).Shape();
    return BRepAlgoAPI_Cut(BRepAlgoAPI_Common(prism, cone).Shape(),
                           BRepPrimAPI_MakeCylinder(5, 8).Shape())
        .Shape();
}

// The chamfer's circle meets the flats.
TEST_F(RoundThings, ACutAcrossAChamferIsArcsAndLines) {
    VectorDrawing drawn =
        drawing("a.brep", to_brep(nut()), "top", {1000, 800}, Projection::orthographic,
                {{.point = {0, 0, 7.4}, .normal = {0, 0, 1}}});
    std::erase_if(drawn.paths, [](const VectorPath& path) {
        return !path.visible || path.kind != LineKind::section;
    });
    ASSERT_EQ(drawn.paths.size(), 2U);
    const double scale = scale_of(view_, 800);
    const Parts parts = parts_of(drawn, scale);
    ASSERT_EQ(parts.arcs.size(), 7U);
    const double radius = 9.5 + 0.6 * std::numbers::sqrt3;
    const double half = std::sqrt(radius * radius - 100); // of a flat
    int bores = 0;
    for (const VectorArc& arc : parts.arcs) {
        const bool is_bore = arc.major.x < 7;
        bores += is_bore ? 1 : 0;
        EXPECT_EQ(arc.ratio, 1);
        EXPECT_NEAR(arc.major.x, is_bore ? 5 : radius, 1e-5);
        const double sweep = std::numbers::pi / 3 - 2 * std::asin(half / radius);
        EXPECT_NEAR(std::abs(arc.sweep), is_bore ? 2 * std::numbers::pi : sweep,
                    0.02 / scale / radius);
    }
    EXPECT_EQ(bores, 1);
    EXPECT_NEAR(parts.straight, 12 * half, 0.02 / scale);
}

// A ball's circle and a cone's hyperbola.
TEST_F(RoundThings, CurvesWithoutEllipsesMeetOthersWhereTheyCross) {
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(6, 2, 25).Shape();
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(10).Shape();
    const Mesh both = load("a.brep", to_brep(BRepAlgoAPI_Fuse(ball, cone).Shape())).mesh;
    for (const double x : {1.0, 1.5, 3.0, 4.0}) {
        SCOPED_TRACE(x);
        const Mesh cut =
            cut_mesh(both, std::vector<SectionPlane>{{.point = {x, 0, 0}, .normal = {1, 0, 0}}})
                .mesh;
        std::size_t corners = 0;
        for (const glm::dvec3& place : places_of_cut(cut)) {
            const double off_ball = std::abs(glm::length(place) - 10);
            const double off_cone = std::abs(std::hypot(place.x, place.y) - (6 - 0.16 * place.z));
            EXPECT_TRUE(place.z > 24.999 || std::min(off_ball, off_cone) < 1e-4);
            corners += off_ball < 1e-4 && off_cone < 1e-4 ? 1 : 0;
        }
        EXPECT_GE(corners, 2U);
    }
}

// Chords of the cone alone turn by 29 degrees at the vertex of the hyperbola.
TEST_F(RoundThings, CutsAreDividedWhereTheyTurn) {
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(10, 0, 60).Shape();
    const Mesh mesh = load("a.brep", to_brep(cone)).mesh;
    const std::vector<glm::dvec3> places = places_of_cut(
        cut_mesh(mesh, std::vector<SectionPlane>{{.point = {0, -3, 0}, .normal = {0, -1, 0}}},
                 {.none = true})
            .mesh);
    int turns = 0;
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
        if (places[i].z < 1e-3) continue;
        EXPECT_NEAR(std::hypot(places[i].x, places[i].y), 10 - places[i].z / 6, 1e-4);
        const glm::dvec3 in = places[i] - places[i - 1], out = places[i + 1] - places[i];
        const double turn = std::atan2(glm::length(glm::cross(in, out)), glm::dot(in, out));
        EXPECT_LT(turn * 180 / std::numbers::pi, 15) << places[i].x << "," << places[i].z;
        ++turns;
    }
    EXPECT_GT(turns, 8);
}

/// The outline of a cut whose plane is seen at a right angle, which has no ellipses: the length of
/// the lines that do not run along the surface within `most_off`, and the largest distance of all
/// others from the surface, in the model's units. `off` tells how far a place lies off the surface.
struct Cut {
    double straight = 0, off = 0, length = 0; ///< the last of all lines
};
template <class Off>
Cut cut_of(const VectorDrawing& drawing, const View& view, double scale, double most_off,
           const Off& off) {
    const glm::dvec2 middle = 0.5 * glm::dvec2{drawing.size};
    const glm::dvec3 sight = glm::normalize(glm::dvec3{view.target - view.eye});
    const glm::dvec3 aside = glm::cross(sight, glm::dvec3{up});
    const auto off_at = [&](glm::dvec2 at) {
        const glm::dvec2 from_middle = (at - middle) / scale;
        return std::abs(
            off(glm::dvec3{view.target} + from_middle.x * aside - from_middle.y * glm::dvec3{up}));
    };
    Cut cut;
    for (const VectorPath& path : drawing.paths) {
        if (!path.visible || path.kind != LineKind::section) continue;
        std::vector<bool> is_straight(path.points.size() - 1, true);
        for (const VectorCurve& curve : path.curves) {
            EXPECT_TRUE(curve.cubic);
            if (!curve.cubic) continue;
            for (std::uint32_t i = curve.first; i < curve.last; ++i) is_straight[i] = false;
            for (int i = 0; i <= 64; ++i) {
                const double t = i / 64.0, s = 1 - t;
                const glm::dvec2 at = s * s * s * path.points[curve.first].at +
                                      3 * s * s * t * curve.cubic->first_control +
                                      3 * s * t * t * curve.cubic->last_control +
                                      t * t * t * path.points[curve.last].at;
                cut.off = std::max(cut.off, off_at(at));
            }
        }
        for (std::size_t i = 0; i + 1 < path.points.size(); ++i) {
            const glm::dvec2 a = path.points[i].at, b = path.points[i + 1].at;
            cut.length += glm::distance(a, b) / scale;
            if (!is_straight[i]) continue;
            const double worst = std::max({off_at(a), off_at(b), off_at(0.5 * (a + b))});
            if (worst < most_off)
                cut.off = std::max(cut.off, worst);
            else
                cut.straight += glm::distance(a, b) / scale;
        }
    }
    return cut;
}

/// A plane beside the axis of a cone cuts it along a hyperbola, and a torus along curves of the
/// fourth order.
TEST_F(RoundThings, OtherCutsAreSmoothCurves) {
    constexpr double beside = 3, most_off = 0.05;
    for (const glm::ivec2 size : {glm::ivec2{1024, 768}, glm::ivec2{4000, 3000}}) {
        const auto cut = [&](const TopoDS_Shape& shape, double y, const auto& off) {
            const VectorDrawing drawn =
                drawing("a.brep", to_brep(shape), "front", size, Projection::orthographic,
                        {{.point = {0, y, 0}, .normal = {0, -1, 0}}});
            const double scale = scale_of(view_, size.y);
            // The plane is nearer to the eye than the target, which a parallel view does not see.
            const Cut found = cut_of(drawn, view_, scale, most_off / scale, [&](glm::dvec3 at) {
                return off(glm::dvec3{at.x, y, at.z});
            });
            EXPECT_LT(found.off * scale, most_off);
            return found;
        };
        const double wide =
            cut(BRepPrimAPI_MakeCone(10, 0, 20).Shape(), -beside, [](glm::dvec3 at) {
                return (std::hypot(at.x, at.y) - (10 - 0.5 * at.z)) * std::cos(std::atan(0.5));
            }).straight;
        EXPECT_NEAR(wide, 2 * std::sqrt(100 - beside * beside), 1e-3); // of the base
        const double slender =
            cut(BRepPrimAPI_MakeCone(10, 0, 60).Shape(), -beside, [](glm::dvec3 at) {
                return (std::hypot(at.x, at.y) - (10 - at.z / 6)) * std::cos(std::atan(1.0 / 6));
            }).straight;
        EXPECT_NEAR(slender, 2 * std::sqrt(100 - beside * beside), 1e-3);
        const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(20, 5).Shape();
        for (const double y : {-5.0, -15.0, -17.0, -22.0}) {
            SCOPED_TRACE(y);
            const Cut found = cut(torus, y, [](glm::dvec3 at) {
                return std::hypot(std::hypot(at.x, at.y) - 20, at.z) - 5;
            });
            EXPECT_EQ(found.straight, 0);
            const double width = std::sqrt(625 - y * y),
                         hole = std::sqrt(std::max(225 - y * y, 0.0));
            EXPECT_GT(found.length, 4 * (width - hole));
        }
    }
}

TEST_F(RoundThings, ASectionAslantIsOneEllipse) {
    const double share = std::tan(std::numbers::pi / 6);
    VectorDrawing drawn =
        drawing("a.brep", to_brep(rounded_cylinder()), "isometric", {1000, 800},
                Projection::orthographic, {{.point = {0, 0, 14}, .normal = {share, 0, 1}}});
    std::erase_if(drawn.paths, [](const VectorPath& path) {
        return !path.visible || path.kind != LineKind::section;
    });
    ASSERT_EQ(drawn.paths.size(), 1U);
    EXPECT_TRUE(drawn.paths[0].closed);
    ASSERT_EQ(drawn.paths[0].curves.size(), 1U);
    EXPECT_FALSE(drawn.paths[0].curves[0].cubic);
    EXPECT_NEAR(std::abs(drawn.paths[0].curves[0].arc.sweep), 2 * std::numbers::pi, 1e-9);
}

/// SVG has the names of edges and faces from the file.
TEST_F(RoundThings, TagsNameEntities) {
    const std::string step =
        to_step({{"pin", BRepPrimAPI_MakeCylinder(2, 8).Shape(), {gp_Trsf{}}}});
    const VectorDrawing pin =
        drawing("a.step", step, "isometric", {400, 300}, Projection::orthographic);
    const std::string svg = to_svg(pin);
    const auto is_of = [&](const std::string& entity, const std::string& type) {
        const std::size_t at = step.find("\n" + entity + " = " + type);
        return at != std::string::npos;
    };
    std::size_t edges = 0, faces = 0;
    const std::string before = "entity ";
    for (std::size_t at = svg.find(before); at != std::string::npos;
         at = svg.find(before, at + 1)) {
        const std::size_t begin = at + before.size();
        const std::string entity = svg.substr(begin, svg.find(';', begin) - begin);
        edges += is_of(entity, "EDGE_CURVE") ? 1 : 0;
        faces += is_of(entity, "ADVANCED_FACE") ? 1 : 0;
    }
    EXPECT_GE(edges, 2U); // the rims
    EXPECT_GE(faces, 2U); // the silhouettes of its side
    // DXF has the names as extended data of every entity.
    const std::string dxf = to_dxf(pin);
    std::size_t named = 0;
    const std::string data = "1001\nLINEATLAS\n1000\nentity #";
    for (std::size_t at = dxf.find(data); at != std::string::npos; at = dxf.find(data, at + 1))
        ++named;
    EXPECT_EQ(named, pin.paths.size());
}

/// A solid of one degenerate torus about an axis along x through (1, 2, 3).
std::string degenerate_torus(const std::string& select_outer) {
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
           "FILE_NAME('','',(''),(''),'','','');\n"
           "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n"
           "#1=APPLICATION_CONTEXT('automotive design');\n"
           "#2=PRODUCT_CONTEXT('',#1,'mechanical');\n"
           "#3=PRODUCT('part','part','',(#2));\n"
           "#4=PRODUCT_DEFINITION_FORMATION('','',#3);\n"
           "#5=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');\n"
           "#6=PRODUCT_DEFINITION('design','',#4,#5);\n"
           "#7=PRODUCT_DEFINITION_SHAPE('','',#6);\n"
           "#8=SHAPE_DEFINITION_REPRESENTATION(#7,#9);\n"
           "#9=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#20),#10);\n"
           "#10=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#11,#12,#13))"
           "REPRESENTATION_CONTEXT('',''));\n"
           "#11=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.));\n"
           "#12=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));\n"
           "#13=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());\n"
           "#20=MANIFOLD_SOLID_BREP('',#21);\n#21=CLOSED_SHELL('',(#22));\n"
           "#22=ADVANCED_FACE('',(#23),#26,.T.);\n#23=FACE_BOUND('',#24,.T.);\n"
           "#24=VERTEX_LOOP('',#25);\n#25=VERTEX_POINT('',#30);\n"
           "#26=DEGENERATE_TOROIDAL_SURFACE('',#27,3.,5.," +
           select_outer +
           ");\n#27=AXIS2_PLACEMENT_3D('',#28,#29,$);\n"
           "#28=CARTESIAN_POINT('',(1.,2.,3.));\n#29=DIRECTION('',(1.,0.,0.));\n"
           "#30=CARTESIAN_POINT('',(5.,2.,3.));\nENDSEC;\nEND-ISO-10303-21;\n";
}

TEST_F(RoundThings, ADegenerateTorusIsTheAppleOrTheLemon) {
    struct Part {
        const char* select_outer;
        glm::vec3 half_size; ///< millimetres
    };
    for (const Part& part : {Part{".F.", {40, 20, 20}}, Part{".T.", {50, 80, 80}}}) {
        SCOPED_TRACE(part.select_outer);
        const Bounds box = bounds_of(load("a.step", degenerate_torus(part.select_outer)).mesh);
        const glm::vec3 middle{10, 20, 30};
        EXPECT_LT(glm::distance(box.min, middle - part.half_size), 0.1F);
        EXPECT_LT(glm::distance(box.max, middle + part.half_size), 0.1F);
    }
}

} // namespace
} // namespace lineatlas::test
