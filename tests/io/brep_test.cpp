// STEP and BREP files of shapes with known edges, and other files.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

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
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec2.hpp>
#include <gp_Ax1.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>

#include "brep_files.hpp"
#include "brep_fixture.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/visibility.hpp"

namespace lineatlas::test {
namespace {

/// A box whose edges along z are rounded.
TopoDS_Shape rounded_box() {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 4, 4).Shape();
    BRepFilletAPI_MakeFillet fillet(box);
    for (TopExp_Explorer edges(box, TopAbs_EDGE); edges.More(); edges.Next()) {
        TopExp_Explorer corners(edges.Current(), TopAbs_VERTEX);
        const gp_Pnt first = BRep_Tool::Pnt(TopoDS::Vertex(corners.Current()));
        corners.Next();
        const gp_Pnt last = BRep_Tool::Pnt(TopoDS::Vertex(corners.Current()));
        if (std::abs(first.Z() - last.Z()) > 1) fillet.Add(1, TopoDS::Edge(edges.Current()));
    }
    return fillet.Shape();
}

TEST_F(Brep, PartsInOtherFilesAreNamed) {
    const std::string step =
        to_step_apart({{"Head", BRepPrimAPI_MakeBox(1, 2, 3).Shape(), {gp_Trsf{}}},
                       {"Tail", BRepPrimAPI_MakeCylinder(1, 2).Shape(), {gp_Trsf{}}}},
                      "part_");
    try {
        load("a.step", step);
        FAIL() << "read";
    } catch (const FileError& error) {
        EXPECT_NE(std::string_view{error.what()}.find(
                      R"(its parts are in other files, which are not read: "part_Head.stp", )"
                      R"("part_Tail.stp")"),
                  std::string_view::npos)
            << error.what();
    }
}

TEST_F(Brep, EdgesAreOfTheirKinds) {
    const auto edges = [&](const TopoDS_Shape& shape) {
        return edges_of(load("a.brep", to_brep(shape)).mesh);
    };
    EXPECT_EQ(edges(BRepPrimAPI_MakeBox(1, 2, 3).Shape()), (EdgeCounts{12, 0, 0, 0}));
    EXPECT_EQ(edges(BRepPrimAPI_MakeCylinder(1, 2).Shape()), (EdgeCounts{2, 0, 1, 0}));
    EXPECT_EQ(edges(BRepPrimAPI_MakeSphere(1).Shape()), (EdgeCounts{0, 0, 1, 0}));
    EXPECT_EQ(edges(BRepPrimAPI_MakeCone(1, 0, 2).Shape()), (EdgeCounts{1, 0, 1, 0}));
    EXPECT_EQ(edges(rounded_box()), (EdgeCounts{16, 8, 0, 0}));
    const TopoDS_Shape face =
        TopExp_Explorer(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), TopAbs_FACE).Current();
    EXPECT_EQ(edges(face), (EdgeCounts{0, 0, 0, 4}));
}

TEST_F(Brep, LinesAreTheFilesEdges) {
    const LoadedMesh loaded = load("a.brep", to_brep(rounded_box()));
    LineOptions options;
    const LineSet lines = extract_lines(loaded.mesh, options);
    EXPECT_EQ(lines.kind_counts[LA_KIND_BOUNDARY], 0U);
    EXPECT_GT(lines.kind_counts[LA_KIND_SILHOUETTE], 0U); // silhouettes of the rounded edges
    for (const Segment& segment : lines.segments) {
        if ((segment.tag & LA_TAG_KIND_MASK) != LA_KIND_CREASE) continue;
        EXPECT_EQ(lines.vertices[segment.p].z, lines.vertices[segment.q].z); // no smooth edge
    }
    options.smooth_edges = true;
    EXPECT_EQ(extract_lines(loaded.mesh, options).kind_counts[LA_KIND_CREASE],
              lines.kind_counts[LA_KIND_CREASE] + 8);
}

TEST_F(Brep, FacesMeetToTheBit) {
    for (const TopoDS_Shape& shape :
         {BRepPrimAPI_MakeCylinder(1, 2).Shape(), BRepPrimAPI_MakeSphere(1).Shape(),
          BRepPrimAPI_MakeCone(1, 0, 2).Shape(), rounded_box()}) {
        const LineSet lines = extract_lines(load("a.brep", to_brep(shape)).mesh);
        EXPECT_EQ(lines.kind_counts[LA_KIND_BOUNDARY], 0U);
    }
}

