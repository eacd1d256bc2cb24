// glTF and GLB files that are made here. Their content is known, and wrong content is refused in
// one line.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include <glm/geometric.hpp>

#include "gltf_files.hpp"
#include "io/isolated.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/lines.hpp"
#include "mesh_volume.hpp"

namespace fs = std::filesystem;

namespace lineatlas::test {
namespace {

class Gltf : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("lineatlas_gltf_" + std::to_string(::getpid()));
        fs::create_directories(folder_ / "below");
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path file(const std::string& name, std::string_view content) const {
        const fs::path path = folder_ / name;
        std::ofstream(path, std::ios::binary) << content;
        return path;
    }
    LoadedMesh load(const std::string& name, std::string_view content) const {
        return load_mesh_isolated(file(name, content));
    }
    LoadedMesh load_cube(const std::string& nodes, const std::string& members = {}) const {
        return load("a.glb", to_glb(cube_json(nodes, "", members), cube_bytes()));
    }

    /// The message about the file, without its name.
    std::string refusal(const std::string& name, std::string_view content) const {
        const fs::path path = file(name, content);
        const std::string begin = "cannot read \"" + path.string() + "\": ";
        try {
            load_mesh_isolated(path);
        } catch (const FileError& error) {
            const std::string message = error.what();
            EXPECT_EQ(message.find('\n'), message.npos) << message;
            EXPECT_EQ(message.find(begin), 0U) << message;
            EXPECT_EQ(message.find("its reader"), message.npos) << message;
            return message.substr(std::min(begin.size(), message.size()));
        }
        ADD_FAILURE() << "accepted: " << content.substr(0, 300);
        return {};
    }

