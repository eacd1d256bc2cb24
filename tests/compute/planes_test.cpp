// planes: the nearness of the planes of hand-made triangles anywhere on the screen.

#include <cmath>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/clusters.hpp"
#include "core/meshlets.hpp"
#include "core/surface_view.hpp"
#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

class PlanesStage : public StageTest {
  protected:
    /// The planes in the order of `triangles`.
    std::vector<glm::vec4> planes(const std::vector<glm::vec3>& vertices,
                                  const std::vector<glm::uvec3>& triangles, const Camera& camera,
                                  std::vector<std::uint32_t> seen = {}) {
        const TriangleClusters parts = build_clusters(vertices, triangles, 4);
        const Meshlets built = build_meshlets(parts.triangles, parts.clusters, vertices.size());
        const auto clusters = to_device(device(), parts.clusters);
        const auto meshlets = to_device(device(), built.meshlets);
        const auto vertex_list = to_device(device(), built.vertices);
        const auto corners = to_device(device(), built.corners);
        const auto vertex_table = to_device(device(), vertices);
        const auto out = to_device(device(), std::vector(triangles.size(), glm::vec4{7}));
        const bool only_seen = !seen.empty();
        if (only_seen) seen.resize(parts.clusters.size(), seen.back());
        const auto seen_table = to_device(device(), only_seen ? seen : std::vector(1, 0U));
        const compute::MeshletTables model{*clusters, *meshlets, *vertex_list, *corners,
                                           static_cast<std::uint32_t>(parts.clusters.size())};
        stages().launch<compute::kernels::planes>(
            model.count,
            {.count = model.count,
             .world_from_screen = surface_view(camera).world_from_screen,
             .contact = 0.001F,
             .only_seen = only_seen ? 1U : 0U},
            {.vertices = vertex_table.get(),
             .seen = only_seen ? seen_table.get() : nullptr,
             .planes = out.get()},
            model);
        const auto found = read_back<glm::vec4>(device(), *out, triangles.size());
        std::vector<glm::vec4> result(triangles.size());
        for (std::size_t i = 0; i < result.size(); ++i) result[parts.order[i]] = found[i];
        return result;
    }
};
INSTANTIATE_TEST_SUITE_P(OnDevice, PlanesStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

Camera camera_of(bool perspective) {
    Camera camera;
    camera.size = {640, 480};
    camera.view = glm::lookAt(glm::vec3{3, 2, 5}, glm::vec3{0.2F, 0, 0}, glm::vec3{0, 1, 0});
    camera.projection = perspective ? glm::frustum(-0.3F, 0.5F, -0.2F, 0.4F, 1.0F, 30.0F)
                                    : glm::ortho(-2.0F, 3.0F, -2.0F, 2.0F, 1.0F, 30.0F);
    return camera;
}

double nearness_of(const glm::dvec4& clip, bool perspective) {
    return perspective ? 1 / clip.w : 1 - clip.z;
}

/// Triangles at these distances, some of them large, none edge on.
const std::vector<glm::vec3> corners{{0, 0, 0},     {1, 0, 0.2F},  {0.1F, 1, 0},  {-1, 0.3F, -1},
                                     {1.5F, -1, 0}, {0.01F, 0, 0}, {0, 0.01F, 0}, {-1, -1, 3}};
const std::vector<glm::uvec3> faces{{0, 1, 2}, {2, 1, 0}, {3, 4, 2}, {0, 5, 6}, {7, 4, 2}};

TEST_P(PlanesStage, GiveNearnessEverywhereOnTheScreen) {
    for (const bool perspective : {true, false}) {
        const Camera camera = camera_of(perspective);
        const glm::dmat4 m{glm::dmat4{camera.projection} * glm::dmat4{camera.view}};
        const std::vector<glm::vec4> found = planes(corners, faces, camera);
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const glm::dvec3 a{corners[faces[i].x]}, b{corners[faces[i].y]}, c{corners[faces[i].z]};
            const glm::dvec3 unit = glm::normalize(glm::cross(b - a, c - a));
            // Points in the triangle, and points of its plane beside it.
            for (const glm::dvec3 share :
                 {glm::dvec3{1, 0, 0}, glm::dvec3{0.2, 0.3, 0.5}, glm::dvec3{-0.2, 0.7, 0.5}}) {
                const glm::dvec3 point = a * share.x + b * share.y + c * share.z;
                const auto at = [&](const glm::dvec3& p) {
                    const glm::dvec4 clip = m * glm::dvec4{p, 1};
                    return (found[i].x * clip.x + found[i].y * clip.y) / clip.w + found[i].z -
                           nearness_of(clip, perspective);
                };
                EXPECT_NEAR(at(point), 0, 1e-6) << i;
                // A point at the distance `contact` from the plane barely touches it.
                const glm::dvec3 away = point + unit * 0.001;
                const double touches = found[i].w / (m * glm::dvec4{away, 1}).w;
                EXPECT_NEAR(std::abs(at(away)) / touches, 1, 2e-3) << i;
            }
        }
    }
}

TEST_P(PlanesStage, WhatHasNoAreaOrIsSeenFromTheEdgeTouchesAll) {
    Camera camera = camera_of(false);
    camera.view = glm::mat4{1};
    const std::vector<glm::vec4> found = planes({{0, 0, -2}, {1, 0, -2}, {2, 0, -2}, {0, 0, -3}},
                                                {{0, 1, 2}, {0, 1, 3}, {0, 0, 1}}, camera);
    for (const glm::vec4& plane : found) {
        EXPECT_EQ(glm::vec3{plane}, glm::vec3{0});
        EXPECT_TRUE(std::isinf(plane.w));
    }
}

TEST_P(PlanesStage, LeavesWhatIsNotSeenAsItWas) {
    const std::vector<glm::vec4> none = planes(corners, faces, camera_of(true), {0});
    for (const glm::vec4& plane : none) EXPECT_EQ(plane, glm::vec4{7});
    EXPECT_EQ(planes(corners, faces, camera_of(true), {1}),
              planes(corners, faces, camera_of(true)));
}

} // namespace
} // namespace lineatlas::test
