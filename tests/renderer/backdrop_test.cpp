// Fills below the lines, and the paper's grain above them.

#include "renderer/backdrop.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "compare.hpp"
#include "core/paper.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "glpasses/interop/connect.hpp"
#include "lineatlas/error.hpp"
#include "renderer/depth_stage.hpp"
#include "scene_cameras.hpp"

namespace lineatlas::test {
namespace {

using Color = std::array<int, 3>;

/// A cube whose six faces are groups: -x, +x, -y, +y, -z, +z.
Mesh colored_cube(const std::array<std::optional<glm::vec3>, 6>& colors) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.positions.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                                    (i & 4) != 0 ? 1 : -1);
    }
    const std::array<glm::uvec4, 6> quads{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (std::uint32_t face = 0; face < 6; ++face) {
        const glm::uvec4 q = quads[face];
        mesh.triangles.emplace_back(q.x, q.y, q.z);
        mesh.triangles.emplace_back(q.x, q.w, q.z); // the other winding, which must not matter
        mesh.triangle_group.insert(mesh.triangle_group.end(), 2, face);
        mesh.groups.push_back({.object = "cube", .material = "m", .color = colors[face]});
    }
    return mesh;
}

Color bytes_of(glm::vec3 color) {
    const glm::vec3 rounded = glm::round(255.0F * color);
    return {static_cast<int>(rounded.x), static_cast<int>(rounded.y), static_cast<int>(rounded.z)};
}

class BackdropTest : public testing::Test {
  protected:
    using Ranges = std::vector<gl::TriangleRange>;

    std::vector<std::uint8_t> fill(SceneBuffers& scene, const Camera& camera, const Fill& fill) {
        canvas_.clear(glm::vec4{1});
        Frame frame = frame_of(scene, camera);
        backdrop_.draw_fill(frame, fill);
        return canvas_.read();
    }

    Frame frame_of(SceneBuffers& scene, const Camera& camera) {
        return {.camera = camera,
                .options = options_,
                .scene = scene,
                .framebuffer = canvas_.framebuffer(),
                .pens = pens_,
                .backdrop = backdrop_,
                .clock = {*connection_.sharing, false}};
    }

    /// Looks along -z at the middle of the cube's face +z, with x to the right.
    Camera front(const LineSet& lines, glm::vec3 eye = {0, 0, 5}) const {
        return make_camera({.eye = eye}, canvas_.size(), lines.bounds);
    }

    Color pixel(const std::vector<std::uint8_t>& pixels, int x, int y) const {
        const std::size_t at = (static_cast<std::size_t>(y) * canvas_.size().x + x) * 4;
        return {pixels[at], pixels[at + 1], pixels[at + 2]};
    }
    Color middle(const std::vector<std::uint8_t>& pixels) const {
        return pixel(pixels, canvas_.size().x / 2, canvas_.size().y / 2);
    }
    static std::set<Color> colors_in(const std::vector<std::uint8_t>& pixels) {
        std::set<Color> result;
        for (std::size_t i = 0; i < pixels.size(); i += 4) {
            result.insert({pixels[i], pixels[i + 1], pixels[i + 2]});
        }
        return result;
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{400, 300}};
    interop::Connection connection_ = interop::connect({});
    FrameOptions options_{.depth_scale = 1};
    PenTextures pens_;
    Backdrop backdrop_;
};

constexpr glm::vec3 left{0.2F, 0.4F, 0.6F};
constexpr glm::vec3 right{0.6F, 0.4F, 0.2F};
constexpr glm::vec3 top{0.1F, 0.9F, 0.1F};
constexpr glm::vec3 facing{0.9F, 0.3F, 0.7F};

