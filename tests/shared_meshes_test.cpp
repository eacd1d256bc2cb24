// The table in shared/meshes/NOTES.md, counted by other software, against the edges found here.

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/edges.hpp"
#include "lineatlas/io.hpp"

namespace fs = std::filesystem;

namespace lineatlas {
namespace {

struct Row {
    const char* file;
    std::size_t triangles;
    std::size_t creases, boundaries, non_manifold; ///< edges, bent by more than 30 degrees
};

constexpr std::array<Row, 7> table{{{"featuretype.STL", 3'476, 1'435, 576, 0},
                                    {"cycloidal.ply", 43'368, 17'838, 0, 242},
                                    {"counter.unitsmm.STL", 83'750, 31'565, 0, 0},
                                    {"parking_garage.obj", 6'413, 3'769, 2'578, 0},
                                    {"small_house.obj", 145'842, 49'330, 10'232, 1},
                                    {"koala.obj", 99'994, 479, 0, 0},
                                    {"penguin_hr.obj", 26'880, 198, 0, 0}}};

fs::path meshes_folder() {
    const char* shared = std::getenv("LINEATLAS_SHARED");
    return (shared != nullptr ? fs::path{shared} : fs::path{LINEATLAS_SOURCE_DIR} / "../shared") /
           "meshes";
}

class SharedMesh : public testing::TestWithParam<Row> {};

TEST_P(SharedMesh, HasTheEdgesOfTheTable) {
    const Row& row = GetParam();
    const fs::path path = meshes_folder() / row.file;
    if (!fs::is_directory(meshes_folder())) {
        GTEST_SKIP() << "the folder " << meshes_folder() << " is not there; LINEATLAS_SHARED names "
                     << "the folder that holds it";
    }
    const Mesh mesh = load_mesh(path).mesh;
    EXPECT_EQ(mesh.triangles.size(), row.triangles);

    const WeldedMesh welded = weld(mesh);
    const std::vector<MeshEdge> edges = mesh_edges(welded);
    const std::vector<glm::dvec3> normals = face_normals(welded, edges);
    LineOptions options; // 30 degrees
    options.kinds = mask_of(LineKind::crease) | mask_of(LineKind::boundary);
    std::size_t creases = 0;
    std::size_t boundaries = 0;
    std::size_t non_manifold = 0;
    for (const MeshEdge& edge : edges) {
        const auto kind = classify(edge, welded, normals, options);
        if (kind == LineKind::crease) ++creases;
        if (kind == LineKind::boundary) ++(edge.face_count > 2 ? non_manifold : boundaries);
    }
    EXPECT_EQ(creases, row.creases);
    EXPECT_EQ(boundaries, row.boundaries);
    EXPECT_EQ(non_manifold, row.non_manifold);
}

INSTANTIATE_TEST_SUITE_P(Table, SharedMesh, testing::ValuesIn(table), [](const auto& parameters) {
    std::string name = parameters.param.file;
    return name.substr(0, name.find('.'));
});

} // namespace
} // namespace lineatlas
