// fill: triangles and texels by hand, whose colours are known.

#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/clusters.hpp"
#include "core/meshlets.hpp"
#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

using Rgba = std::array<std::uint8_t, 4>;
constexpr Rgba untouched{1, 2, 3, 4};
constexpr std::uint32_t none = LA_NO_FACE;

class FillStage : public StageTest {
  protected:
    struct Model {
        std::vector<glm::vec3> vertices;
        std::vector<glm::uvec3> triangles;
        std::vector<Rgba> colors{}; ///< per triangle; none: empty
        Camera camera{};
        std::uint32_t seen = 1;
        std::vector<glm::vec3> normals{}; ///< per vertex, of smooth triangles; none: empty
    };
    struct Texels {
        std::vector<std::uint32_t> numbers; ///< triangles of the model, rows from the lower left
        int row;
        int scale;
        glm::ivec2 size; ///< pixels
        glm::ivec2 origin{0, 0};
        TexelRectangle part{{0, 0}, size};
        glm::vec2 first{0}, step{0}; ///< from -1 to 1 in the picture
    };

    std::vector<Rgba> fill(const Model& model, const Fill& fill, Texels texels) {
        const TriangleClusters parts = build_clusters(model.vertices, model.triangles, 4);
        const Meshlets built =
            build_meshlets(parts.triangles, parts.clusters, model.vertices.size());
        std::vector<Rgba> colors;
        std::vector<std::uint32_t> place(model.triangles.size());
        for (std::uint32_t i = 0; i < place.size(); ++i) {
            place[parts.order[i]] = i;
            if (!model.colors.empty()) colors.push_back(model.colors[parts.order[i]]);
        }
        for (std::uint32_t& number : texels.numbers)
            if (number != none) number = place[number];
        const auto clusters = put(parts.clusters);
        const auto meshlets = put(built.meshlets);
        const auto vertex_list = put(built.vertices);
        const auto corners = put(built.corners);
        const auto vertices = put(model.vertices);
        const auto seen = put(std::vector(parts.clusters.size(), model.seen));
        const auto color_table = put(colors.empty() ? std::vector<Rgba>(1) : colors);
        const auto shaded = put(std::vector<Rgba>(place.size(), Rgba{9, 9, 9, 9}));
        const auto numbers = put(texels.numbers);
        const auto pixel_count = static_cast<std::size_t>(texels.size.x * texels.size.y);
        const auto pixels = put(std::vector<Rgba>(pixel_count, untouched));
        std::vector<glm::uvec3> smooth_corners;
        for (const std::uint32_t i : parts.order)
            smooth_corners.push_back(model.normals.empty() ? glm::uvec3{LA_NO_SURFACE}
                                                           : model.triangles[i]);
        std::vector<ContourCorner> normals(1);
        for (std::uint32_t i = 0; i < model.normals.size(); ++i) {
            const glm::vec3 normal = model.normals[i];
            normals.resize(i + 1);
            normals[i] = {.vertex = i, .normal = {normal.x, normal.y, normal.z}};
        }
        const auto smooth_table = put(smooth_corners);
        const auto normal_table = put(normals);
        stages().fill({.model = {*clusters, *meshlets, *vertex_list, *corners,
                                 static_cast<std::uint32_t>(parts.clusters.size())},
                       .vertices = *vertices,
                       .seen = *seen,
                       .colors = colors.empty() ? nullptr : color_table.get(),
                       .smooth = {smooth_table.get(), normal_table.get()},
                       .fill = fill,
                       .clip_from_world = model.camera.clip_from_world(),
                       .first_texel = texels.first,
                       .texel_step = texels.step,
                       .eye_from_world = model.camera.view,
                       .eye = model.camera.eye(),
                       .shaded = *shaded,
                       .numbers = *numbers,
                       .row = texels.row,
                       .origin = texels.origin,
                       .scale = texels.scale,
                       .size = texels.size,
                       .part = texels.part,
                       .pixels = *pixels});
        return get<Rgba>(*pixels, pixel_count);
    }

