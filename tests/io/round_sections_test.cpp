// Sections through exact round bodies: lines, arcs and smooth curves.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Edge.hxx>
#include <glm/geometric.hpp>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include "brep_files.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/section.hpp"
#include "lineatlas/vector.hpp"
#include "round_things_fixture.hpp"

namespace lineatlas::test {
namespace {

class RoundSections : public RoundThings {};

// The outline of the cut, seen at right angles to the plane.
TEST_F(RoundSections, SectionsAlongTheAxisAreLinesAndQuarters) {
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
TEST_F(RoundSections, SteepCutsOfAShaftKeepItsCorners) {
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
TEST_F(RoundSections, CutsOfATeeStayOnItsPipes) {
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
TEST_F(RoundSections, SectionsOfSplinesAreCurvesWhereTheyAreRound) {
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

TEST_F(RoundSections, ObliqueCutsOfSplinesAreSmoothCurves) {
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
TEST_F(RoundSections, ACutAcrossAChamferIsArcsAndLines) {
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
TEST_F(RoundSections, CurvesWithoutEllipsesMeetOthersWhereTheyCross) {
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
TEST_F(RoundSections, CutsAreDividedWhereTheyTurn) {
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
TEST_F(RoundSections, OtherCutsAreSmoothCurves) {
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

TEST_F(RoundSections, ASectionAslantIsOneEllipse) {
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

} // namespace
} // namespace lineatlas::test