TEST_F(BackdropTest, FlatIsTheColorOfEachFaceAndNothingElse) {
    const LineSet lines =
        extract_lines(colored_cube({left, right, std::nullopt, top, std::nullopt, facing}));
    ASSERT_EQ(lines.colors.size(), 4U);
    SceneBuffers scene{*connection_.stages, *connection_.sharing, lines};
    const Fill flat{.mode = FillMode::flat, .color = {1, 1, 0}};
    const std::set<Color> seen = colors_in(fill(scene, front(lines, {4, 3, 5}), flat));
    EXPECT_EQ(seen,
              (std::set<Color>{{255, 255, 255}, bytes_of(right), bytes_of(top), bytes_of(facing)}));
    EXPECT_EQ(middle(fill(scene, front(lines, {0, 0.1F, -5}), flat)), (Color{255, 255, 0}))
        << "a face without a material's colour has the fill's";
}

TEST_F(BackdropTest, AModelWithoutColorsHasTheFills) {
    Mesh mesh = colored_cube({});
    mesh.groups.clear();
    mesh.triangle_group.clear();
    const LineSet lines = extract_lines(mesh);
    EXPECT_TRUE(lines.triangle_color.empty());
    SceneBuffers scene{*connection_.stages, *connection_.sharing, lines};
    const Fill flat{.mode = FillMode::flat, .color = {0, 1, 0}};
    EXPECT_EQ(middle(fill(scene, front(lines), flat)), (Color{0, 255, 0}));
}

TEST_F(BackdropTest, MoreColorsThanAByteCounts) {
    Mesh mesh = colored_cube({left, right, top, top, left, facing});
    for (int i = 0; i < 300; ++i) { // hidden within the cube
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const float x = static_cast<float>(i) * 1e-3F;
        mesh.positions.insert(mesh.positions.end(), {{x, 0, 0}, {x, 0.1F, 0}, {x, 0, 0.1F}});
        mesh.triangles.emplace_back(first, first + 1, first + 2);
        mesh.triangle_group.push_back(static_cast<std::uint32_t>(mesh.groups.size()));
        mesh.groups.push_back({.object = "o", .material = "m", .color = glm::vec3{x, 0, 0}});
    }
    std::ranges::rotate(mesh.groups, mesh.groups.begin() + 6); // the cube's colours come last
    const auto count = static_cast<std::uint32_t>(mesh.groups.size());
    for (std::uint32_t& group : mesh.triangle_group) group = (group + count - 6) % count;
    const LineSet lines = extract_lines(mesh);
    ASSERT_GT(lines.colors.size(), 256U);
    SceneBuffers scene{*connection_.stages, *connection_.sharing, lines};
    const Fill flat{.mode = FillMode::flat};
    EXPECT_EQ(middle(fill(scene, front(lines), flat)), bytes_of(facing));
}

TEST_F(BackdropTest, LambertShadesByTheFacesNormal) {
    const LineSet lines = extract_lines(colored_cube({left, right, top, top, left, facing}));
    SceneBuffers scene{*connection_.stages, *connection_.sharing, lines};
    for (const glm::vec3 light : {glm::vec3{0, 0, 1}, {1, 0, 1}, {0.3F, 2, 0.5F}, {0, 0.5F, -1}}) {
        const Fill lambert{.mode = FillMode::lambert, .light = light, .ambient = 0.3F};
        const float lit = std::max(0.0F, glm::normalize(light).z);
        const Color expected = bytes_of(facing * std::pow(0.3F + 0.7F * lit, 1 / 2.2F));
        const Color shown = middle(fill(scene, front(lines), lambert));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(shown[c], expected[c], 1);
        // Both windings of the face.
        const std::vector<std::uint8_t> pixels = fill(scene, front(lines), lambert);
        EXPECT_EQ(pixel(pixels, 180, 130), pixel(pixels, 220, 170));
        EXPECT_EQ(pixel(pixels, 180, 170), pixel(pixels, 220, 130));
    }
}