    /// What one triangle, seen by this camera, gets.
    Rgba one(const std::array<glm::vec3, 3>& corners, const Camera& camera, const Fill& fill,
             Rgba color = {200, 100, 50, 255}) {
        const Model model{.vertices = {corners.begin(), corners.end()},
                          .triangles = {{0, 1, 2}},
                          .colors = {color},
                          .camera = camera};
        return this->fill(model, fill, {.numbers = {0}, .row = 1, .scale = 1, .size = {1, 1}})[0];
    }
};
INSTANTIATE_TEST_SUITE_P(OnDevice, FillStage, testing::ValuesIn(test_devices()),
                         [](const auto& info) { return info.param.name; });

const std::vector<glm::vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
const std::vector<glm::uvec3> halves{{0, 1, 2}, {0, 2, 3}};

Camera looks_along_z(bool perspective = true) {
    Camera camera;
    camera.size = {64, 64};
    camera.view = glm::lookAt(glm::vec3{0, 0, 5}, glm::vec3{0}, glm::vec3{0, 1, 0});
    camera.projection = perspective ? glm::perspective(1.0F, 1.0F, 1.0F, 20.0F)
                                    : glm::ortho(-2.0F, 2.0F, -2.0F, 2.0F, 1.0F, 20.0F);
    return camera;
}

/// Within one: rounding.
void expect_near(const Rgba& shown, const Rgba& expected) {
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(shown[c], expected[c], 1) << "channel " << c;
}

Rgba in_light(const Rgba& color, double light) {
    const double shade = std::pow(light, 1 / 2.2);
    const auto channel = [&](std::uint8_t c) {
        return static_cast<std::uint8_t>(std::lround(c * shade));
    };
    return {channel(color[0]), channel(color[1]), channel(color[2]), 255};
}

TEST_P(FillStage, APixelIsTheMeanOfItsTexels) {
    const Model model{
        .vertices = square, .triangles = halves, .colors = {{200, 100, 0, 255}, {0, 40, 81, 255}}};
    const std::vector<std::uint32_t> texels{0, 0, 0,    1, 0,    none, none, none, //
                                            0, 0, none, 1, none, none, none, none};
    const std::vector<Rgba> shown = fill(model, {.mode = FillMode::flat},
                                         {.numbers = texels, .row = 8, .scale = 2, .size = {4, 1}});
    EXPECT_EQ(shown[0], (Rgba{200, 100, 0, 255}));
    EXPECT_EQ(shown[1], (Rgba{50, 45, 41, 191})) << "a quarter, a half and a quarter of nothing";
    EXPECT_EQ(shown[2], (Rgba{50, 25, 0, 64}));
    EXPECT_EQ(shown[3], (Rgba{0, 0, 0, 0}));
}

TEST_P(FillStage, EveryScaleCountsAllTexels) {
    const Model model{
        .vertices = square, .triangles = halves, .colors = {{255, 16, 0, 255}, {0, 240, 255, 255}}};
    for (const int scale : {1, 2, 3, 4}) {
        const int count = scale * scale;
        for (int covered = 0; covered <= count; ++covered) {
            for (int second = 0; second <= covered; ++second) {
                std::vector<std::uint32_t> texels(static_cast<std::size_t>(count), none);
                for (int i = 0; i < covered; ++i)
                    texels[static_cast<std::size_t>(i)] = i < second ? 1 : 0;
                const Rgba shown =
                    fill(model, {.mode = FillMode::flat},
                         {.numbers = texels, .row = scale, .scale = scale, .size = {1, 1}})[0];
                const auto mean = [&](int a, int b) {
                    return static_cast<std::uint8_t>(
                        ((covered - second) * a + second * b + count / 2) / count);
                };
                ASSERT_EQ(shown, (Rgba{mean(255, 0), mean(16, 240), mean(0, 255), mean(255, 255)}))
                    << scale << ", " << covered << ", " << second;
            }
        }
    }
}

