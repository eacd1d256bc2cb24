// The surfaces of files of exact geometry. Their computed places are those of Open CASCADE's
// triangles, and their normals are its normals.
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include "brep_files.hpp"
#include "brep_fixture.hpp"
#include "lineatlas/error.hpp"
#include "surface/surface_point.hpp"

namespace lineatlas::test {
namespace {

class KnownSurfacesOfFiles : public Brep {
  protected:
    /// Expects that every triangle has a surface. The surface goes through the triangle's corners
    /// with their normals, and its derivatives are right.
    static void check(const Mesh& mesh) {
        const KnownSurfaces& known = mesh.surfaces;
        ASSERT_EQ(known.of_triangle.size(), mesh.triangles.size());
        ASSERT_TRUE(is_sound(known, mesh.triangles.size()));
        int normals = 0;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            ASSERT_NE(known.of_triangle[i], KnownSurfaces::none);
            const PlacedSurface& surface = known.surfaces[known.of_triangle[i]];
            const SurfaceShape& shape = known.shapes[surface.shape];
            const glm::dmat3 turn =
                glm::transpose(glm::inverse(glm::dmat3{surface.model_from_shape}));
            for (std::size_t k = 0; k < 3; ++k) {
                const SurfacePoint point = evaluate(shape, known.parameters[i][k]);
                const glm::dvec3 place = surface.model_from_shape * glm::dvec4{point.at, 1};
                const glm::dvec3 corner{mesh.positions[mesh.triangles[i][static_cast<int>(k)]]};
                EXPECT_LT(glm::distance(place, corner), 1e-4);
                const glm::dvec3 expected{mesh.corner_normals[3 * i + k]};
                if (point.normal == glm::dvec3{0} || expected == glm::dvec3{0}) continue;
                const glm::dvec3 normal =
                    glm::normalize(turn * point.normal) * (surface.turned ? -1.0 : 1.0);
                EXPECT_LT(glm::distance(normal, expected), 1e-4);
                ++normals;
            }
            check_derivatives(
                shape,
                (known.parameters[i][0] + known.parameters[i][1] + known.parameters[i][2]) / 3.0);
        }
        EXPECT_GT(normals, 0);
    }

    /// Checks derivatives by differences.
    static void check_derivatives(const SurfaceShape& shape, glm::dvec2 at) {
        constexpr double step = 1e-5;
        const SurfacePoint point = evaluate(shape, at);
        if (point.normal == glm::dvec3{0}) return;
        for (int axis = 0; axis < 2; ++axis) {
            glm::dvec2 way{0};
            way[axis] = step;
            const SurfacePoint before = evaluate(shape, at - way),
                               after = evaluate(shape, at + way);
            const glm::dvec3 moved = (after.at - before.at) / (2 * step);
            const glm::dvec3 turned = (after.normal - before.normal) / (2 * step);
            const double size = 1 + glm::length(moved);
            EXPECT_LT(glm::distance(axis == 0 ? point.u : point.v, moved), 1e-4 * size);
            EXPECT_LT(glm::distance(axis == 0 ? point.normal_u : point.normal_v, turned),
                      1e-4 * (1 + glm::length(turned)));
        }
    }

    void check(const TopoDS_Shape& shape) const {
        check(load("a.brep", to_brep(shape), {.pixels = 100}).mesh);
    }

    static TopoDS_Shape face(const Handle(Geom_Surface) & surface, double u, double v) {
        return BRepBuilderAPI_MakeFace(surface, 0, u, 0, v, 1e-6).Shape();
    }
    static Handle(Geom_BSplineCurve) wave() {
        TColgp_Array1OfPnt poles(1, 5);
        for (int i = 1; i <= 5; ++i) poles(i) = gp_Pnt(3 + (i % 2), 0, i);
        TColStd_Array1OfReal knots(1, 3);
        TColStd_Array1OfInteger counts(1, 3);
        for (int i = 1; i <= 3; ++i) {
            knots(i) = 0.5 * (i - 1);
            counts(i) = i == 2 ? 1 : 4;
        }
        return new Geom_BSplineCurve(poles, knots, counts, 3);
    }
};

TEST_F(KnownSurfacesOfFiles, CylindersConesSpheresAndTori) {
    const gp_Ax2 aslant(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 2));
    check(BRepPrimAPI_MakeCylinder(aslant, 2, 5).Shape());
    check(BRepPrimAPI_MakeCone(aslant, 2, 0, 5).Shape());
    check(BRepPrimAPI_MakeCone(aslant, 1, 3, 5).Shape());
    check(BRepPrimAPI_MakeSphere(aslant, 2).Shape());
    check(BRepPrimAPI_MakeTorus(aslant, 4, 1).Shape());
}