    fs::path folder_;
};

TEST_F(Gltf, ACubeIsACube) {
    const LoadedMesh loaded = load_cube(R"([{"mesh":0,"name":"cube"}])");
    EXPECT_EQ(loaded.mesh.triangles.size(), 12U);
    EXPECT_DOUBLE_EQ(volume(loaded.mesh), 1);
    EXPECT_EQ(loaded.format, "glTF 2.0");
    ASSERT_TRUE(loaded.up && loaded.unit);
    EXPECT_EQ(*loaded.up, glm::vec3(0, 1, 0));
    EXPECT_EQ(*loaded.unit, 1000);
    ASSERT_EQ(loaded.parts.size(), 1U);
    EXPECT_EQ(loaded.parts[0].name, "cube");
    EXPECT_EQ(loaded.parts[0].object, 0U);
    EXPECT_TRUE(loaded.notes.empty());
    EXPECT_EQ(extract_lines(loaded.mesh).kind_counts[LA_KIND_CREASE], 12U);
}

TEST_F(Gltf, BuffersMayBeDataOrFilesInTheFolder) {
    const std::string node = R"([{"mesh":0}])";
    EXPECT_EQ(load("a.gltf", cube_json(node, to_data_uri(cube_bytes()))).mesh.triangles.size(),
              12U);
    file("below/a cube.bin", cube_bytes());
    EXPECT_EQ(load("b.gltf", cube_json(node, "below/a%20cube.bin")).mesh.triangles.size(), 12U);
    EXPECT_EQ(load("c.gltf", cube_json(node, R"(below\/a cube.bin)")).mesh.triangles.size(), 12U);
}

TEST_F(Gltf, FilesElsewhereAreNotRead) {
    const fs::path outside = folder_.string() + "_outside.bin";
    std::ofstream(outside, std::ios::binary) << cube_bytes();
    fs::create_symlink(outside, folder_ / "link.bin");
    for (const std::string& uri :
         {"../" + outside.filename().string(), outside.string(), std::string{"link.bin"},
          std::string{"nowhere.bin"}, std::string{"http://localhost/a.bin"}}) {
        EXPECT_EQ(refusal("a.gltf", cube_json(R"([{"mesh":0}])", uri)),
                  "buffer 0 is in the file \"" + uri.substr(0, 60) +
                      "\", which is not beside the model or below its folder, or cannot be read");
    }
    fs::remove(outside);
}

TEST_F(Gltf, NodesMoveWhatIsBelowThem) {
    const LoadedMesh loaded = load_cube(
        R"([{"name":"hall","children":[1,2],"translation":[10,0,0]},)"
        R"({"name":"left","mesh":0,"scale":[-2,1,1]},)"
        R"({"name":"right","mesh":0,"rotation":[0,0,0.7071067811865476,0.7071067811865476]}])");
    EXPECT_EQ(loaded.mesh.triangles.size(), 24U);
    // Both look outwards, although one of them is mirrored.
    EXPECT_NEAR(volume(loaded.mesh), 3, 1e-5);
    const Bounds bounds = bounds_of(loaded.mesh);
    EXPECT_NEAR(bounds.min.x, 8, 1e-6);
    EXPECT_NEAR(bounds.max.x, 10, 1e-6);
    ASSERT_EQ(loaded.parts.size(), 3U);
    EXPECT_EQ(loaded.parts[0].object, ModelPart::none);
    EXPECT_EQ(loaded.parts[1].parent, 0U);
    EXPECT_EQ(loaded.parts[2].parent, 0U);
    EXPECT_EQ(loaded.parts[1].shape, loaded.parts[2].shape);
    ASSERT_EQ(loaded.mesh.groups.size(), 2U);
    EXPECT_EQ(loaded.mesh.groups[0].object, "hall/left");
    EXPECT_EQ(loaded.mesh.groups[1].object, "hall/right");
    EXPECT_EQ(loaded.mesh.triangle_object.front(), 0U);
    EXPECT_EQ(loaded.mesh.triangle_object.back(), 1U);
}

TEST_F(Gltf, AMatrixIsColumnByColumn) {
    const LoadedMesh loaded =
        load_cube(R"([{"mesh":0,"matrix":[0,2,0,0, -1,0,0,0, 0,0,1,0, 5,6,7,1]}])");
    const Bounds bounds = bounds_of(loaded.mesh);
    EXPECT_EQ(bounds.min, glm::vec3(4, 6, 7));
    EXPECT_EQ(bounds.max, glm::vec3(5, 8, 8));
}

TEST_F(Gltf, ColoursAreCodedForTheScreen) {
    std::string json = cube_json(R"([{"mesh":0}])", "",
                                 R"(,"materials":[{"name":"red, dark","pbrMetallicRoughness":)"
                                 R"({"baseColorFactor":[0.5,0.002,1,1]}}])");
    const std::string plain = R"("indices":1})";
    json.replace(json.find(plain), plain.size(), R"("indices":1,"material":0})");
    const LoadedMesh loaded = load("a.glb", to_glb(json, cube_bytes()));
    ASSERT_EQ(loaded.mesh.groups.size(), 1U);
    EXPECT_EQ(loaded.mesh.groups[0].material, "red, dark");
    ASSERT_TRUE(loaded.mesh.groups[0].color);
    EXPECT_NEAR(loaded.mesh.groups[0].color->x, 0.7354, 1e-4);
    EXPECT_NEAR(loaded.mesh.groups[0].color->y, 0.02584, 1e-5);
    EXPECT_NEAR(loaded.mesh.groups[0].color->z, 1, 1e-6);
}

/// A file of one primitive: corners in a plane, by mode.
std::string primitive_file(const std::vector<float>& points, int mode) {
    const std::string count = std::to_string(points.size() / 3);
    const std::string bytes = std::to_string(points.size() * 4);
    return to_glb(R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
                  R"({"attributes":{"POSITION":0},"mode":)" +
                      std::to_string(mode) +
                      R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" + count +
                      R"(,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":)" + bytes +
                      R"(}],"buffers":[{"byteLength":)" + bytes + "}]}",
                  GltfBytes{}.add(points).bytes());
}

TEST_F(Gltf, StripsAndFansFaceOneWay) {
    const std::vector<float> strip{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0};
    const std::vector<float> fan{0, 0, 0, 2, 0, 0, 2, 1, 0, 1, 2, 0, 0, 2, 0};
    for (const auto& [points, mode, triangles, area] :
         {std::tuple{strip, 5, std::size_t{4}, 2.0}, std::tuple{fan, 6, std::size_t{3}, 3.5}}) {
        const LoadedMesh loaded = load("a.glb", primitive_file(points, mode));
        ASSERT_EQ(loaded.mesh.triangles.size(), triangles);
        double sum = 0;
        for (const glm::uvec3 t : loaded.mesh.triangles) {
            const glm::vec3 a = loaded.mesh.positions[t.x];
            const double twice =
                glm::cross(loaded.mesh.positions[t.y] - a, loaded.mesh.positions[t.z] - a).z;
            EXPECT_GT(twice, 0);
            sum += twice / 2;
        }
        EXPECT_DOUBLE_EQ(sum, area);
    }
}