TEST_P(FillStage, OnlyThePartIsColouredFromItsOwnTexels) {
    // Texel (x, y) of a tile that begins at (1, 2) shows triangle 0 where x + 2 y is even.
    constexpr glm::ivec2 size{5, 3}, origin{1, 2};
    constexpr int row = 8, rows = 6;
    std::vector<std::uint32_t> texels;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < row; ++x)
            texels.push_back((x - origin.x + 2 * (y - origin.y)) % 3 == 0 ? 0 : 1);
    }
    const Model model{
        .vertices = square, .triangles = halves, .colors = {{7, 0, 0, 255}, {0, 9, 0, 255}}};
    const TexelRectangle part{{1, 1}, {4, 3}};
    const std::vector<Rgba> shown = fill(
        model, {.mode = FillMode::flat},
        {.numbers = texels, .row = row, .scale = 1, .size = size, .origin = origin, .part = part});
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const bool in = x >= part.low.x && x < part.high.x && y >= part.low.y;
            const Rgba expected = !in                    ? untouched
                                  : (x + 2 * y) % 3 == 0 ? Rgba{7, 0, 0, 255}
                                                         : Rgba{0, 9, 0, 255};
            ASSERT_EQ(shown[static_cast<std::size_t>(y * size.x + x)], expected) << x << ", " << y;
        }
    }
}

TEST_P(FillStage, WhatHasNoColourHasTheFills) {
    Model model{.vertices = square, .triangles = halves};
    const Fill flat{.mode = FillMode::flat, .color = {0.2F, 1, 0}};
    const Texels texels{.numbers = {0, 1}, .row = 2, .scale = 1, .size = {2, 1}};
    for (const Rgba& shown : fill(model, flat, texels)) EXPECT_EQ(shown, (Rgba{51, 255, 0, 255}));
    model.colors = {{10, 20, 30, 255}, {0, 0, 0, 0}};
    const std::vector<Rgba> shown = fill(model, flat, texels);
    EXPECT_EQ(shown[0], (Rgba{10, 20, 30, 255}));
    EXPECT_EQ(shown[1], (Rgba{51, 255, 0, 255}));
}

