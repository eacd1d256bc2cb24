// IGES files of shapes with known edges, and other files.
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>

#include "brep_files.hpp"
#include "brep_fixture.hpp"

namespace lineatlas::test {
namespace {

class Iges : public Brep {
  protected:
    LoadedMesh load_shape(const TopoDS_Shape& shape, bool solids) const {
        return load("a.igs", to_iges({{"a", shape, {gp_Trsf{}}}}, solids));
    }
};

/// A cylinder around z with a hole along it.
TopoDS_Shape pipe() {
    return BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(3, 5).Shape(),
                           BRepPrimAPI_MakeCylinder(1, 5).Shape())
        .Shape();
}

TEST_F(Iges, EdgesAreOfTheirKinds) {
    for (const bool solids : {false, true}) {
        const auto edges = [&](const TopoDS_Shape& shape) {
            return edges_of(load_shape(shape, solids).mesh);
        };
        EXPECT_EQ(edges(BRepPrimAPI_MakeBox(1, 2, 3).Shape()), (EdgeCounts{12, 0, 0, 0}));
        EXPECT_EQ(edges(BRepPrimAPI_MakeCylinder(1, 2).Shape()), (EdgeCounts{2, 0, 1, 0}));
        EXPECT_EQ(edges(BRepPrimAPI_MakeSphere(1).Shape()), (EdgeCounts{0, 0, 1, 0}));
        EXPECT_EQ(edges(pipe()), (EdgeCounts{4, 0, 2, 0}));
    }
    const TopoDS_Shape face =
        TopExp_Explorer(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), TopAbs_FACE).Current();
    EXPECT_EQ(edges_of(load_shape(face, false).mesh), (EdgeCounts{0, 0, 0, 4}));
}

TEST_F(Iges, SurfacesBecomeBodiesThatLookOutwards) {
    for (const bool solids : {false, true}) {
        const LoadedMesh loaded = load_shape(pipe(), solids);
        EXPECT_NEAR(volume(loaded.mesh), 3.14159265 * 8 * 5, 3);
        EXPECT_NEAR(bounds_of(loaded.mesh).max.z, 5, 1e-4);
        EXPECT_EQ(extract_lines(loaded.mesh).kind_counts[LA_KIND_BOUNDARY], 0U);
    }
}

TEST_F(Iges, FacesInNoGroupAreOnePart) {
    // Each face is a separate entity at the top of the file.
    TopoDS_Compound faces;
    BRep_Builder builder;
    builder.MakeCompound(faces);
    std::vector<NamedShape> shapes;
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
    for (TopExp_Explorer each(box, TopAbs_FACE); each.More(); each.Next())
        shapes.push_back({"face", each.Current(), {gp_Trsf{}}});
    const LoadedMesh loaded = load("a.iges", to_iges(shapes, false));
    EXPECT_EQ(edges_of(loaded.mesh), (EdgeCounts{12, 0, 0, 0}));
    EXPECT_NEAR(volume(loaded.mesh), 6, 1e-3);
}

TEST_F(Iges, AssembliesKeepNamesPlacesAndColours) {
    gp_Trsf far, turned;
    far.SetTranslation(gp_Vec(100, 0, 0));
    turned.SetRotation(gp_Ax1(), 1.5707963267948966);
    for (const bool solids : {false, true}) {
        SCOPED_TRACE(solids);
        const LoadedMesh loaded = load(
            "a.iges",
            to_iges({{"Plate", BRepPrimAPI_MakeBox(10, 20, 1).Shape(), {gp_Trsf{}}, 0.25, 0.5, 1},
                     {"Pin", BRepPrimAPI_MakeCylinder(2, 8).Shape(), {far, turned}, 1, 0, 0}},
                    solids));
        EXPECT_EQ(loaded.format, "IGES 5.3");
        EXPECT_EQ(loaded.unit, 1);
        EXPECT_EQ(edges_of(loaded.mesh), (EdgeCounts{16, 0, 2, 0}));
        EXPECT_NEAR(volume(loaded.mesh), 200 + 2 * 100.53, 4);
        EXPECT_NEAR(bounds_of(loaded.mesh).max.x, 102, 0.1);
        ASSERT_EQ(loaded.parts.size(), 4U);
        EXPECT_EQ(loaded.parts[0].name, "assembly");
        EXPECT_EQ(loaded.parts[1].name, "Plate");
        EXPECT_EQ(loaded.parts[2].name, "Pin");
        EXPECT_EQ(loaded.parts[3].name, "Pin");
        EXPECT_EQ(loaded.parts[3].parent, 0U);
        ASSERT_EQ(loaded.mesh.groups.size(), 3U);
        ASSERT_TRUE(loaded.mesh.groups[0].color);
        EXPECT_NEAR(loaded.mesh.groups[0].color->x, 0.25, 0.01);
        EXPECT_NEAR(loaded.mesh.groups[0].color->y, 0.5, 0.01);
        ASSERT_TRUE(loaded.mesh.groups[2].color);
        EXPECT_NEAR(loaded.mesh.groups[2].color->x, 1, 0.01);
    }
}