TEST_F(Brep, ACircleHas24ChordsAtLeast) {
    const LoadedMesh loaded = load("a.brep", to_brep(BRepPrimAPI_MakeCylinder(1, 200).Shape()));
    const LineSet lines = extract_lines(loaded.mesh);
    EXPECT_GE(lines.kind_counts[LA_KIND_CREASE], 48U);
    EXPECT_NEAR(volume(loaded.mesh), 200 * 3.14159265, 10);
}

// Watson's algorithm takes time and memory by the square of the number of holes in a face: 330 MB
// for these.
TEST_F(Brep, AFaceWithManyHolesNeedsLittleMemory) {
    constexpr int side = 20;
    const fs::path path = folder_ / "plate.brep";
    std::ofstream(path) << to_brep(perforated_plate(side));
    const ReadLimits limits{.memory = std::uint64_t{150} << 20U};
    const LoadedMesh loaded = load_mesh_isolated(path, limits, {.pixels = 1700});
    EXPECT_TRUE(loaded.notes.empty());
    EXPECT_EQ(edges_of(loaded.mesh), (EdgeCounts{2 * side * side + 12, 0, side * side, 0}));
    constexpr double hole = std::numbers::pi * 0.3 * 0.3;
    EXPECT_NEAR(volume(loaded.mesh), side * side * (1 - hole), 0.01 * side * side * hole);
}

/// A star with spikes of many lengths, 10 thick, and its volume.
std::pair<TopoDS_Shape, double> star() {
    constexpr int corners = 65;
    constexpr double turn = 2 * std::numbers::pi / corners;
    std::vector<double> radii;
    std::uint32_t random = 1175;
    for (int i = 0; i < corners; ++i) {
        random = random * 1664525U + 1013904223U;
        radii.push_back(20 + 80 * (random >> 8U) * 0x1p-24);
    }
    BRepBuilderAPI_MakePolygon outline;
    double area = 0;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle = turn * static_cast<double>(i);
        outline.Add({radii[i] * std::cos(angle), radii[i] * std::sin(angle), 0});
        area += 0.5 * radii[i] * radii[(i + 1) % corners] * std::sin(turn);
    }
    outline.Close();
    const BRepBuilderAPI_MakeFace face(gp_Pln(gp::XOY()), outline.Wire());
    return {BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, 10)).Shape(), 10 * area};
}

// The faster one of Open CASCADE's two algorithms fills a bay of this star.
TEST_F(Brep, FacesEndWhereTheirEdgesRun) {
    const auto [shape, wanted] = star();
    const LoadedMesh loaded = load("star.brep", to_brep(shape));
    EXPECT_TRUE(loaded.notes.empty());
    EXPECT_NEAR(volume(loaded.mesh), wanted, 1e-5 * wanted);
    EXPECT_EQ(extract_lines(loaded.mesh).kind_counts[LA_KIND_BOUNDARY], 0U);
}

/// The largest error of the chords of a circle about the z axis, and the number of chords.
std::pair<double, std::size_t> chords(const Mesh& mesh, double radius, double z) {
    double most = 0;
    std::size_t count = 0;
    for (const KnownEdge& edge : mesh.known_edges) {
        const glm::dvec3 p{mesh.positions[edge.from]}, q{mesh.positions[edge.to]};
        if (std::abs(p.z - z) > 1e-4 || std::abs(q.z - z) > 1e-4) continue;
        most = std::max(most, radius - 0.5 * glm::length(glm::dvec2{p + q}));
        ++count;
    }
    return {most, count};
}

