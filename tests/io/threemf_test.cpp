// 3MF packages with known parts, and wrong packages.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <unistd.h>

#include "io/isolated.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/lines.hpp"
#include "mesh_volume.hpp"
#include "threemf_files.hpp"

namespace fs = std::filesystem;

namespace lineatlas::test {
namespace {

const std::string one_item = R"(<item objectid="1"/>)";

class ThreeMf : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("lineatlas_3mf_" + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    LoadedMesh load(std::string_view package) const {
        std::ofstream(path(), std::ios::binary) << package;
        return load_mesh_isolated(path(), limits_);
    }
    LoadedMesh load_model(const std::string& resources, const std::string& items,
                          const std::string& attributes = R"(unit="millimeter")") const {
        return load(to_3mf(threemf_model(resources, items, attributes)));
    }

    /// The reason why a package is refused, without the file's name; empty if it is read.
    std::string cause(std::string_view package) const {
        try {
            const LoadedMesh loaded = load(package);
            extract_lines(loaded.mesh);
            return {};
        } catch (const FileError& error) {
            const std::string message = error.what();
            const std::string begin = "cannot read \"" + path().string() + "\": ";
            EXPECT_TRUE(message.starts_with(begin)) << message;
            EXPECT_EQ(message.find('\n'), message.npos) << message;
            return message.substr(begin.size());
        }
    }
    std::string cause_of_model(const std::string& resources, const std::string& items,
                               const std::string& attributes = {}) const {
        return cause(to_3mf(threemf_model(resources, items, attributes)));
    }

    fs::path path() const { return folder_ / "a.3mf"; }

    fs::path folder_;
    ReadLimits limits_;
};

TEST_F(ThreeMf, ACubeHasItsNameUnitAndPlace) {
    const LoadedMesh loaded = load_model(
        cube_object(1, "Cube \xC3\xA9 &amp; co"),
        R"(<item objectid="1" transform="2 0 0 0 1 0 0 0 1 10 20 30"/>)", R"(unit="inch")");
    EXPECT_EQ(loaded.format, "3MF");
    EXPECT_EQ(loaded.unit, 25.4);
    EXPECT_EQ(loaded.up, (glm::vec3{0, 0, 1}));
    ASSERT_EQ(loaded.parts.size(), 1U);
    EXPECT_EQ(loaded.parts[0].name, "Cube \xC3\xA9 & co");
    EXPECT_EQ(loaded.parts[0].object, 0U);
    EXPECT_EQ(loaded.mesh.triangles.size(), 12U);
    EXPECT_EQ(bounds_of(loaded.mesh).min, (glm::vec3{10, 20, 30}));
    EXPECT_EQ(bounds_of(loaded.mesh).max, (glm::vec3{12, 21, 31}));
    EXPECT_NEAR(volume(loaded.mesh), 2, 1e-3);
    EXPECT_EQ(extract_lines(loaded.mesh).kind_counts[LA_KIND_CREASE], 12U);
}

TEST_F(ThreeMf, UnitsAreThoseOfTheSpecification) {
    const auto unit = [&](const std::string& attributes) {
        return load_model(cube_object(1, "a"), one_item, attributes).unit;
    };
    EXPECT_EQ(unit(""), 1); // the unit of the specification
    EXPECT_EQ(unit(R"(unit="micron")"), 0.001);
    EXPECT_EQ(unit(R"(unit="centimeter")"), 10);
    EXPECT_EQ(unit(R"(unit="foot")"), 304.8);
    EXPECT_EQ(unit(R"(unit="meter")"), 1000);
    EXPECT_EQ(
        cause_of_model(cube_object(1, "a"), one_item, R"(unit="furlong")"),
        "its unit of length is unknown; 3MF has micron, millimeter, centimeter, inch, foot and "
        "meter");
}

TEST_F(ThreeMf, ComponentsAreATreeOfPlacedParts) {
    // A pair of bolts, the second mirrored, in a rack of two pairs.
    const LoadedMesh loaded = load_model(
        cube_object(1, "bolt") + R"(<object id="2" name="pair"><components>)" +
            R"(<component objectid="1" transform="1 0 0 0 1 0 0 0 1 0 0 0"/>)" +
            R"(<component objectid="1" transform="-1 0 0 0 1 0 0 0 1 4 0 0"/>)" +
            R"(</components></object><object id="3"><components><component objectid="2"/>)" +
            R"(<component objectid="2" transform="0 1 0 -1 0 0 0 0 1 0 10 0"/>)" +
            R"(</components></object>)",
        R"(<item objectid="3" transform="1 0 0 0 1 0 0 0 1 0 0 5"/>)");
    ASSERT_EQ(loaded.parts.size(), 7U);
    EXPECT_EQ(loaded.parts[0].name, "object 3");
    EXPECT_EQ(loaded.parts[0].object, ModelPart::none);
    EXPECT_EQ(loaded.parts[1].name, "pair");
    EXPECT_EQ(loaded.parts[1].parent, 0U);
    EXPECT_EQ(loaded.parts[3].name, "bolt");
    EXPECT_EQ(loaded.parts[3].parent, 1U);
    EXPECT_EQ(loaded.parts[4].parent, 0U);
    EXPECT_EQ(loaded.parts[2].shape, loaded.parts[6].shape);
    EXPECT_EQ(loaded.mesh.groups[0].object, "object 3/pair/bolt");
    EXPECT_EQ(loaded.mesh.triangles.size(), 48U);
    EXPECT_NEAR(volume(loaded.mesh), 4, 1e-3); // no cube is inside out
    // The matrix turns x into y and y into -x. It is written in rows, as in the specification.
    EXPECT_EQ(bounds_of(loaded.mesh).min, (glm::vec3{-1, 0, 5}));
    EXPECT_EQ(bounds_of(loaded.mesh).max, (glm::vec3{4, 14, 6}));
}

TEST_F(ThreeMf, MaterialsAndColoursAreThoseOfTheTriangles) {
    const std::string materials =
        R"(<basematerials id="5"><base name="Steel" displaycolor="#336699"/>)"
        R"(<base name="Brass" displaycolor="#CC9900FF"/></basematerials>)"
        R"(<m:colorgroup id="6"><m:color color="#FF0000"/><m:color color="#0000FF"/>)"
        R"(</m:colorgroup>)";
    const auto groups = [&](const std::string& of_object, const std::string& of_triangles) {
        return load_model(materials + cube_object(1, "a", of_object, of_triangles), one_item)
            .mesh.groups;
    };
    const auto brass = groups(R"(pid="5" pindex="1")", "");
    ASSERT_EQ(brass.size(), 1U);
    EXPECT_EQ(brass[0].material, "Brass");
    EXPECT_EQ(brass[0].color, (glm::vec3{0xCC, 0x99, 0} / 255.0F));
    const auto steel = groups(R"(pid="5" pindex="1")", R"(pid="5" p1="0")");
    ASSERT_EQ(steel.size(), 1U);
    EXPECT_EQ(steel[0].material, "Steel");
    EXPECT_EQ(steel[0].color, (glm::vec3{0x33, 0x66, 0x99} / 255.0F));
    const auto blue = groups("", R"(pid="6" p1="1" p2="1" p3="1")");
    ASSERT_EQ(blue.size(), 1U);
    EXPECT_EQ(blue[0].color, (glm::vec3{0, 0, 1}));
    const auto mixed = groups("", R"(pid="6" p1="0" p2="1" p3="1")");
    ASSERT_EQ(mixed.size(), 1U);
    EXPECT_EQ(mixed[0].color, (glm::vec3{85, 0, 170} / 255.0F));
    const auto none = groups("", "");
    ASSERT_EQ(none.size(), 1U);
    EXPECT_EQ(none[0].color, std::nullopt);
}

TEST_F(ThreeMf, ObjectsOfOtherPartsOfThePackageAreRead) {
    const std::string production =
        R"(xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" )"
        R"(requiredextensions="p")";
    std::vector<ZipPart> parts = package_parts();
    parts.push_back(
        {"3D/3dmodel.model", threemf_model(R"(<object id="7" name="whole"><components>)"
                                           R"(<component objectid="1" p:path="/3D/other.model"/>)"
                                           R"(</components></object>)",
                                           R"(<item objectid="7"/>)", production)});
    parts.push_back({"3D/_rels/3dmodel.model.rels",
                     R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/other.model" Id="rel1"
 Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"});
    parts.push_back({"3D/other.model", threemf_model(cube_object(1, "elsewhere"), "", production)});
    for (const std::string& package : {to_zip(parts), to_packed_zip(parts)}) {
        const LoadedMesh loaded = load(package);
        ASSERT_EQ(loaded.parts.size(), 2U);
        EXPECT_EQ(loaded.parts[1].name, "elsewhere");
        EXPECT_EQ(loaded.mesh.triangles.size(), 12U);
    }
}

TEST_F(ThreeMf, WhatIsNotSupportedIsRefusedByName) {
    const auto required = [&](const std::string& space) {
        return cause_of_model(cube_object(1, "a"), one_item,
                              "xmlns:x=\"" + space + R"(" requiredextensions="m x")");
    };
    EXPECT_EQ(required("http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02"),
              "it requires the 3MF extension beam lattices "
              "(http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02), which is not "
              "supported");
    EXPECT_EQ(required("http://schemas.microsoft.com/3dmanufacturing/slice/2015/07"),
              "it requires the 3MF extension slices "
              "(http://schemas.microsoft.com/3dmanufacturing/slice/2015/07), which is not "
              "supported");
    EXPECT_EQ(required("urn:somebody"),
              "it requires the 3MF extension urn:somebody, which is not supported");
    EXPECT_EQ(cause_of_model(cube_object(1, "a"), one_item, R"(requiredextensions="zz")"),
              "it requires the extension \"zz\", which it does not declare");
    // Other text comes before the first tag.
    std::string hidden =
        threemf_model(cube_object(1, "a"), one_item, R"(xmlns:x="urn:x" requiredextensions="x")");
    hidden.insert(hidden.find("<model"), "<!-- <model > --><?other <model ?>");
    EXPECT_EQ(cause(to_3mf(hidden)), "it requires the 3MF extension urn:x, which is not supported");
    // The file has beams but does not require that they are read.
    std::string beams = cube_object(1, "a");
    beams.insert(beams.find("</mesh>"), R"(<b:beamlattice radius="0.1" minlength="0.01"><b:beams>)"
                                        R"(<b:beam v1="0" v2="7"/></b:beams></b:beamlattice>)");
    EXPECT_EQ(cause_of_model(
                  beams, one_item,
                  R"(xmlns:b="http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02")"),
              "it has beam lattices, which are not supported");
}

TEST_F(ThreeMf, SlicesBesideAMeshAreSaid) {
    std::string object = cube_object(2, "a");
    object.insert(object.find("<object") + 7, R"( s:slicestackid="1")");
    const std::string slices = R"(<s:slicestack id="1" zbottom="0"><s:slice ztop="1"><s:vertices>)"
                               R"(<s:vertex x="0" y="0"/><s:vertex x="1" y="0"/>)"
                               R"(<s:vertex x="0" y="1"/></s:vertices><s:polygon startv="0">)"
                               R"(<s:segment v2="1"/><s:segment v2="2"/><s:segment v2="0"/>)"
                               R"(</s:polygon></s:slice></s:slicestack>)";
    const LoadedMesh loaded =
        load_model(slices + object, R"(<item objectid="2"/><item objectid="2"/>)",
                   R"(xmlns:s="http://schemas.microsoft.com/3dmanufacturing/slice/2015/07")");
    EXPECT_EQ(loaded.mesh.triangles.size(), 24U);
    ASSERT_EQ(loaded.notes.size(), 1U);
    EXPECT_EQ(loaded.notes[0], "slices of 1 object are not read; what is drawn is its mesh, which "
                               "may be coarser");
}

TEST_F(ThreeMf, BrokenPackagesAreRefusedInALine) {
    const std::string cube = cube_object(1, "a");
    const std::string whole = to_3mf(threemf_model(cube, one_item));
    ASSERT_EQ(cause(whole), "");
    for (std::size_t size = 1; size < whole.size(); size += 1 + whole.size() / 20)
        EXPECT_NE(cause(std::string_view{whole}.substr(0, size)), "") << size;
    EXPECT_NE(cause(whole.substr(1)), "");
    EXPECT_NE(cause("PK\3\4"), "");
    EXPECT_NE(cause(std::string(1000, '\0')), "");
    EXPECT_NE(cause("<?xml version=\"1.0\"?><model/>"), "");
    EXPECT_NE(cause(to_zip({})), "");
    // A byte of the model is changed, so that the checksum is wrong.
    std::string damaged = whole;
    damaged[damaged.find("<vertex x=\"1\"") + 11] = '7';
    EXPECT_NE(cause(damaged), "");

    std::vector<ZipPart> parts = package_parts();
    EXPECT_NE(cause(to_zip(parts)), ""); // a relation to a missing part
    const ZipPart model{"3D/3dmodel.model", threemf_model(cube, one_item)};
    EXPECT_NE(cause(to_zip({parts[0], model})), ""); // no relation
    parts[1].bytes = parts[1].bytes.replace(parts[1].bytes.find("3dmanufacturing"), 3, "4d_");
    parts.push_back(model);
    EXPECT_NE(cause(to_zip(parts)), ""); // a relation of another kind
    parts[1].bytes = std::string(100'000, '<');
    EXPECT_NE(cause(to_zip(parts)), "");
}

TEST_F(ThreeMf, BrokenModelsAreRefusedInALine) {
    const std::string cube = cube_object(1, "a");
    const auto changed = [&](const std::string& what, const std::string& by) {
        std::string model = threemf_model(cube, one_item);
        const std::size_t at = model.find(what);
        EXPECT_NE(at, model.npos) << what;
        return cause(to_3mf(model.replace(at, what.size(), by)));
    };
    EXPECT_NE(cause(to_3mf("")), "");
    EXPECT_NE(cause(to_3mf("<html/>")), "");
    for (const char* begin : {"\r<model", "<model ", "<model x", "<model x=", "<model x=\""})
        EXPECT_NE(cause(to_3mf(begin)), "") << begin;
    EXPECT_NE(cause(to_3mf("<?xml version=\"1.0\"?><mesh/>")), "");
    EXPECT_NE(changed("<build>" + one_item, "<build>"), "");
    EXPECT_NE(changed("<build>" + one_item + "</build>", ""), "");
    EXPECT_NE(changed("x=\"0\"", "x=\"nan\""), "");
    EXPECT_NE(changed("x=\"0\"", "x=\"1e400\""), "");
    EXPECT_NE(changed("x=\"0\"", ""), "");
    EXPECT_NE(changed("v1=\"0\"", "v1=\"8\""), "");
    EXPECT_NE(changed("v1=\"0\"", "v1=\"-1\""), "");
    EXPECT_NE(changed("v1=\"0\"", "v1=\"4000000000\""), "");
    EXPECT_NE(changed("v1=\"0\"", ""), "");
    EXPECT_NE(changed("objectid=\"1\"", "objectid=\"2\""), "");
    EXPECT_NE(changed("objectid=\"1\"", "objectid=\"1\" transform=\"1 0 0\""), "");
    EXPECT_NE(changed("id=\"1\"", "id=\"99999999999999999999\""), "");
    EXPECT_NE(changed("</triangles>", ""), "");
}

TEST_F(ThreeMf, ComponentsThatHoldThemselvesOrThousandsAreRefused) {
    const auto holding = [](int id, int other, int times) {
        std::string object = "<object id=\"" + std::to_string(id) + "\"><components>";
        for (int i = 0; i < times; ++i)
            object += "<component objectid=\"" + std::to_string(other) + "\"/>";
        return object + "</components></object>";
    };
    const std::string cube = cube_object(1, "a"), item = R"(<item objectid="2"/>)";
    EXPECT_NE(cause_of_model(cube + holding(2, 2, 1), item), "");
    EXPECT_NE(cause_of_model(cube + holding(2, 3, 1) + holding(3, 2, 1), item), "");
    // Ten of ten of ten...
    std::string many = cube;
    for (int level = 2; level <= 12; ++level) many += holding(level, level - 1, 10);
    EXPECT_EQ(cause_of_model(many, R"(<item objectid="7"/>)"),
              "with all its components it has more than 262144 parts");
    // lib3mf itself visits all of them until its time ends.
    limits_.time = std::chrono::seconds{2};
    EXPECT_EQ(cause_of_model(many, R"(<item objectid="12"/>)"),
              "reading it took more than 2 s; LoadOptions::read_seconds allows more");
    limits_ = {};
    // One in one in one...
    std::string deep = cube;
    for (int level = 2; level <= 1000; ++level) deep += holding(level, level - 1, 1);
    EXPECT_NE(cause_of_model(deep, R"(<item objectid="1000"/>)"), "");
}

TEST_F(ThreeMf, BombsAreRefusedInALine) {
    constexpr std::size_t large = 150U << 20U;
    std::vector<ZipPart> parts = package_parts();
    std::string model = threemf_model(cube_object(1, "a"), one_item);
    model.insert(model.find("<build>"), large, ' ');
    parts.push_back({"3D/3dmodel.model", model});
    const std::string bomb = to_packed_zip(parts);
    ASSERT_LT(bomb.size(), 1U << 20U);
    EXPECT_TRUE(cause(bomb).starts_with("it would unpack to more than ")) << cause(bomb);
    // The part claims to be small.
    std::string liar = bomb;
    const auto four_bytes = [](std::size_t value) {
        std::string bytes;
        for (; bytes.size() < 4; value >>= 8U) bytes += static_cast<char>(value & 0xFFU);
        return bytes;
    };
    const std::string size = four_bytes(model.size());
    for (std::size_t at = liar.find(size); at != liar.npos; at = liar.find(size))
        liar.replace(at, 4, four_bytes(5000));
    EXPECT_NE(cause(liar), "");
    // Tags in tags, a million deep.
    std::string deep;
    for (int i = 0; i < 1'000'000; ++i) deep += "<a>";
    EXPECT_NE(cause_of_model(deep, one_item), "");
    EXPECT_NE(cause_of_model("<object id=\"1\">" + deep, one_item), "");
}

} // namespace
} // namespace lineatlas::test

int main(int argc, char** argv) {
    if (const auto code = lineatlas::serve_as_reader(argc, argv)) return *code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