TEST_F(Gltf, LinesAreLines) {
    const std::vector<float> points{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    using Polylines = std::vector<std::vector<std::uint32_t>>;
    EXPECT_EQ(load("a.glb", primitive_file(points, 1)).mesh.polylines, (Polylines{{0, 1}, {2, 3}}));
    EXPECT_EQ(load("a.glb", primitive_file(points, 2)).mesh.polylines,
              (Polylines{{0, 1, 2, 3, 0}}));
    EXPECT_EQ(load("a.glb", primitive_file(points, 3)).mesh.polylines, (Polylines{{0, 1, 2, 3}}));
    EXPECT_NE(refusal("a.glb", primitive_file(points, 0)).find("holds no"), std::string::npos);
}

TEST_F(Gltf, SparseValuesTakeTheirPlaces) {
    // Corner 7 moves to (3, 3, 3).
    const std::string bytes =
        cube_bytes() +
        GltfBytes{}.add(std::vector<std::uint16_t>{7, 0}).add(std::vector<float>{3, 3, 3}).bytes();
    std::string json = cube_json(R"([{"mesh":0}])");
    const auto put = [&](const std::string& what, const std::string& by) {
        json.replace(json.find(what), what.size(), by);
    };
    put(R"("count":8,"type":"VEC3"})",
        R"("count":8,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":2,)"
        R"("componentType":5123},"values":{"bufferView":3}}})");
    put(R"("byteLength":72}])", R"("byteLength":72},{"buffer":0,"byteOffset":168,"byteLength":2},)"
                                R"({"buffer":0,"byteOffset":172,"byteLength":12}])");
    put(R"([{"byteLength":168)", R"([{"byteLength":184)");
    EXPECT_EQ(bounds_of(load("a.glb", to_glb(json, bytes)).mesh).max, glm::vec3(3));
}

TEST_F(Gltf, QuantizedPositionsAreScaledBack) {
    std::vector<std::uint8_t> corners;
    for (const float number : cube_corners()) corners.push_back(number > 0 ? 255 : 0);
    const std::string bytes = GltfBytes{}.add(corners).add(cube_triangles()).bytes();
    std::string json = cube_json(R"([{"mesh":0,"scale":[1,1,2]}])", "",
                                 R"(,"extensionsRequired":["KHR_mesh_quantization"])");
    const auto put = [&](const std::string& what, const std::string& by) {
        json.replace(json.find(what), what.size(), by);
    };
    put("5126", R"(5121,"normalized":true)");
    put(R"("byteLength":96},{"buffer":0,"byteOffset":96)",
        R"("byteLength":24},{"buffer":0,"byteOffset":24)");
    put(R"([{"byteLength":168)", R"([{"byteLength":96)");
    const LoadedMesh loaded = load("a.glb", to_glb(json, bytes));
    EXPECT_DOUBLE_EQ(volume(loaded.mesh), 2);
    // Half a step of 1/255 in each direction, doubled by the node.
    EXPECT_FLOAT_EQ(loaded.mesh.precision, std::sqrt(3.0F) / 255);
}