TEST_F(KnownSurfacesOfFiles, SplinesAndSweptSurfaces) {
    check(BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(4, 1).Shape()).Shape());
    check(
        face(new Geom_SurfaceOfRevolution(wave(), gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))), 3, 1));
    check(face(new Geom_SurfaceOfLinearExtrusion(wave(), gp_Dir(0, 1, 1)), 1, 4));
    TColgp_Array2OfPnt poles(1, 4, 1, 3);
    for (int i = 1; i <= 4; ++i)
        for (int j = 1; j <= 3; ++j) poles(i, j) = gp_Pnt(i, j, i * j % 3);
    check(face(new Geom_BezierSurface(poles), 1, 1));
    check(face(new Geom_OffsetSurface(new Geom_BezierSurface(poles), 0.2), 1, 1));
}

/// A tube of a closed spline without weights, as CAD programs loft vases.
TEST_F(KnownSurfacesOfFiles, SplinesThatClose) {
    constexpr int around = 6;
    TColgp_Array2OfPnt poles(1, around, 1, 2);
    TColStd_Array1OfReal turns(1, around + 1), heights(1, 2);
    TColStd_Array1OfInteger once(1, around + 1), twice(1, 2);
    for (int i = 1; i <= around + 1; ++i) {
        turns(i) = i;
        once(i) = 1;
    }
    for (int j = 1; j <= 2; ++j) {
        heights(j) = j;
        twice(j) = 2;
        for (int i = 1; i <= around; ++i) {
            const double angle = 2 * std::numbers::pi * i / around;
            poles(i, j) = gp_Pnt(j * std::cos(angle), std::sin(angle), 3 * j);
        }
    }
    check(BRepBuilderAPI_MakeFace(
              new Geom_BSplineSurface(poles, turns, heights, once, twice, 2, 1, true, false), 1e-6)
              .Shape());
}

/// Surfaces at the places of parts in an assembly, also of a mirrored part.
TEST_F(KnownSurfacesOfFiles, StandWhereTheirPartsDo) {
    gp_Trsf turned, mirrored;
    turned.SetRotation(gp_Ax1(gp_Pnt(1, 0, 0), gp_Dir(1, 2, 3)), 0.7);
    turned.SetTranslationPart(gp_Vec(20, 0, 0));
    mirrored.SetMirror(gp_Ax2(gp_Pnt(0, 9, 0), gp_Dir(0, 1, 0)));
    const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(4, 1).Shape();
    check(torus.Moved(turned));
    check(BRepBuilderAPI_Transform(torus, mirrored).Shape()); // its frames are left-handed
    const Mesh twice =
        load("a.step", to_step({{"ring", torus, {gp_Trsf(), turned}}}), {.pixels = 100}).mesh;
    EXPECT_EQ(twice.surfaces.shapes.size(), 1U);
    EXPECT_EQ(twice.surfaces.surfaces.size(), 2U);
    check(twice);
}

SurfaceShape net() {
    return {.kind = SurfaceShape::Kind::spline,
            .along_u = {.degree = 1, .knots = {0, 0, 1, 1}},
            .along_v = {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}},
            .poles = std::vector<glm::dvec4>(6, {1, 2, 3, 1})};
}

TEST(KnownSurfaces, SurfacesThatCannotBeEvaluatedAreRefused) {
    const auto sound = [](const SurfaceShape& shape) {
        return is_sound(
            {.shapes = {shape}, .surfaces = {{}}, .of_triangle = {0}, .parameters = {{}}}, 1);
    };
    EXPECT_TRUE(sound(net()));
    std::vector<SurfaceShape> wrong(9, net());
    wrong[0].along_u.degree = 0;
    wrong[1].along_v.degree = SplineDirection::most_degree + 1;
    wrong[2].along_v.knots = {0, 0, 1, 0, 1, 1};
    wrong[3].along_u.knots = {0, 0, 0, 0};
    wrong[4].poles.pop_back();
    wrong[5].poles[3].w = 0;
    wrong[6].poles[3].x = std::numeric_limits<double>::quiet_NaN();
    wrong[7].kind = static_cast<SurfaceShape::Kind>(3);
    wrong[8].along_u.knots.clear();
    for (const SurfaceShape& shape : wrong) EXPECT_FALSE(sound(shape));
    SurfaceShape revolution{.curve = {.kind = static_cast<SurfaceCurve::Kind>(3)}};
    EXPECT_FALSE(sound(revolution));
    revolution.curve.kind = SurfaceCurve::Kind::line;
    EXPECT_TRUE(sound(revolution));

    KnownSurfaces known{
        .shapes = {net()}, .surfaces = {{}}, .of_triangle = {0}, .parameters = {{}}};
    EXPECT_FALSE(is_sound(known, 2));
    known.of_triangle[0] = 1;
    EXPECT_FALSE(is_sound(known, 1));
    known.of_triangle[0] = KnownSurfaces::none;
    known.surfaces[0].shape = 1;
    EXPECT_FALSE(is_sound(known, 1));

    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.surfaces = known;
    EXPECT_THROW(extract_lines(mesh), UsageError);
}

} // namespace
} // namespace lineatlas::test
