// Pictures drawn by tiles compared with pictures drawn in one piece.

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "compare.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "scene_cameras.hpp"
#include "test_meshes.hpp"

namespace lineatlas::test {
namespace {

using Picture = std::vector<std::uint8_t>;

/// The share of pixels that differ. It counts pixels, not their values.
double share_of_pixels(const Picture& a, const Picture& b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); i += 4) {
        const std::span<const std::uint8_t> p{&a[i], 4}, q{&b[i], 4};
        if (compare_bytes(p, q).beyond > 0) ++different;
    }
    return static_cast<double>(different) / static_cast<double>(a.size() / 4);
}

class Tiles : public testing::TestWithParam<std::string> {
  protected:
    Renderer renderer(const std::string& scene) {
        Renderer result{{.compute = GetParam()}};
        result.set_lines(scene_lines(scene));
        return result;
    }

    static Camera camera(const std::string& scene, glm::ivec2 size, float at = 0.1F) {
        return make_camera(make_scene(scene).view(at), size, scene_lines(scene).bounds);
    }

    static Picture whole(Renderer& renderer, const Camera& camera, const FrameOptions& options) {
        gl::Canvas canvas{camera.size};
        canvas.clear(glm::vec4{1});
        renderer.draw(camera, options, canvas.framebuffer());
        return canvas.read();
    }

    static Picture tiled(Renderer& renderer, const Camera& camera, const FrameOptions& options,
                         int tile_size) {
        gl::Canvas canvas{glm::min(camera.size, tile_size)};
        const auto row = static_cast<std::size_t>(camera.size.x) * 4;
        Picture picture(row * static_cast<std::size_t>(camera.size.y), 77);
        renderer.draw_tiles(
            camera, options,
            {.framebuffer = canvas.framebuffer(),
             .tile_size = tile_size,
             .begin = [&](const PictureTile&) { canvas.clear(glm::vec4{1}); },
             .end =
                 [&](const PictureTile& tile) {
                     const Picture part = canvas.read(tile.size);
                     const auto length = static_cast<std::size_t>(tile.size.x) * 4;
                     for (int y = 0; y < tile.size.y; ++y) {
                         const int to = camera.size.y - tile.low.y - tile.size.y + y;
                         std::copy_n(part.begin() + y * static_cast<std::ptrdiff_t>(length), length,
                                     picture.begin() + to * static_cast<std::ptrdiff_t>(row) +
                                         tile.low.x * 4);
                     }
                 }});
        return picture;
    }

    gl::HeadlessContext context_;
};

std::size_t dark_values(const Picture& picture) {
    return static_cast<std::size_t>(
        std::ranges::count_if(picture, [](std::uint8_t value) { return value < 128; }));
}

TEST_P(Tiles, SmallOnesMakeTheSamePicture) {
    for (const char* scene : {"clevis", "house"}) {
        Renderer r = renderer(scene);
        const Camera view = camera(scene, {403, 301});
        for (const FrameOptions& options : {FrameOptions{.forms = {.atlas = StageForm::compute}},
                                            FrameOptions{.method = Method::exact},
                                            FrameOptions{.probes = 1,
                                            .depth_scale = 1,
                                            .step = 5,
                                            .forms = {.atlas = StageForm::compute}}}) {
            const Picture expected = whole(r, view, options);
            ASSERT_GT(dark_values(expected), 3000U);
            for (const int size : {64, 101, 500}) {
                EXPECT_LE(share_of_pixels(expected, tiled(r, view, options, size)), 1e-4)
                    << scene << " " << size;
            }
        }
    }
}

TEST_P(Tiles, EveryEffectRunsOnOverTheirBorders) {
    Style style{.pen = {.mark = "charcoal",
                        .width = 5,
                        .join = Join::round,
                        .cap = Cap::taper,
                        .width_profile = {0.5F, 1.5F, 0.5F}}};
    style.hidden = true;
    style.filter = {.fill_holes = 3, .drop_runs = 4, .overshoot = 9, .halo = 3};
    style.density.limit = 0.1F;
    style.fill.mode = FillMode::lambert;
    style.paper.grain = 0.5F;
    style.focus = {.on = true, .point = {0.4F, 0.6F, 0}};
    for (const Method method : {Method::atlas, Method::exact}) {
        const FrameOptions options{
            .method = method, .forms = {.atlas = StageForm::compute}, .style = style};
        Renderer r = renderer("clevis");
        const Camera view = camera("clevis", {400, 300});
        const Picture expected = whole(r, view, options);
        EXPECT_LE(share_of_pixels(expected, tiled(r, view, options, 130)), 5e-4);
    }
}