// Two squares side by side: the left one on a grid of 1/127, the right one on a grid of 1/255. So
// their common corners at 0.3 are at 0.29921 and 0.30196.
TEST_F(Gltf, PrimitivesMeetWhereRoundingHasPartedThem) {
    const auto read = [&](int of_left, int of_right) {
        const auto a = static_cast<std::int8_t>(of_left);
        const auto b = static_cast<std::uint8_t>(of_right);
        const std::string bytes =
            GltfBytes{}
                .add<std::int8_t>({0, 0, 0, a, 0, 0, a, 127, 0, 0, 127, 0})
                .add<std::uint8_t>({b, 0, 0, 255, 0, 0, 255, 255, 0, b, 255, 0})
                .add<std::uint8_t>({0, 1, 2, 0, 2, 3})
                .bytes();
        return load("a.glb",
                    to_glb(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
            "extensionsRequired":["KHR_mesh_quantization"],"nodes":[{"mesh":0}],
            "materials":[{"name":"steel"},{"name":"glass"}],"buffers":[{"byteLength":30}],
            "bufferViews":[{"buffer":0,"byteLength":12},{"buffer":0,"byteOffset":12,"byteLength":12},
                {"buffer":0,"byteOffset":24,"byteLength":6}],
            "accessors":[
                {"bufferView":0,"componentType":5120,"normalized":true,"count":4,"type":"VEC3"},
                {"bufferView":1,"componentType":5121,"normalized":true,"count":4,"type":"VEC3"},
                {"bufferView":2,"componentType":5121,"count":6,"type":"SCALAR"}],
            "meshes":[{"primitives":[
                {"attributes":{"POSITION":0},"indices":2,"material":0},
                {"attributes":{"POSITION":1},"indices":2,"material":1}]}]})",
                           bytes));
    };
    const LoadedMesh joined = read(38, 77);
    const auto& kinds = extract_lines(joined.mesh).kind_counts;
    EXPECT_EQ(kinds[LA_KIND_MATERIAL], 1U);
    EXPECT_EQ(kinds[LA_KIND_BOUNDARY], 6U);
    std::vector<float> across;
    for (const glm::vec3& position : joined.mesh.positions) across.push_back(position.x);
    EXPECT_EQ(std::ranges::count(across, 38 / 127.0F), 4) << "the later one goes to the earlier";
    EXPECT_EQ(std::ranges::count(across, 1.0F), 2) << "what has no counterpart stays";

    // Half a step of both in three directions is 0.0102; these are 0.0139 apart.
    const LoadedMesh apart = read(38, 80);
    for (const glm::vec3& position : apart.mesh.positions)
        EXPECT_TRUE(position.x < 0.3F || position.x > 0.31F) << position.x;
}

TEST_F(Gltf, SkinsTakeTheirStoredPose) {
    // The whole cube belongs to one joint at (0, 5, 0). The place of its own node does not count.
    const std::vector<std::uint8_t> joints(32, 0);
    std::vector<float> weights;
    for (int i = 0; i < 8; ++i) weights.insert(weights.end(), {1, 0, 0, 0});
    const std::string bytes = cube_bytes() + GltfBytes{}.add(joints).add(weights).bytes();
    std::string json =
        cube_json(R"([{"children":[1,2]},{"mesh":0,"skin":0,"translation":[100,0,0]},)"
                  R"({"translation":[0,5,0]}])",
                  "", R"(,"skins":[{"joints":[2]}])");
    const auto put = [&](const std::string& what, const std::string& by) {
        json.replace(json.find(what), what.size(), by);
    };
    put(R"("POSITION":0)", R"("POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3)");
    put(R"("count":36,"type":"SCALAR"})",
        R"("count":36,"type":"SCALAR"},{"bufferView":2,"componentType":5121,"count":8,)"
        R"("type":"VEC4"},{"bufferView":3,"componentType":5126,"count":8,"type":"VEC4"})");
    put(R"("byteLength":72}])", R"("byteLength":72},{"buffer":0,"byteOffset":168,"byteLength":32},)"
                                R"({"buffer":0,"byteOffset":200,"byteLength":128}])");
    put(R"([{"byteLength":168)", R"([{"byteLength":328)");
    const Bounds bounds = bounds_of(load("a.glb", to_glb(json, bytes)).mesh);
    EXPECT_EQ(bounds.min, glm::vec3(0, 5, 0));
    EXPECT_EQ(bounds.max, glm::vec3(1, 6, 1));
}