TEST_F(Brep, ChordsAreOffByAQuarterPixelAtMost) {
    constexpr double radius = 50;
    const std::string disc = to_brep(BRepPrimAPI_MakeCylinder(radius, 1).Shape());
    std::size_t before = 0;
    for (const double pixels : {1000.0, 4000.0, 16000.0}) {
        const LoadedMesh loaded = load("a.brep", disc, {.pixels = pixels});
        const double quarter = 0.25 * std::sqrt(2 * 100 * 100 + 1) / pixels;
        EXPECT_NEAR(loaded.deflection, quarter, 1e-3 * quarter);
        const auto [off, count] = chords(loaded.mesh, radius, 1);
        EXPECT_LE(off, 1.001 * quarter) << pixels;
        EXPECT_GT(off, 0.2 * quarter) << pixels; // no finer than necessary
        EXPECT_GT(count, before);
        before = count;
    }
    const LoadedMesh given = load("a.brep", disc, {.deflection = 0.1, .pixels = 16000});
    EXPECT_EQ(given.deflection, 0.1);
    EXPECT_LE(chords(given.mesh, radius, 1).first, 0.1);
    EXPECT_GT(chords(given.mesh, radius, 1).first, 0.02);
    EXPECT_THROW(load_mesh(folder_ / "a.brep", {.pixels = 0}), UsageError);
}

/// Calls `compare` with each corner of each triangle, the corner's normal and the triangle's
/// normal.
template <class Compare>
void for_each_normal(const Mesh& mesh, const Compare& compare) {
    ASSERT_EQ(mesh.corner_normals.size(), 3 * mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        const glm::vec3 a = mesh.positions[t.x], b = mesh.positions[t.y], c = mesh.positions[t.z];
        const glm::vec3 flat = glm::normalize(glm::cross(b - a, c - a));
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 normal = mesh.corner_normals[3 * i + static_cast<std::size_t>(k)];
            EXPECT_GT(glm::dot(normal, flat), 0.9F);
            compare(mesh.positions[t[k]], normal);
        }
    }
}

TEST_F(Brep, NormalsAreThoseOfTheSurface) {
    static constexpr float close = 1e-5F;
    // The poles have no normal, so places near them count.
    for_each_normal(load("a.brep", to_brep(BRepPrimAPI_MakeSphere(1).Shape())).mesh,
                    [](glm::vec3 place, glm::vec3 normal) {
                        EXPECT_LT(glm::distance(place, normal),
                                  std::abs(place.z) > 0.999F ? 2e-3F : close);
                    });
    const auto expect_round = [](glm::vec3 place, glm::vec3 normal) {
        if (std::abs(normal.z) > 0.5F) return;
        EXPECT_NEAR(normal.z, 0, close);
        EXPECT_LT(glm::distance(glm::vec2{place}, glm::vec2{normal}), close);
    };
    for_each_normal(load("a.brep", to_brep(BRepPrimAPI_MakeCylinder(1, 2).Shape())).mesh,
                    expect_round);
    // The shape is turned about its axis, and inside out.
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(), 1);
    const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 2).Shape();
    for_each_normal(load("a.brep", to_brep(cylinder.Located(TopLoc_Location(turn)))).mesh,
                    expect_round);
    for_each_normal(load("a.brep", to_brep(cylinder.Reversed())).mesh,
                    [&](glm::vec3 place, glm::vec3 normal) { expect_round(place, -normal); });
}

TEST_F(Brep, SmoothSilhouettesUseTheSurfacesNormals) {
    const Mesh mesh = load("a.brep", to_brep(BRepPrimAPI_MakeCone(2, 1, 3).Shape())).mesh;
    const LineSet lines = extract_lines(mesh, {.silhouettes = Silhouettes::smooth});
    const float slope = 1 / std::sqrt(10.0F);
    int round = 0;
    for (const auto& corner : lines.contours.corners) {
        if (std::abs(corner.normal[2]) > 0.9F) continue; // a corner of an end
        EXPECT_NEAR(corner.normal[2], slope, 1e-5F);
        const glm::vec2 place = glm::normalize(glm::vec2{lines.vertices[corner.vertex]});
        EXPECT_NEAR(corner.normal[0], place.x * 3 * slope, 1e-5F);
        EXPECT_NEAR(corner.normal[1], place.y * 3 * slope, 1e-5F);
        ++round;
    }
    EXPECT_GE(round, 48);
}