TEST_F(BackdropTest, ToonHasNoMoreShadesThanSteps) {
    const LineSet& sphere = scene_lines("clevis");
    LineSet lines = sphere;
    lines.triangle_color.clear();
    SceneBuffers scene{*connection_.stages, *connection_.sharing, lines};
    const Camera camera = scene_cameras("clevis", canvas_.size()).front().camera;
    for (const int steps : {2, 3, 8}) {
        const std::set<Color> seen =
            colors_in(fill(scene, camera, {.mode = FillMode::toon, .toon_steps = steps}));
        EXPECT_LE(seen.size(), static_cast<std::size_t>(steps) + 1) << "and the paper";
        EXPECT_GT(seen.size(), 2U);
    }
}

/// The picture of the single triangles in the order of the line set. Clusters must not change it.
std::vector<std::uint8_t> expected_fill(const LineSet& lines, const Camera& camera,
                                        const gl::Canvas& canvas, const Fill& fill) {
    gl::Buffer vertices = gl::Buffer::create();
    gl::Buffer indices = gl::Buffer::create();
    gl::Buffer color_indices = gl::Buffer::create();
    gl::Buffer table = gl::Buffer::create();
    const auto upload = [](const gl::Buffer& buffer, const auto& values) {
        glNamedBufferStorage(buffer.id(),
                             static_cast<GLsizeiptr>(values.size() * sizeof(values[0])),
                             values.data(), 0);
    };
    std::vector<std::array<std::uint8_t, 4>> colors;
    for (const glm::vec3& color : lines.colors) {
        const Color c = bytes_of(color);
        colors.push_back({static_cast<std::uint8_t>(c[0]), static_cast<std::uint8_t>(c[1]),
                          static_cast<std::uint8_t>(c[2]), 255});
    }
    upload(vertices, lines.vertices);
    upload(indices, lines.triangles);
    upload(color_indices, lines.triangle_color);
    upload(table, colors);
    const auto count = static_cast<std::uint32_t>(lines.triangles.size());
    const gl::TriangleRange all{0, count};
    gl::FillPass{}.draw({vertices.id(), indices.id(), count},
                        {color_indices.id(), GL_R16UI, table.id()}, {}, {&all, 1},
                        {camera.clip_from_world(), camera.view, canvas.size()}, fill,
                        canvas.framebuffer());
    return canvas.read();
}

TEST_F(BackdropTest, ClustersDoNotShow) {
    const LineSet& lines = scene_lines("ship");
    SceneBuffers scene{*connection_.stages, *connection_.sharing, lines};
    ASSERT_FALSE(scene.clusters().empty());
    DepthStage stage{connection_};
    stage.set_scene(scene);
    const Fill flat{.mode = FillMode::flat};
    for (const NamedCamera& view : scene_cameras("ship", canvas_.size())) {
        SCOPED_TRACE(view.name);
        canvas_.clear(glm::vec4{1});
        const std::vector<std::uint8_t> expected = expected_fill(lines, view.camera, canvas_, flat);
        EXPECT_GT(colors_in(expected).size(), 4U);
        // The order of drawing decides between two faces of the same depth.
        const auto expect_same = [&](const std::vector<std::uint8_t>& shown) {
            EXPECT_LE(compare_bytes(shown, expected, 0).share(), 2e-4);
        };
        expect_same(fill(scene, view.camera, flat));
        for (int step = 0; step < 3; ++step) { // all clusters, then those seen before
            Frame frame = frame_of(scene, view.camera);
            stage.draw_for_compute(frame);
            const std::span<const gl::TriangleRange> drawn = stage.drawn();
            const auto count = std::accumulate(
                drawn.begin(), drawn.end(), 0U,
                [](std::uint32_t sum, gl::TriangleRange range) { return sum + range.count; });
            EXPECT_EQ(count, stage.triangles_drawn());
            if (step == 2) {
                EXPECT_LT(count, scene.triangle_count());
            }
            canvas_.clear(glm::vec4{1});
            backdrop_.draw_fill(frame, flat, drawn);
            const std::vector<std::uint8_t> shown = canvas_.read();
            expect_same(shown);
            EXPECT_LE(compare_bytes(shown, fill(scene, view.camera, flat), 0).beyond, 12U);
        }
    }
}