TEST_F(Gltf, InstancesStandWhereTheirAttributesSay) {
    // Two instances: one at (2, 0, 0), twice as large, and one at (0, 0, 5), turned by 180 degrees
    // about z.
    const std::string bytes = cube_bytes() + GltfBytes{}
                                                 .add<float>({2, 0, 0, 0, 0, 5})
                                                 .add<std::int8_t>({0, 0, 0, 127, 0, 0, 127, 0})
                                                 .add<float>({2, 2, 2, 1, 1, 1})
                                                 .bytes();
    const auto file = [&](const std::string& attributes) {
        std::string json = cube_json(R"([{"name":"bolt","mesh":0,"translation":[0,10,0],)"
                                     R"("extensions":{"EXT_mesh_gpu_instancing":{"attributes":)" +
                                         attributes + "}}}]",
                                     "", R"(,"extensionsRequired":["EXT_mesh_gpu_instancing"])");
        const auto put = [&](const std::string& what, const std::string& by) {
            json.replace(json.find(what), what.size(), by);
        };
        put(R"("count":36,"type":"SCALAR"})",
            R"("count":36,"type":"SCALAR"},{"bufferView":2,"componentType":5126,"count":2,)"
            R"("type":"VEC3"},{"bufferView":3,"componentType":5120,"normalized":true,"count":2,)"
            R"("type":"VEC4"},{"bufferView":4,"componentType":5126,"count":2,"type":"VEC3"},)"
            R"({"bufferView":4,"componentType":5126,"count":1,"type":"VEC3"})");
        put(R"("byteLength":72}])",
            R"("byteLength":72},{"buffer":0,"byteOffset":168,"byteLength":24},)"
            R"({"buffer":0,"byteOffset":192,"byteLength":8},)"
            R"({"buffer":0,"byteOffset":200,"byteLength":24}])");
        put(R"([{"byteLength":168)", R"([{"byteLength":224)");
        return to_glb(json, bytes);
    };
    const LoadedMesh loaded =
        load("a.glb", file(R"({"TRANSLATION":2,"ROTATION":3,"SCALE":4,"_ID":1})"));
    EXPECT_NEAR(volume(loaded.mesh), 8 + 1, 1e-4);
    const Bounds bounds = bounds_of(loaded.mesh);
    EXPECT_EQ(bounds.min, glm::vec3(-1, 9, 0));
    EXPECT_EQ(bounds.max, glm::vec3(4, 12, 6));
    ASSERT_EQ(loaded.parts.size(), 3U);
    EXPECT_EQ(loaded.parts[1].name, "bolt 1");
    EXPECT_EQ(loaded.parts[2].name, "bolt 2");
    EXPECT_EQ(loaded.parts[2].parent, 0U);
    EXPECT_EQ(loaded.parts[1].shape, loaded.parts[2].shape);
    EXPECT_EQ(loaded.mesh.groups.at(0).object, "bolt/bolt 1");

    EXPECT_EQ(refusal("a.glb", file(R"({"TRANSLATION":2,"SCALE":5})")),
              "the instances of node 0 differ in number by attribute");
    EXPECT_EQ(refusal("a.glb", file("{}")), "the instances of node 0 have no place");
    // Zeros without a view take no room in the file.
    std::string many = file(R"({"TRANSLATION":5})");
    const std::string view = R"("bufferView":4,"componentType":5126,"count":1,)";
    many.replace(many.find(view), view.size(), R"("componentType":5126,"count":9999999,         )");
    EXPECT_EQ(refusal("a.glb", many), "with all its instances it has more than 262144 parts");
}

TEST_F(Gltf, WhatTheFileHidesIsLeftOut) {
    const std::string json =
        cube_json(R"([{"children":[1,2]},{"mesh":0},{"children":[3],)"
                  R"("extensions":{"KHR_node_visibility":{"visible":false}}},)"
                  R"({"mesh":0,"extensions":{"KHR_node_visibility":{"visible":true}}}])",
                  "", R"(,"extensionsRequired":["KHR_node_visibility"])");
    const LoadedMesh loaded = load("a.glb", to_glb(json, cube_bytes()));
    EXPECT_EQ(loaded.mesh.triangles.size(), 12U);
    ASSERT_EQ(loaded.notes.size(), 1U);
    EXPECT_EQ(loaded.notes[0], "1 mesh left out, which the file itself hides");
}

TEST_F(Gltf, ExtensionsThatMoveNothingAreNoReasonToRefuse) {
    const std::string json =
        cube_json(R"([{"mesh":0}])", "",
                  R"(,"extensionsRequired":["KHR_materials_transmission","KHR_texture_basisu",)"
                  R"("EXT_texture_webp","MSFT_texture_dds","KHR_lights_punctual"],)"
                  R"("materials":[{"extensions":{"KHR_materials_pbrSpecularGlossiness":)"
                  R"({"diffuseFactor":[1,0,0,1]}}}])");
    std::string painted = json;
    painted.replace(painted.find(R"("indices":1})"), 12, R"("indices":1,"material":0})");
    const LoadedMesh loaded = load("a.glb", to_glb(painted, cube_bytes()));
    EXPECT_EQ(loaded.mesh.triangles.size(), 12U);
    EXPECT_TRUE(loaded.notes.empty());
    EXPECT_EQ(loaded.mesh.groups.at(0).color, glm::vec3(1, 0, 0));
}

