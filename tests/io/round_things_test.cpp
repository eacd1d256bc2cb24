// Silhouettes of exact round bodies, which are known, in views from all sides and in level views,
// where silhouettes are hardest to find.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <glm/geometric.hpp>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Trsf.hxx>

#include "brep_files.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"
#include "round_things_fixture.hpp"

namespace lineatlas::test {
namespace {

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