TEST_F(BackdropTest, NoFillDrawsNothing) {
    const LineSet& lines = scene_lines("clevis");
    SceneBuffers scene{*connection_.stages, *connection_.sharing, lines};
    const Camera camera = scene_cameras("clevis", canvas_.size()).front().camera;
    EXPECT_EQ(colors_in(fill(scene, camera, {})), (std::set<Color>{{255, 255, 255}}));
}

TEST_F(BackdropTest, AFillNeedsNoDepthAttachment) {
    const LineSet& lines = scene_lines("clevis");
    SceneBuffers scene{*connection_.stages, *connection_.sharing, lines};
    const Camera camera = scene_cameras("clevis", canvas_.size()).front().camera;
    Frame frame = frame_of(scene, camera);
    const gl::Texture2D texture = gl::Texture2D::create();
    glTextureStorage2D(texture.id(), 1, GL_RGBA8, 400, 300);
    const gl::Framebuffer flat = gl::Framebuffer::create();
    glNamedFramebufferTexture(flat.id(), GL_COLOR_ATTACHMENT0, texture.id(), 0);
    frame.framebuffer = flat.id();
    EXPECT_NO_THROW(backdrop_.draw_fill(frame, {.mode = FillMode::flat}));
    EXPECT_NO_THROW(backdrop_.draw_paper(frame, {.grain = 1}));
}

TEST_F(BackdropTest, PaperGrainDarkensALittleAndLeavesAlpha) {
    const LineSet& lines = scene_lines("clevis");
    SceneBuffers scene{*connection_.stages, *connection_.sharing, lines};
    const Camera camera = scene_cameras("clevis", canvas_.size()).front().camera;
    const auto on_paper = [&](float grain) {
        canvas_.clear({0.8F, 0.8F, 0.8F, 0.8F});
        Frame frame = frame_of(scene, camera);
        backdrop_.draw_paper(frame, {.grain = grain});
        return canvas_.read();
    };
    const auto mean = [](const std::vector<std::uint8_t>& pixels) {
        double sum = 0;
        for (std::size_t i = 0; i < pixels.size(); i += 4) sum += pixels[i];
        return sum / static_cast<double>(pixels.size() / 4);
    };
    const std::vector<std::uint8_t> smooth = on_paper(0);
    const std::vector<std::uint8_t> rough = on_paper(1);
    EXPECT_EQ(colors_in(smooth), (std::set<Color>{{204, 204, 204}}));
    EXPECT_TRUE(equal(rough, on_paper(1)));
    EXPECT_GT(colors_in(rough).size(), 20U);
    EXPECT_GT(mean(rough), 0.85 * mean(smooth));
    EXPECT_LT(mean(rough), 0.97 * mean(smooth));
    EXPECT_NEAR(mean(on_paper(0.5F)), 0.5 * (mean(smooth) + mean(rough)), 1.0);
    for (std::size_t i = 3; i < rough.size(); i += 4) ASSERT_EQ(rough[i], 204);
}

TEST(MakePaper, HasNoSeam) {
    const PaperTile tile = make_paper();
    constexpr int size = PaperTile::size;
    ASSERT_EQ(tile.depth.size(), std::size_t{size} * size);
    EXPECT_EQ(tile.depth, make_paper().depth);
    const auto step = [&](int x0, int x1, bool turned) {
        double sum = 0;
        for (int i = 0; i < size; ++i) {
            const auto at = [&](int x) { return turned ? x * size + i : i * size + x; };
            sum += std::abs(tile.depth[at(x0)] - tile.depth[at(x1)]);
        }
        return sum / size;
    };
    for (const bool turned : {false, true}) {
        // Noise is steeper at the borders of its cells than between them.
        const double inside = step(size / 2 - 1, size / 2, turned);
        EXPECT_LT(step(size - 1, 0, turned), 1.3 * inside);
    }
}

} // namespace
} // namespace lineatlas::test