TEST_F(Iges, ALoneFaceKeepsItsPlace) {
    gp_Trsf up;
    up.SetTranslation(gp_Vec(0, 0, 160));
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(30).Shape().Moved(TopLoc_Location(up));
    for (const bool solids : {false, true}) {
        SCOPED_TRACE(solids);
        const LoadedMesh loaded =
            load("a.igs", to_iges({{"ball", ball, {gp_Trsf{}}, 1, 0, 0}}, solids));
        const Bounds bounds = bounds_of(loaded.mesh);
        EXPECT_NEAR(bounds.min.z, 130, 0.1);
        EXPECT_NEAR(bounds.max.z, 190, 0.1);
        ASSERT_EQ(loaded.mesh.groups.size(), 1U);
        ASSERT_TRUE(loaded.mesh.groups[0].color);
        EXPECT_NEAR(loaded.mesh.groups[0].color->x, 1, 0.01);
        EXPECT_NEAR(loaded.mesh.groups[0].color->y, 0, 0.01);
    }
}

TEST_F(Iges, FacesSomeMicrometresApartAreSewn) {
    const auto edges_with_a_face_moved_by = [&](double gap) {
        std::vector<NamedShape> shapes;
        const TopoDS_Shape box = BRepPrimAPI_MakeBox(100, 200, 300).Shape();
        gp_Trsf away;
        away.SetTranslation(gp_Vec(0, 0, gap));
        for (TopExp_Explorer each(box, TopAbs_FACE); each.More(); each.Next())
            shapes.push_back({"face", each.Current(), {shapes.empty() ? away : gp_Trsf{}}});
        return edges_of(load("a.iges", to_iges(shapes, false)).mesh);
    };
    EXPECT_EQ(edges_with_a_face_moved_by(0.01), (EdgeCounts{12, 0, 0, 0}));
    EXPECT_EQ(edges_with_a_face_moved_by(1)[3], 8U) << "a gap that one sees stays";
}

TEST_F(Iges, InchesBecomeMillimetres) {
    const LoadedMesh loaded =
        load("a.igs", to_iges({{"box", BRepPrimAPI_MakeBox(25.4, 50.8, 1).Shape(), {gp_Trsf{}}}},
                              false, "INCH"));
    EXPECT_NEAR(bounds_of(loaded.mesh).max.y, 50.8, 1e-4);
    ASSERT_EQ(loaded.notes.size(), 1U);
    EXPECT_EQ(loaded.notes[0], "its lengths in inches are drawn in millimetres");
}

TEST_F(Iges, OtherContentIsRefused) {
    const std::string s(72, ' '), end = "S0000001T      1\n";
    EXPECT_FALSE(is_read("a.iges", "v 0 0 0\nf 1 1 1\n"));
    EXPECT_FALSE(is_read("a.iges", std::string(100'000, '(')));
    EXPECT_FALSE(is_read("a.iges", std::string(1000, '\0')));
    EXPECT_FALSE(is_read("a.iges", s + "S      1\n"));
    EXPECT_FALSE(is_read("a.iges", s + "S      1\n" + s + "G      1\n"));
    EXPECT_FALSE(is_read("a.iges", s + "S      1\n" + s + end));
    EXPECT_FALSE(is_read("a.iges", s + "C      1\n"));
    EXPECT_FALSE(is_read("a.iges", s + "B      1\n"));
    EXPECT_FALSE(is_read("a.iges", s + "S      1\n" + std::string(1'000'000, 'D')));
}

TEST_F(Iges, CutAnywhereItIsReadOrRefused) {
    const std::string iges =
        to_iges({{"pin", BRepPrimAPI_MakeCylinder(1, 2).Shape(), {gp_Trsf{}}}}, false);
    for (std::size_t size = 1; size < iges.size(); size += 1 + iges.size() / 15)
        is_read("a.iges", std::string_view{iges}.substr(0, size));
}

TEST_F(Iges, ChangedNumbersAreReadOrRefused) {
    const std::string iges =
        to_iges({{"pin", BRepPrimAPI_MakeCylinder(1, 2).Shape(), {gp_Trsf{}}}}, false);
    const auto changed = [&](const std::string& what, const std::string& by) {
        is_read_changed("a.iges", iges, what, by);
    };
    changed("     144", "     186");
    changed("     144", "     402");
    changed("     142", "     144");
    changed("     120", "     999");
    changed("     402", "     308");
    changed("144,", "142,");
    changed("120,", "128,");
    changed("0.,0.,", "1e,99");
    // Pointers to the entity itself, to one that contains it, and to none.
    changed(",1,", ",9,");
    changed(",3,", ",999999999,");
    changed(",5,", ",-5,");
    changed(",0,", ",1,");
}

} // namespace
} // namespace lineatlas::test
