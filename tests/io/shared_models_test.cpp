// The tables in shared/models/NOTES.md, counted by other software, compared with the models read
// here.

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include "io/isolated.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/lines.hpp"

namespace fs = std::filesystem;

namespace lineatlas {
namespace {

fs::path models_folder() {
    const char* shared = std::getenv("LINEATLAS_SHARED");
    return (shared != nullptr ? fs::path{shared} : fs::path{LINEATLAS_SOURCE_DIR} / "../shared") /
           "models";
}

class SharedModels : public testing::Test {
  protected:
    void SetUp() override {
        if (!fs::is_directory(models_folder()))
            GTEST_SKIP() << "the folder " << models_folder() << " is not there; LINEATLAS_SHARED "
                         << "names the folder that holds it";
    }
    static LoadedMesh load(const char* file) { return load_mesh_isolated(models_folder() / file); }
    /// The number of triangles whose chords are off by at most a thousandth of the diagonal.
    static double coarse_triangles(const char* file, double diagonal) {
        return static_cast<double>(
            load_mesh_isolated(models_folder() / file, {}, {.deflection = 0.001 * diagonal})
                .mesh.triangles.size());
    }
};

void expect_box(const Mesh& mesh, glm::dvec3 min, glm::dvec3 max, double error) {
    const Bounds box = bounds_of(mesh);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(box.min[axis], min[axis], error);
        EXPECT_NEAR(box.max[axis], max[axis], error);
    }
}

/// The number of edges of each kind in the file, by KnownEdge::Kind.
using EdgeCounts = std::array<std::size_t, 4>;

EdgeCounts placed_edges(const Mesh& mesh) {
    std::array<std::set<std::uint32_t>, 4> edges;
    for (const KnownEdge& edge : mesh.known_edges)
        edges[static_cast<std::size_t>(edge.kind)].insert(edge.edge);
    return {edges[0].size(), edges[1].size(), edges[2].size(), edges[3].size()};
}

/// Occurrences of parts with shapes, by name.
std::map<std::string, int> occurrences(const LoadedMesh& loaded) {
    std::map<std::string, int> counts;
    for (const ModelPart& part : loaded.parts)
        if (part.object != ModelPart::none) ++counts[part.name];
    return counts;
}

std::size_t shape_count(const LoadedMesh& loaded) {
    std::set<std::uint32_t> shapes;
    for (const ModelPart& part : loaded.parts)
        if (part.object != ModelPart::none) shapes.insert(part.shape);
    return shapes.size();
}

std::set<std::array<float, 3>> colors(const Mesh& mesh) {
    std::set<std::array<float, 3>> found;
    for (const MeshGroup& group : mesh.groups)
        if (group.color) found.insert({group.color->x, group.color->y, group.color->z});
    return found;
}

TEST_F(SharedModels, MachineHall) {
    for (const char* file :
         {"machine_hall.gltf", "machine_hall_zup.glb", "machine_hall_meshopt.glb"}) {
        SCOPED_TRACE(file);
        const LoadedMesh loaded = load(file);
        EXPECT_EQ(loaded.mesh.triangles.size(), 6912U);
        EXPECT_EQ(shape_count(loaded), 6U);
        EXPECT_EQ(colors(loaded.mesh).size(), 4U);
        EXPECT_EQ(loaded.up, glm::vec3(0, 1, 0));
        EXPECT_EQ(loaded.unit, 1000);
        expect_box(loaded.mesh, {-6, -0.6, -4}, {6, 3, 4}, 2e-3);
        int instances = 0;
        for (const auto& [name, count] : occurrences(loaded)) instances += count;
        EXPECT_EQ(instances, 20);
        // The model's rings have twelve sides. By the file's rounding these bend by 29 to 31
        // degrees.
        EXPECT_EQ(extract_lines(loaded.mesh).kind_counts[LA_KIND_CREASE], 3588U);
    }
}

TEST_F(SharedModels, MilkTruck) {
    for (const char* file : {"CesiumMilkTruck.glb", "CesiumMilkTruck_draco.glb"}) {
        SCOPED_TRACE(file);
        const LoadedMesh loaded = load(file);
        EXPECT_EQ(loaded.mesh.triangles.size(), 3624U);
        expect_box(loaded.mesh, {-2.4309, 0.0015, -1.3960}, {2.4380, 2.5844, 1.3960}, 2e-3);
        // The windows meet the body, even where each has another grid.
        constexpr LineKindMask asked = mask_of(LineKind::material) | mask_of(LineKind::boundary);
        const auto kinds = extract_lines(loaded.mesh, {.lines = asked}).kind_counts;
        EXPECT_EQ(kinds[LA_KIND_MATERIAL], 120U);
        EXPECT_EQ(kinds[LA_KIND_BOUNDARY], 8U);
    }
}

TEST_F(SharedModels, OtherScenesAreRefusedByName) {
    for (const auto& [file, what] :
         std::map<std::string, std::string>{{"machine_hall.fbx", "FBX"},
                                            {"cubes_with_mirroring_and_pivot_ascii.fbx", "FBX"},
                                            {"machine_hall.dae", "Collada"}}) {
        try {
            load(file.c_str());
            ADD_FAILURE() << file << " was accepted";
        } catch (const FileError& error) {
            EXPECT_NE(std::string{error.what()}.find(what), std::string::npos) << error.what();
            EXPECT_NE(std::string{error.what()}.find("convert it to"), std::string::npos);
        }
    }
}

#ifdef LINEATLAS_HAS_3MF

TEST_F(SharedModels, CubeGears) {
    const LoadedMesh loaded = load("cube_gears.3mf");
    EXPECT_EQ(loaded.unit, 1);
    EXPECT_EQ(loaded.up, (glm::vec3{0, 0, 1}));
    EXPECT_EQ(loaded.mesh.triangles.size(), 25692U);
    EXPECT_EQ(shape_count(loaded), 17U);
    const std::map<std::string, int> parts = occurrences(loaded);
    EXPECT_EQ(parts.size(), 17U);
    EXPECT_TRUE(parts.contains("gear 1"));
    EXPECT_TRUE(parts.contains("cube 7"));
}

#endif

#ifdef LINEATLAS_HAS_BREP

TEST_F(SharedModels, FlangeJointOfSurfaces) {
    const LoadedMesh loaded = load("flange_joint.iges");
    EXPECT_EQ(loaded.format, "IGES 5.3");
    // The same as in the STEP file, although here no two faces share an edge.
    EXPECT_EQ(placed_edges(loaded.mesh), (EdgeCounts{428, 8, 76, 0}));
    EXPECT_EQ(loaded.parts.size(), 36U);
    expect_box(loaded.mesh, {-60, -60, -46}, {60, 60, 76}, 0.2);
    EXPECT_EQ(extract_lines(loaded.mesh).kind_counts[LA_KIND_BOUNDARY], 0U);
}

TEST_F(SharedModels, RobotFoot) {
    const LoadedMesh loaded = load("odri_foot_structure.step");
    EXPECT_EQ(loaded.format, "STEP AP214");
    EXPECT_EQ(placed_edges(loaded.mesh), (EdgeCounts{256, 355, 0, 0}));
    EXPECT_EQ(shape_count(loaded), 1U);
    EXPECT_EQ(colors(loaded.mesh).size(), 1U);
    expect_box(loaded.mesh, {-8.25, -13.5, -13.5}, {8.25, 13.5, 13.5}, 0.02);
    EXPECT_NEAR(coarse_triangles("odri_foot_structure.step", 41.6), 14026, 7000);
    EXPECT_EQ(extract_lines(loaded.mesh).kind_counts[LA_KIND_BOUNDARY], 0U);
}

TEST_F(SharedModels, FlangeJoint) {
    const LoadedMesh loaded = load("flange_joint.step");
    EXPECT_EQ(placed_edges(loaded.mesh), (EdgeCounts{428, 8, 76, 0}));
    EXPECT_EQ(shape_count(loaded), 5U);
    EXPECT_EQ(occurrences(loaded), (std::map<std::string, int>{{"Flange DN50", 2},
                                                               {"Gasket \xC3\xA9\xE2\x80\x93"
                                                                "50",
                                                                1},
                                                               {"Washer 10.5", 16},
                                                               {"Bolt M10x40", 8},
                                                               {"Nut M10", 8}}));
    EXPECT_EQ(colors(loaded.mesh).size(), 5U);
    EXPECT_TRUE(colors(loaded.mesh).contains({0.55F, 0.6F, 0.65F}));
    expect_box(loaded.mesh, {-60, -60, -46}, {60, 60, 76}, 0.2);
    EXPECT_NEAR(coarse_triangles("flange_joint.step", 209), 15500, 8000);
}

TEST_F(SharedModels, InchesBecomeMillimetres) {
    const LoadedMesh loaded = load("featuretype_inch.step");
    EXPECT_EQ(placed_edges(loaded.mesh), (EdgeCounts{185, 58, 0, 0}));
    EXPECT_EQ(loaded.unit, 1);
    expect_box(loaded.mesh, {-63.5, -31.75, 0}, {63.5, 31.75, 34.925}, 0.05);
}

TEST_F(SharedModels, ThreadedBolt) {
    const LoadedMesh loaded = load("threaded_bolt.brep");
    EXPECT_EQ(placed_edges(loaded.mesh), (EdgeCounts{24, 0, 2, 8}));
    EXPECT_EQ(loaded.unit, std::nullopt);
    expect_box(loaded.mesh, {-10.392, -9, -2}, {10.392, 9, 55.5}, 0.1);
    const LineSet along_edges = extract_lines(loaded.mesh),
                  contours = extract_lines(loaded.mesh, {.silhouettes = Silhouettes::automatic});
    EXPECT_GT(along_edges.kind_counts[LA_KIND_BOUNDARY], 0U);
    // Flanks of the thread have contours, and their edges stay lines.
    EXPECT_GT(contours.contours.faces.size(),
              0.9 * static_cast<double>(loaded.mesh.triangles.size()));
    EXPECT_EQ(contours.kind_counts[LA_KIND_CREASE], along_edges.kind_counts[LA_KIND_CREASE]);
}

#endif

} // namespace
} // namespace lineatlas

int main(int argc, char** argv) {
    if (const auto code = lineatlas::serve_as_reader(argc, argv)) return *code;
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
