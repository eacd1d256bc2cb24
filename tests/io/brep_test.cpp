// STEP and BREP files of shapes whose edges are known, and files that are none.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Ax1.hxx>

#include "brep_files.hpp"
#include "brep_fixture.hpp"

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
    EXPECT_GT(lines.kind_counts[LA_KIND_SILHOUETTE], 0U); // of the rounded edges
    for (const Segment& segment : lines.segments) {
        if ((segment.tag & LA_TAG_KIND_MASK) != LA_KIND_CREASE) continue;
        EXPECT_EQ(lines.vertices[segment.p].z, lines.vertices[segment.q].z); // no smooth one
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
        to_step({{"box", BRepPrimAPI_MakeBox(25.4, 50.8, 1).Shape(), {gp_Trsf{}}}}, "INCH");
    const LoadedMesh loaded = load("a.step", step);
    EXPECT_NEAR(bounds_of(loaded.mesh).max.y, 50.8, 1e-4);
    ASSERT_EQ(loaded.notes.size(), 1U);
    EXPECT_EQ(loaded.notes[0], "its lengths in inch are drawn in millimetres");
}

TEST_F(Brep, WhatIsNoneIsRefused) {
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
    // A part that is part of itself.
    // A part that is part of itself, and one that holds what holds it.
    changed("'','',#5,#27,$", "'','',#27,#27,$");
    changed("'','',#5,#27,$", "'','',#27,#5,$");
}

} // namespace
} // namespace lineatlas::test

int main(int argc, char** argv) {
    if (const auto code = lineatlas::serve_as_reader(argc, argv)) return *code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