TEST_P(FillStage, LambertFollowsTheAngleOfTheLight) {
    const Rgba color{200, 100, 50, 255};
    const std::array<glm::vec3, 3> face{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    for (const bool perspective : {true, false}) {
        const Camera camera = looks_along_z(perspective);
        for (const int degrees : {0, 30, 60, 75, 89, 120}) {
            const float angle = static_cast<float>(degrees) * std::numbers::pi_v<float> / 180;
            const Fill lambert{.mode = FillMode::lambert,
                               .light = 3.0F * glm::vec3{std::sin(angle), 0, std::cos(angle)},
                               .ambient = 0.25F};
            const double lit = std::max(0.0, std::cos(double{angle}));
            const Rgba expected = in_light(color, 0.25 + 0.75 * lit);
            SCOPED_TRACE(degrees);
            expect_near(one(face, camera, lambert, color), expected);
            expect_near(one({face[0], face[2], face[1]}, camera, lambert, color), expected);
        }
    }
}

TEST_P(FillStage, SmoothTrianglesAreLitByTheNormalsOfTheirCorners) {
    const glm::vec3 up{0, 0, 1}, aside{0.8F, 0, 0.6F};
    const Fill lambert{.mode = FillMode::lambert, .light = up, .ambient = 0};
    const Rgba color{200, 100, 50, 255};
    const auto texels = [&](bool perspective, bool turned, float side) {
        Model model{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                    .triangles = {turned ? glm::uvec3{0, 2, 1} : glm::uvec3{0, 1, 2}},
                    .colors = {color},
                    .camera = looks_along_z(perspective),
                    .normals = {side * up, side * aside, side * up}};
        const glm::vec4 corner = model.camera.clip_from_world() * glm::vec4{1, 0, 0, 1};
        return fill(model, lambert,
                    {.numbers = {0, 0, 0, none},
                     .row = 4,
                     .scale = 1,
                     .size = {4, 1},
                     .step = {corner.x / corner.w / 2, 0}});
    };
    // At a corner, half way to the next, and there; in the middle the sum of both counts.
    const double between = glm::normalize(up + aside).z;
    for (const bool perspective : {true, false}) {
        for (const bool turned : {false, true}) {
            // Whichever way normals look, that side is lit which is seen.
            for (const float side : {1.0F, -1.0F}) {
                const std::vector<Rgba> shown = texels(perspective, turned, side);
                expect_near(shown[0], in_light(color, 1));
                expect_near(shown[1], in_light(color, between));
                expect_near(shown[2], in_light(color, 0.6));
                EXPECT_EQ(shown[3], (Rgba{0, 0, 0, 0}));
            }
        }
    }
}

TEST_P(FillStage, TheDarkestShadesAreNotLost) {
    const std::array<glm::vec3, 3> face{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    const Rgba white{255, 255, 255, 255};
    for (const float ambient : {0.0F, 1e-5F, 1e-4F, 1e-3F, 0.01F, 0.1F, 0.5F, 1.0F}) {
        const Fill lambert{.mode = FillMode::lambert, .light = {0, 0, -1}, .ambient = ambient};
        expect_near(one(face, looks_along_z(), lambert, white), in_light(white, ambient));
    }
}

TEST_P(FillStage, TheSideThatIsSeenIsTheOneInTheLight) {
    // A wall to the right of the eye is seen from its left side, though it turns a little away from
    // the direction of sight.
    const std::array<glm::vec3, 3> wall{{{2, 0, 0}, {2, 1, 0}, {1.9F, 0, 1}}};
    const glm::vec3 normal = glm::normalize(glm::cross(wall[1] - wall[0], wall[2] - wall[0]));
    ASSERT_GT(normal.x, 0);
    ASSERT_GT(normal.z, 0);
    const Camera camera = looks_along_z();
    const Fill from_left{.mode = FillMode::lambert, .light = -normal, .ambient = 0.1F};
    const Fill from_right{.mode = FillMode::lambert, .light = normal, .ambient = 0.1F};
    const Rgba color{200, 100, 50, 255};
    expect_near(one(wall, camera, from_left, color), color);
    expect_near(one(wall, camera, from_right, color), in_light(color, 0.1));
}

TEST_P(FillStage, LightIsThatOfTheEyesSpace) {
    // Turned, mirrored and enlarged: a face of the plane x = 0 lies at 45 degrees to x and z there.
    Camera camera = looks_along_z();
    const glm::mat4 away = glm::translate(glm::mat4{1}, glm::vec3{0, 0, -5});
    const glm::mat4 turned =
        glm::rotate(glm::mat4{1}, -std::numbers::pi_v<float> / 4, glm::vec3{0, 1, 0});
    const std::array<glm::vec3, 3> face{{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const Fill lambert{.mode = FillMode::lambert, .light = {0, 0, 1}, .ambient = 0};
    const Rgba color{200, 100, 50, 255};
    for (const glm::vec3 scale : {glm::vec3{1, 1, 1}, {-1, 1, 1}, {2, 2, 2}}) {
        camera.view = away * turned * glm::scale(glm::mat4{1}, scale);
        expect_near(one(face, camera, lambert, color), in_light(color, std::sqrt(0.5)));
    }
    // Stretched to twice its depth, it turns away: its tangent is 2.
    camera.view = away * glm::scale(glm::mat4{1}, glm::vec3{1, 1, 2}) * turned;
    expect_near(one(face, camera, lambert, color), in_light(color, std::sqrt(0.2)));
}

TEST_P(FillStage, ToonHasItsSteps) {
    const std::array<glm::vec3, 3> face{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    const Rgba color{200, 100, 50, 255};
    // Cosine of the light's angle, and the step of three that it falls on.
    for (const auto& [cosine, step] :
         {std::pair{0.1F, 0.0}, {0.3F, 0.0}, {0.4F, 0.5}, {0.6F, 0.5}, {0.7F, 1.0}, {1.0F, 1.0}}) {
        const Fill toon{.mode = FillMode::toon,
                        .light = {std::sqrt(1 - cosine * cosine), 0, cosine},
                        .ambient = 0.2F,
                        .toon_steps = 3};
        SCOPED_TRACE(cosine);
        expect_near(one(face, looks_along_z(), toon, color), in_light(color, 0.2 + 0.8 * step));
    }
}

TEST_P(FillStage, TrianglesOfClustersThatAreNotSeenAreLeftOut) {
    const Model model{.vertices = square,
                      .triangles = halves,
                      .colors = {{200, 100, 0, 255}, {0, 40, 80, 255}},
                      .seen = 0};
    const std::vector<Rgba> shown = fill(model, {.mode = FillMode::flat},
                                         {.numbers = {0, 1}, .row = 2, .scale = 1, .size = {2, 1}});
    for (const Rgba& pixel : shown) EXPECT_EQ(pixel, (Rgba{9, 9, 9, 9})) << "as they were";
}

} // namespace
} // namespace lineatlas::test