TEST_F(Gltf, RequiredExtensionsAreRefusedByName) {
    EXPECT_EQ(refusal("a.glb", to_glb(cube_json(R"([{"mesh":0}])", "",
                                                R"(,"extensionsRequired":["XY_shape"])"),
                                      cube_bytes())),
              "it requires the extension XY_shape, which is not supported");
}

TEST_F(Gltf, ContentCountsIfTheExtensionIsWrong) {
    const std::string glb = to_glb(cube_json(R"([{"mesh":0}])"), cube_bytes());
    EXPECT_EQ(load("a.gltf", glb).mesh.triangles.size(), 12U);
    EXPECT_EQ(refusal("a.obj", glb), "it holds a mesh of type .glb; give it that extension");
    EXPECT_EQ(refusal("a.glb", "solid a\n"), "it is no JSON; parsing stops at byte 1");
}

TEST_F(Gltf, OtherScenesAreRefusedWithTheWayOut) {
    EXPECT_EQ(refusal("a.fbx", "Kaydara FBX Binary  "),
              "it is an FBX model; convert it to GLB, with Blender for one");
    EXPECT_EQ(refusal("b.fbx", "; FBX 7.3.0 project file\n"),
              "it is an FBX model; convert it to GLB, with Blender for one");
    EXPECT_EQ(refusal("a.dae", "<?xml version=\"1.0\"?><COLLADA/>"),
              "it is a Collada model; convert it to GLB, with Blender for one");
    EXPECT_EQ(refusal("a.ifc", "ISO-10303-21;"),
              "it is an IFC building; convert it to GLB, with IfcConvert for one");
    EXPECT_EQ(refusal("a.usd", "PXR-USDC"),
              "it is a USD scene; convert it to GLB, with Blender for one");
}

TEST_F(Gltf, CutAnywhereItIsRefused) {
    const std::string whole = to_glb(cube_json(R"([{"mesh":0}])"), cube_bytes());
    for (std::size_t size = 1; size < whole.size(); size += 1 + whole.size() / 40)
        refusal("a.glb", std::string_view{whole}.substr(0, size));
    const std::string text = cube_json(R"([{"mesh":0}])", to_data_uri(cube_bytes()));
    for (std::size_t size = 1; size < text.size(); size += 1 + text.size() / 40)
        refusal("a.gltf", std::string_view{text}.substr(0, size));
}

TEST_F(Gltf, HostileNumbersAreRefused) {
    struct Case {
        std::string what, by, cause;
    };
    const std::vector<Case> cases{
        {R"("count":8)", R"("count":9)", "accessor 0 does not fit"},
        {R"("count":8)", R"("count":4611686018427387904)", "accessor 0 does not fit"},
        {R"("count":8)", R"("count":18446744073709551615)", "accessor 0 does not fit"},
        {R"("count":8)", R"("count":-1)", "no whole number"},
        {R"("count":8)", R"("count":"8")", "no whole number"},
        {R"("count":8)", R"("count":1e300)", "no whole number"},
        {R"("count":36)", R"("count":35)", "makes no triangles"},
        {R"("byteOffset":96)", R"("byteOffset":18446744073709551608)", "ends beyond its buffer"},
        {R"("byteLength":96)", R"("byteLength":1e15)", "ends beyond its buffer"},
        {R"([{"byteLength":168)", R"([{"byteLength":169000)", "bytes of 169000"},
        {R"("buffer":0)", R"("buffer":7)", "number 7 of its \"buffers\""},
        {R"("POSITION":0)", R"("POSITION":99)", "number 99 of its \"accessors\""},
        {R"("POSITION":0)", R"("POSITION":1)", "accessor 1 is no VEC3"},
        {R"("indices":1)", R"("indices":0)", "accessor 0 is no SCALAR"},
        {R"("bufferView":0,"componentType":5126)", R"("componentType":5126,"bufferView":77)",
         "number 77 of its \"bufferViews\""},
        {R"(5126)", R"(5127)", "unknown type"},
        {R"("mesh":0)", R"("mesh":1)", "number 1 of its \"meshes\""},
        {R"([{"mesh":0}])", R"([{"mesh":0,"children":[0]}])", "is part of itself"},
        {R"([{"mesh":0}])", R"([{"children":[1]},{"children":[0]}])", "is part of itself"},
        {R"([{"mesh":0}])", R"([{"mesh":0,"scale":[1,1]}])", "no list of 3 numbers"},
        {R"([{"mesh":0}])", R"([{"mesh":0,"scale":[1,1,"x"]}])", "must hold numbers alone"},
        {R"([{"mesh":0}])", R"({"mesh":0})", "are no list"},
        {R"([{"mesh":0}])", R"([7])", "is no object"},
        {R"("primitives":[)", R"("primitives":[[],)", "is no object"},
        {R"("version":"2.0")", R"("version":"1.0")", "only glTF 2.0 is read"},
        {R"("asset")", R"("assets")", "no glTF"},
        {R"("indices":1)", R"("indices":1,"mode":9)", "unknown mode"},
    };
    for (const Case& each : cases) {
        std::string json = cube_json(R"([{"mesh":0}])");
        ASSERT_NE(json.find(each.what), json.npos) << each.what;
        json.replace(json.find(each.what), each.what.size(), each.by);
        const std::string message = refusal("a.glb", to_glb(json, cube_bytes()));
        EXPECT_NE(message.find(each.cause), message.npos) << each.by << ": " << message;
    }
}