/// The silhouettes of a ring do not depend on the kind of surface in the file.
TEST_F(Brep, FreeFormSurfacesHaveSmoothSilhouettesToo) {
    const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(10, 4).Shape();
    View view;
    view.eye = {0, -60, 40};
    view.target = {0, 0, 0};
    view.up = {0, 0, 1};
    const auto seen = [&](const TopoDS_Shape& shape) {
        const Mesh mesh = load("a.brep", to_brep(shape), {.pixels = 1000}).mesh;
        const LineSet lines = extract_lines(mesh, {.silhouettes = Silhouettes::automatic});
        EXPECT_EQ(lines.contours.faces.size(), mesh.triangles.size());
        double length = 0;
        const Camera camera = make_camera(view, {1000, 750}, lines.bounds);
        for (const Interval& piece : LineVisibility{lines}.find(camera))
            length +=
                glm::distance(glm::make_vec3(piece.start_world), glm::make_vec3(piece.end_world));
        return length;
    };
    const double length = seen(ring);
    EXPECT_GT(length, 100);
    EXPECT_NEAR(seen(BRepBuilderAPI_NurbsConvert(ring).Shape()), length, 0.005 * length);
}

/// A face with kinks has edges there. The shape is a prism over an octagon with a single side face,
/// a spline of degree 1.
TEST_F(Brep, KinksOfAFaceAreEdges) {
    constexpr int count = 9;
    TColgp_Array1OfPnt points(1, count);
    TColStd_Array1OfReal knots(1, count);
    TColStd_Array1OfInteger multiplicities(1, count);
    for (int i = 0; i < count; ++i) {
        const double angle = i * 2 * std::numbers::pi / (count - 1);
        points(i + 1) = gp_Pnt(10 * std::cos(angle), 10 * std::sin(angle), 0);
        knots(i + 1) = i;
        multiplicities(i + 1) = i == 0 || i == count - 1 ? 2 : 1;
    }
    const Handle(Geom_BSplineCurve) octagon =
        new Geom_BSplineCurve(points, knots, multiplicities, 1);
    const TopoDS_Shape prism =
        BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeEdge(octagon).Edge(), gp_Vec(0, 0, 15)).Shape();
    const Mesh mesh = load("a.brep", to_brep(prism)).mesh;
    EXPECT_EQ(mesh.triangles.size(), 16U);
    const LineSet lines = extract_lines(mesh, {.silhouettes = Silhouettes::automatic});
    EXPECT_EQ(lines.kind_counts[LA_KIND_CREASE], 8U);
    EXPECT_EQ(lines.kind_counts[LA_KIND_BOUNDARY], 16U);
    EXPECT_TRUE(lines.contours.faces.empty()); // its parts are flat
}

/// A disc about a pillar. The disc's hole is as wide as the pillar, but has its chords at other
/// places. So each chord is partly within the pillar's chords and partly outside. The edge must
/// still be one piece.
TEST_F(Brep, FacesThatTouchAlongACurveDoNotTearIt) {
    constexpr double radius = 10, height = 8;
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(), 0.05);
    const gp_Pnt inner(radius, 0, height), outer(1.5 * radius, 0, height);
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeCylinder(radius, 2 * height).Shape());
    builder.Add(both, BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(inner, outer).Edge(), gp_Ax1())
                          .Shape()
                          .Located(TopLoc_Location(turn)));
    const LineSet lines = extract_lines(load("a.brep", to_brep(both), {.pixels = 1000}).mesh,
                                        {.silhouettes = Silhouettes::automatic});
    View view;
    view.eye = {0, -60, 50};
    view.target = {0, 0, 8};
    view.up = {0, 0, 1};
    const Camera camera = make_camera(view, {1000, 750}, lines.bounds);
    LineVisibility visibility{lines};
    // True on the half of the hole's edge that faces the eye.
    const auto is_in_front = [&](const Segment& segment) {
        const glm::vec3 p = lines.vertices[segment.p], q = lines.vertices[segment.q];
        return (segment.tag & LA_TAG_KIND_MASK) == static_cast<la_uint>(LineKind::boundary) &&
               glm::length(glm::vec2{p}) < 1.1 * radius && p.y + q.y < -0.8 * radius;
    };
    std::vector<double> seen(lines.segments.size());
    for (const Interval& piece : visibility.find(camera))
        seen[piece.segment] +=
            glm::distance(glm::make_vec3(piece.start_world), glm::make_vec3(piece.end_world));
    int in_front = 0;
    for (std::size_t i = 0; i < lines.segments.size(); ++i) {
        const Segment& segment = lines.segments[i];
        if (!is_in_front(segment)) continue;
        ++in_front;
        const float length = glm::distance(lines.vertices[segment.p], lines.vertices[segment.q]);
        EXPECT_NEAR(seen[i], length, 0.01 * length) << i;
    }
    EXPECT_GE(in_front, 8);
}

