// Drawings without a line: how they are recognised from the camera, and the message about them.

#include <gtest/gtest.h>

#include "core/empty_drawing.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

constexpr glm::ivec2 size{400, 300};

LineSet line_between(glm::vec3 p, glm::vec3 q) {
    Mesh mesh;
    mesh.positions = {p, q};
    mesh.polylines = {{0, 1}};
    return extract_lines(mesh);
}

Camera looking_along_minus_z() {
    return make_camera({.eye = {0, 0, 5}, .target = {0, 0, 0}, .near = 1, .far = 10}, size, {});
}

TEST(AnyInView, OfALineThatOnlyCrossesThePicture) {
    const Camera camera = looking_along_minus_z();
    EXPECT_TRUE(any_in_view(line_between({-100, 0, 0}, {100, 0.1F, 0}), camera));
    EXPECT_TRUE(any_in_view(line_between({0, 0, 0}, {0, 0.1F, 20}), camera)) << "from behind";
    EXPECT_FALSE(any_in_view(line_between({-100, 0, 0}, {0, 100, 0}), camera)) << "past a corner";
    EXPECT_FALSE(any_in_view(line_between({0, 0, 6}, {0, 1, 6}), camera)) << "behind";
    EXPECT_FALSE(any_in_view(line_between({0, 0, -6}, {0, 1, -6}), camera)) << "too far";
    EXPECT_FALSE(any_in_view(LineSet{}, camera));
}

TEST(AnyInView, ByEveryConventionOfDepth) {
    const LineSet cube = extract_lines(test::cube());
    Camera camera = looking_along_minus_z();
    for (const bool reversed : {false, true}) {
        camera = looking_along_minus_z();
        camera.clip.zero_to_one = true;
        for (int column = 0; column < 4; ++column) {
            glm::vec4& c = camera.projection[column];
            c.z = 0.5F * (reversed ? c.w - c.z : c.w + c.z);
        }
        EXPECT_TRUE(any_in_view(cube, camera)) << reversed;
        camera.view[3].z = 50; // the cube is behind it now
        EXPECT_FALSE(any_in_view(cube, camera)) << reversed;
    }
}

TEST(WhyNoLine, NamesTheCause) {
    const LineSet cube = extract_lines(test::cube());
    const Camera camera = looking_along_minus_z();
    EXPECT_EQ(why_no_line(LineSet{}, all_line_kinds, camera),
              "the model has no triangles and no lines");
    const LineKindMask kinds = mask_of(LineKind::boundary) | mask_of(LineKind::file);
    EXPECT_EQ(why_no_line(extract_lines(test::cube(), {.lines = kinds}), kinds, camera),
              "the model has none of the kinds boundary, file");
    const LineOptions blunt{.lines = mask_of(LineKind::crease), .crease = 2};
    EXPECT_EQ(why_no_line(extract_lines(test::cube(), blunt), blunt.lines, camera),
              "the model has none of the kinds crease; a smaller crease angle finds more");
    EXPECT_EQ(why_no_line(cube, all_line_kinds, camera),
              "surfaces hide those in the picture, or the style leaves them out");
    Camera away = camera;
    away.view[3].z = 50;
    EXPECT_EQ(why_no_line(cube, all_line_kinds, away),
              "the model lies behind the camera, which looks away from it");
    away.view[3] = {100, 0, -5, 1};
    EXPECT_EQ(why_no_line(cube, all_line_kinds, away),
              "none lies in the part of the model that the camera sees");
}

} // namespace
} // namespace lineatlas