TEST_F(Gltf, PositionsThatAreNotFiniteAreRefused) {
    std::string bytes = cube_bytes();
    for (std::size_t i = 0; i < 96; ++i) bytes[i] = '\xFF';
    EXPECT_NE(refusal("a.glb", to_glb(cube_json(R"([{"mesh":0}])"), bytes)).find("finite"),
              std::string::npos);
}

TEST_F(Gltf, DeepNestingIsRefused) {
    constexpr std::size_t deep = 1'000'000;
    EXPECT_EQ(refusal("a.gltf", std::string(deep, '[')), "its JSON is nested more than 64 deep");
    EXPECT_EQ(refusal("a.gltf", R"({"asset":)" + std::string(deep, '{')),
              "its JSON is nested more than 64 deep");
    std::string nodes = "[";
    for (int i = 1; i <= 20000; ++i) nodes += R"({"children":[)" + std::to_string(i) + "]},";
    EXPECT_EQ(refusal("a.glb", to_glb(cube_json(nodes + R"({"mesh":0}])"), cube_bytes())),
              "its nodes are nested more than 1000 deep");
}

TEST_F(Gltf, DamagedCompressionIsRefused) {
    std::string json =
        cube_json(R"([{"mesh":0}])", "", R"(,"extensionsRequired":["EXT_meshopt_compression"])");
    const std::string view = R"("byteLength":96})";
    json.replace(json.find(view), view.size(),
                 R"("byteLength":96,"extensions":{"EXT_meshopt_compression":{"buffer":0,)"
                 R"("byteLength":96,"byteStride":12,"count":8,"mode":"ATTRIBUTES"}}})");
    EXPECT_EQ(refusal("a.glb", to_glb(json, cube_bytes())),
              "buffer view 0 is damaged: EXT_meshopt_compression cannot be decoded");
    json.replace(json.find(R"("count":8,"mode")"), 16, R"("count":8000000,"mode")");
    EXPECT_EQ(refusal("a.glb", to_glb(json, cube_bytes())),
              "buffer view 0 cannot hold as much as it says");

    json =
        cube_json(R"([{"mesh":0}])", "", R"(,"extensionsRequired":["KHR_draco_mesh_compression"])");
    const std::string primitive = R"("indices":1})";
    json.replace(json.find(primitive), primitive.size(),
                 R"("indices":1,"extensions":{"KHR_draco_mesh_compression":)"
                 R"({"bufferView":0,"attributes":{"POSITION":0}}}})");
    EXPECT_EQ(refusal("a.glb", to_glb(json, cube_bytes())),
              "primitive 0 of mesh 0 is damaged: its Draco data cannot be decoded");
}

} // namespace
} // namespace lineatlas::test

int main(int argc, char** argv) {
    // Files are read as by the tool, in separate, confined processes.
    if (const std::optional<int> code = lineatlas::serve_as_reader(argc, argv)) return *code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