TEST_F(Brep, SolidsOfOneProductArePartsOfTheirOwn) {
    TopoDS_Compound both;
    const BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeBox(1, 2, 3).Shape());
    gp_Trsf beside;
    beside.SetTranslation(gp_Vec(5, 0, 0));
    builder.Add(both, BRepPrimAPI_MakeCylinder(1, 2).Shape().Moved(beside));
    const LoadedMesh step = load("a.stp", to_step({{"pair", both, {gp_Trsf{}}, 1, 0, 0}}));
    ASSERT_EQ(step.parts.size(), 4U);
    EXPECT_EQ(step.parts[1].name, "pair");
    EXPECT_EQ(step.parts[1].object, ModelPart::none);
    EXPECT_EQ(step.parts[2].parent, 1U);
    EXPECT_NE(step.parts[2].name, step.parts[3].name);
    EXPECT_EQ(step.parts[3].object, 1U);
    EXPECT_NEAR(volume(step.mesh), 6 + 2 * 3.1416, 0.1);
    EXPECT_NEAR(bounds_of(step.mesh).max.x, 6, 0.1);
    for (const MeshGroup& group : step.mesh.groups) {
        EXPECT_EQ(group.object.find("assembly/pair/"), 0U) << group.object;
        ASSERT_TRUE(group.color);
        EXPECT_NEAR(group.color->x, 1, 1e-5);
    }
    const LoadedMesh brep = load("a.brep", to_brep(both));
    ASSERT_EQ(brep.parts.size(), 3U);
    EXPECT_EQ(brep.parts[2].name, "body 2");
    EXPECT_EQ(load("b.brep", to_brep(BRepPrimAPI_MakeBox(1, 2, 3).Shape())).parts.size(), 1U);
}

TEST_F(Brep, AssembliesKeepNamesPlacesAndColours) {
    gp_Trsf far, turned;
    far.SetTranslation(gp_Vec(100, 0, 0));
    turned.SetRotation(gp_Ax1(), 1.5707963267948966);
    const std::string step = to_step(
        {{"Plate, large", BRepPrimAPI_MakeBox(10, 20, 1).Shape(), {gp_Trsf{}}, 0.25, 0.5, 1},
         {"Pin \xC3\xA9", BRepPrimAPI_MakeCylinder(2, 8).Shape(), {far, turned}, 1, 0, 0}});
    const LoadedMesh loaded = load("a.stp", step);
    EXPECT_EQ(loaded.format, "STEP AP214");
    EXPECT_EQ(loaded.unit, 1);
    ASSERT_EQ(loaded.parts.size(), 4U);
    EXPECT_EQ(loaded.parts[0].name, "assembly");
    EXPECT_EQ(loaded.parts[0].object, ModelPart::none);
    EXPECT_EQ(loaded.parts[1].name, "Plate, large");
    EXPECT_EQ(loaded.parts[2].name, "Pin \xC3\xA9");
    EXPECT_EQ(loaded.parts[3].name, "Pin \xC3\xA9");
    EXPECT_EQ(loaded.parts[2].shape, loaded.parts[3].shape);
    EXPECT_NE(loaded.parts[1].shape, loaded.parts[2].shape);
    EXPECT_EQ(edges_of(loaded.mesh), (EdgeCounts{16, 0, 2, 0}));
    EXPECT_NEAR(volume(loaded.mesh), 200 + 2 * 100.53, 4);
    EXPECT_NEAR(bounds_of(loaded.mesh).max.x, 102, 0.1);
    ASSERT_EQ(loaded.mesh.groups.size(), 3U);
    ASSERT_TRUE(loaded.mesh.groups[0].color);
    EXPECT_NEAR(loaded.mesh.groups[0].color->x, 0.25, 1e-5);
    EXPECT_NEAR(loaded.mesh.groups[0].color->y, 0.5, 1e-5);
    EXPECT_EQ(loaded.mesh.groups[1].object, "assembly/Pin \xC3\xA9");
}