TEST_P(Tiles, SmoothSurfacesHaveTheirLightInEach) {
    Renderer r{{.compute = GetParam()}};
    r.set_lines(extract_lines(sphere(3), {.silhouettes = Silhouettes::smooth}));
    Camera view;
    view.size = {301, 203};
    view.view = glm::lookAt(glm::vec3{3, 2, 4}, glm::vec3{0}, glm::vec3{0, 1, 0});
    view.projection = glm::perspective(0.45F, 301.0F / 203.0F, 1.0F, 20.0F);
    for (const StageForm form : {StageForm::raster, StageForm::compute}) {
        FrameOptions options{.forms = {.depth = form}};
        options.style.fill.mode = FillMode::toon;
        const Picture expected = whole(r, view, options);
        EXPECT_LE(share_of_pixels(expected, tiled(r, view, options, 64)), 5e-4);
    }
}

TEST_P(Tiles, LeaveNothingBehindForTheNextFrame) {
    Renderer r = renderer("house");
    const Camera view = camera("house", {200, 150});
    const FrameOptions options{.forms = {.atlas = StageForm::compute}};
    const Picture first = whole(r, view, options);
    tiled(r, camera("house", {700, 500}), options, 90);
    EXPECT_FALSE(r.read_samples().alpha.empty());
    EXPECT_TRUE(equal(first, whole(r, view, options)));
}

TEST_P(Tiles, ReachBeyondWhatGlCanDraw) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    Renderer r = renderer("clevis");
    Camera view = camera("clevis", {largest + 700, 300});
    const FrameOptions options{.depth_scale = 1};
    EXPECT_THROW(whole(r, view, options), UsageError);
    const Picture a = tiled(r, view, options, 4096);
    EXPECT_GT(dark_values(a), 3000U);
    EXPECT_LE(share_of_pixels(a, tiled(r, view, options, 1500)), 1e-4);
}

TEST_P(Tiles, AreForTheMethodsAtlasAndExactAlone) {
    Renderer r = renderer("clevis");
    const Camera view = camera("clevis", {100, 80});
    for (const FrameOptions& options :
         {FrameOptions{.method = Method::spine}, FrameOptions{.method = Method::opengl},
          FrameOptions{.method = Method::item_buffer},
          FrameOptions{.forms = {.atlas = StageForm::raster}}}) {
        EXPECT_THROW(tiled(r, view, options, 50), UsageError);
    }
    EXPECT_THROW(r.draw_tiles(view, {}, {.framebuffer = 0, .tile_size = 0}), UsageError);
}

INSTANTIATE_TEST_SUITE_P(Compute, Tiles, testing::Values("opencl", "cpp"),
                         [](const auto& info) { return info.param; });

/// Large pictures. Their depth has twice as many texels a side, just within the limits of GL.
class LargeTiles : public Tiles {};

TEST_P(LargeTiles, MakeTheSamePicture) {
    for (const char* scene : {"clevis", "house"}) {
        Renderer r = renderer(scene);
        const Camera view = camera(scene, {4096, 3072});
        const FrameOptions options{.forms = {.atlas = StageForm::compute}};
        const Picture expected = whole(r, view, options);
        ASSERT_GT(dark_values(expected), 100'000U);
        EXPECT_LE(share_of_pixels(expected, tiled(r, view, options, 1000)), 1e-4) << scene;
    }
}

/// In a model with thousands of barely hidden lines the last bits of depth decide some pixels. Such
/// pixels may be anywhere, but must not gather along the borders of tiles.
TEST_P(LargeTiles, DifferNowhereMoreThanElsewhere) {
    constexpr int tile_size = 300, seam = 3; // pixels on either side
    Renderer r = renderer("ship");
    const Camera view = camera("ship", {1600, 1200});
    const FrameOptions options{.forms = {.atlas = StageForm::compute}};
    const Picture a = whole(r, view, options);
    const Picture b = tiled(r, view, options, tile_size);
    std::size_t different = 0, at_seams = 0;
    for (int y = 0; y < view.size.y; ++y) {
        for (int x = 0; x < view.size.x; ++x) {
            const auto i = static_cast<std::size_t>(y * view.size.x + x) * 4;
            if (compare_bytes({&a[i], 4}, {&b[i], 4}).beyond == 0) continue;
            ++different;
            const int to_x = std::min(x % tile_size, tile_size - x % tile_size);
            const int to_y = std::min(y % tile_size, tile_size - y % tile_size);
            if (std::min(to_x, to_y) < seam) ++at_seams;
        }
    }
    const double area = 4.0 * seam / tile_size; // the share of the picture that seams cover
    EXPECT_LE(at_seams, 3 * area * static_cast<double>(different) + 10);
    EXPECT_LE(static_cast<double>(different), 1e-3 * static_cast<double>(a.size() / 4));
}

INSTANTIATE_TEST_SUITE_P(Compute, LargeTiles, testing::Values("opencl"));

} // namespace
} // namespace lineatlas::test