TEST_F(Brep, InchesBecomeMillimetres) {
    const std::string step =
        in_inches(to_step({{"box", BRepPrimAPI_MakeBox(1, 2, 0.5).Shape(), {gp_Trsf{}}}}));
    const LoadedMesh loaded = load("a.step", step);
    EXPECT_NEAR(bounds_of(loaded.mesh).max.y, 50.8, 1e-4);
    ASSERT_EQ(loaded.notes.size(), 1U);
    EXPECT_EQ(loaded.notes[0], "its lengths in inch are drawn in millimetres");
}

TEST_F(Brep, OtherContentIsRefused) {
    for (const char* name : {"a.step", "a.brep"}) {
        EXPECT_FALSE(is_read(name, "v 0 0 0\nf 1 1 1\n"));
        EXPECT_FALSE(is_read(name, std::string(100'000, '(')));
        EXPECT_FALSE(is_read(name, std::string(1000, '\0')));
        EXPECT_FALSE(is_read(name, "ISO-10303-21;\n"));
        EXPECT_FALSE(is_read(name, "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\n"
                                   "END-ISO-10303-21;\n"));
        EXPECT_FALSE(is_read(name, "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra\n"
                                   "Locations 4000000000\n"));
        EXPECT_FALSE(is_read(name, "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=" +
                                       std::string(100'000, '(') + ";\nENDSEC;\n"));
    }
}

TEST_F(Brep, CutAnywhereItIsReadOrRefused) {
    const TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(1, 2).Shape();
    const std::string step = to_step({{"pin", shape, {gp_Trsf{}}}}), brep = to_brep(shape);
    for (std::size_t size = 1; size < step.size(); size += 1 + step.size() / 12)
        is_read("a.step", std::string_view{step}.substr(0, size));
    for (std::size_t size = 1; size < brep.size(); size += 1 + brep.size() / 12)
        is_read("a.brep", std::string_view{brep}.substr(0, size));
}

TEST_F(Brep, ChangedNumbersAreReadOrRefused) {
    const std::string step =
        to_step({{"pin", BRepPrimAPI_MakeCylinder(1, 2).Shape(), {gp_Trsf{}}}});
    const auto changed = [&](const std::string& what, const std::string& by) {
        is_read_changed("a.step", step, what, by);
    };
    changed("CARTESIAN_POINT('',(0.,0.,0.))", "CARTESIAN_POINT('',(NAN,0.,0.))");
    changed("CARTESIAN_POINT('',(0.,0.,0.))", "CARTESIAN_POINT('',(1e300,0.,1e-300))");
    changed("CARTESIAN_POINT('',(", "CARTESIAN_POINT('',((");
    changed("CYLINDRICAL_SURFACE", "CONICAL_SURFACE");
    changed("ADVANCED_FACE('',(#", "ADVANCED_FACE('',(#9");
    changed("CLOSED_SHELL", "OPEN_SHELL");
    changed("MANIFOLD_SOLID_BREP", "SOLID");
    changed(",#1", ",#2");
    changed(",#", ",#9999999999");
    changed("= NEXT_ASSEMBLY_USAGE_OCCURRENCE", "= PRODUCT_DEFINITION");
    // A part that is part of itself, and one that contains its own container. The numbers are those
    // of the writer.
    std::smatch use;
    ASSERT_TRUE(std::regex_search(
        step, use, std::regex{R"((NEXT_ASSEMBLY_USAGE_OCCURRENCE\([^#]*)#(\d+)(,\s*)#(\d+))"}));
    const auto used = [&](const std::string& whole, const std::string& part) {
        changed(use.str(), use.str(1) + '#' + whole + use.str(3) + '#' + part);
    };
    used(use.str(4), use.str(4));
    used(use.str(4), use.str(2));
}

} // namespace
} // namespace lineatlas::test

int main(int argc, char** argv) {
    if (const auto code = lineatlas::serve_as_reader(argc, argv)) return *code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
