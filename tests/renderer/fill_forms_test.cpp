// The two forms of `fill` against each other: what kernels colour is what GL draws with as many
// pixels as the depth buffer has texels, and their mean.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <tuple>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "compare.hpp"
#include "devices.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "scene_cameras.hpp"
#include "test_meshes.hpp"

namespace lineatlas::test {
namespace {

using Picture = std::vector<std::uint8_t>;

/// The mean of each `scale` by `scale` pixels, rounded.
Picture reduced(const Picture& large, glm::ivec2 size, int scale) {
    Picture result;
    const auto row = static_cast<std::size_t>(size.x * scale) * 4;
    const auto count = static_cast<unsigned>(scale * scale);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            for (std::size_t c = 0; c < 4; ++c) {
                unsigned sum = 0;
                for (int k = 0; k < scale * scale; ++k) {
                    const auto at_y = static_cast<std::size_t>(y * scale + k / scale);
                    const auto at_x = static_cast<std::size_t>(x * scale + k % scale);
                    sum += large[at_y * row + at_x * 4 + c];
                }
                result.push_back(static_cast<std::uint8_t>((sum + count / 2) / count));
            }
        }
    }
    return result;
}

/// Share of the pixels any of whose channels is more than `allowed` away.
double share_beyond(const Picture& a, const Picture& b, int allowed) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); i += 4) {
        const std::span<const std::uint8_t> p{&a[i], 4}, q{&b[i], 4};
        if (compare_bytes(p, q, allowed).beyond > 0) ++different;
    }
    return static_cast<double>(different) / static_cast<double>(a.size() / 4);
}

std::size_t filled(const Picture& picture) {
    std::size_t count = 0;
    for (std::size_t i = 3; i < picture.size(); i += 4) count += picture[i] != 0 ? 1 : 0;
    return count;
}

class FillForms : public testing::TestWithParam<std::string> {
  protected:
    /// A fill without lines, on nothing.
    static FrameOptions options_of(FillMode mode, StageForm form, int scale) {
        FrameOptions options{.depth_scale = scale, .lines = 0, .forms = {.depth = form}};
        options.style.fill.mode = mode;
        return options;
    }

    Picture draw(Renderer& renderer, const Camera& camera, const FrameOptions& options) {
        gl::Canvas canvas{camera.size};
        canvas.clear(glm::vec4{0});
        renderer.draw(camera, options, canvas.framebuffer());
        return canvas.read();
    }
    /// In the raster form, with a pixel for each texel.
    Picture expected(Renderer& renderer, Camera camera, FillMode mode, int scale) {
        const glm::ivec2 size = camera.size;
        camera.size *= scale;
        return reduced(draw(renderer, camera, options_of(mode, StageForm::raster, 1)), size, scale);
    }

    gl::HeadlessContext context_;
    Renderer renderer_{{.compute = GetParam()}};
};

TEST_P(FillForms, PixelsAreTheMeanOfWhatGlDrawsInTheirTexels) {
    for (const char* scene : {"clevis", "house", "ship", "office"}) {
        renderer_.set_lines(scene_lines(scene));
        for (const NamedCamera& view : scene_cameras(scene, {400, 300})) {
            const FillMode mode = view.name == "inside" ? FillMode::flat : FillMode::lambert;
            const Picture large = expected(renderer_, view.camera, mode, 2);
            const Picture shown =
                draw(renderer_, view.camera, options_of(mode, StageForm::compute, 2));
            EXPECT_GT(filled(shown), 5000U);
            const double differ = share_beyond(shown, large, 1);
            std::cout << scene << ' ' << view.name << ": " << 100 * differ << " % of the pixels\n";
            EXPECT_LE(differ, 1e-3) << scene << " " << view.name;
        }
    }
}

TEST_P(FillForms, EveryDepthScaleAndMethodColoursTheSame) {
    renderer_.set_lines(scene_lines("clevis"));
    const Camera camera = scene_cameras("clevis", {301, 203}).front().camera;
    for (const int scale : {1, 2, 3, 4}) {
        const Picture large = expected(renderer_, camera, FillMode::lambert, scale);
        FrameOptions options = options_of(FillMode::lambert, StageForm::compute, scale);
        for (const Method method : {Method::atlas, Method::exact, Method::spine}) {
            options.method = method;
            EXPECT_LE(share_beyond(draw(renderer_, camera, options), large, 1), 1e-3)
                << scale << " " << static_cast<int>(method);
        }
    }
}

TEST_P(FillForms, BothFormsDrawTheSamePicture) {
    for (const char* scene : {"clevis", "house", "ship", "office"}) {
        renderer_.set_lines(scene_lines(scene));
        for (const int scale : {1, 2, 3, 4}) {
            const Camera camera = scene_cameras(scene, {400, 300}).front().camera;
            const auto drawn = [&](StageForm form) {
                return draw(renderer_, camera, options_of(FillMode::toon, form, scale));
            };
            const double differ =
                share_beyond(drawn(StageForm::raster), drawn(StageForm::compute), 1);
            std::cout << scene << " at " << scale << ": " << 100 * differ << " % of the pixels\n";
            // One texel of 4,000 lies on a border that the two rasterizers judge otherwise.
            EXPECT_LE(differ, 2.5e-4 * scale * scale) << scene << " at " << scale;
        }
    }
}

TEST_P(FillForms, LargePicturesOfGlHaveNoSeams) {
    // More texels than are drawn at once.
    renderer_.set_lines(scene_lines("clevis"));
    const Camera camera = scene_cameras("clevis", {2040, 200}).front().camera;
    const auto drawn = [&](StageForm form) {
        return draw(renderer_, camera, options_of(FillMode::lambert, form, 4));
    };
    const Picture by_gl = drawn(StageForm::raster), by_kernels = drawn(StageForm::compute);
    EXPECT_LE(share_beyond(by_gl, by_kernels, 1), 1e-3);
    // The columns beside the border between both parts.
    std::size_t covered = 0, differ = 0;
    for (int i = 0; i < 2 * camera.size.y; ++i) {
        const auto at = static_cast<std::size_t>((i / 2) * camera.size.x + 1023 + i % 2) * 4;
        const std::span<const std::uint8_t> p{&by_gl[at], 4}, q{&by_kernels[at], 4};
        covered += q[3] != 0 ? 1 : 0;
        differ += compare_bytes(p, q, 1).beyond > 0 ? 1 : 0;
    }
    EXPECT_GT(covered, 50U);
    EXPECT_LE(differ, 2U);
}

TEST_P(FillForms, HiddenAndMovedObjectsAreFollowed) {
    const LineSet lines = extract_lines(make_scene("house").mesh, {.separate_objects = true});
    ASSERT_GT(lines.objects.size(), 4U);
    renderer_.set_lines(lines);
    const Camera camera = scene_cameras("house", {301, 203}).front().camera;
    const auto expect_same = [&](const char* what) {
        SCOPED_TRACE(what);
        const Picture large = expected(renderer_, camera, FillMode::lambert, 2);
        const Picture shown =
            draw(renderer_, camera, options_of(FillMode::lambert, StageForm::compute, 2));
        EXPECT_LE(share_beyond(shown, large, 1), 1e-3);
        return shown;
    };
    const Picture all = expect_same("as it is");
    const std::vector<std::uint32_t> first{0, 1, 2, 3};
    renderer_.set_hidden(first);
    EXPECT_GT(share_beyond(expect_same("hidden"), all, 1), 1e-3);
    renderer_.set_hidden({});
    std::vector<glm::mat4> transforms(lines.objects.size(), glm::mat4{1});
    for (std::size_t i = 0; i < transforms.size(); i += 2)
        transforms[i] = glm::rotate(glm::mat4{1}, 0.1F, glm::vec3{1, 2, 3});
    renderer_.set_transforms(transforms);
    EXPECT_GT(share_beyond(expect_same("turned"), all, 1), 1e-3);
}

/// Of the pixels well within the picture of a ball of radius 1 how far the red of any is from what
/// light from the eye's direction makes of white.
double worst_of_ball(const Picture& shown, const Camera& camera) {
    double worst = 0;
    const glm::mat4 world_from_clip = glm::inverse(camera.clip_from_world());
    for (int y = 0; y < camera.size.y; ++y) {
        for (int x = 0; x < camera.size.x; ++x) {
            const glm::vec2 at = (glm::vec2{x, y} + 0.5F) / glm::vec2{camera.size} * 2.0F - 1.0F;
            const glm::vec4 near = world_from_clip * glm::vec4{at, -1, 1};
            const glm::vec2 place{near.x / near.w, near.y / near.w}; // the view is along z
            const float square = glm::dot(place, place);
            if (square > 0.8F) continue;
            const double light = std::sqrt(1 - double{square});
            const double expected = 255 * std::pow(light, 1 / 2.2);
            const std::size_t i = 4 * static_cast<std::size_t>(y * camera.size.x + x);
            worst = std::max(worst, std::abs(shown[i] - expected));
        }
    }
    return worst;
}

TEST_P(FillForms, ASmoothBallHasTheLightOfABall) {
    Camera camera;
    camera.size = {200, 200};
    camera.view = glm::translate(glm::mat4{1}, glm::vec3{0, 0, -5});
    camera.projection = glm::ortho(-1.1F, 1.1F, -1.1F, 1.1F, 1.0F, 20.0F);
    for (const StageForm form : {StageForm::raster, StageForm::compute}) {
        const auto drawn = [&] {
            FrameOptions options = options_of(FillMode::lambert, form, 1);
            options.style.fill.color = glm::vec3{1};
            options.style.fill.light = {0, 0, 1};
            options.style.fill.ambient = 0;
            return draw(renderer_, camera, options);
        };
        const Mesh ball = sphere(4);
        renderer_.set_lines(extract_lines(ball, {.silhouettes = Silhouettes::mesh}));
        EXPECT_GT(worst_of_ball(drawn(), camera), 8) << "flat triangles";
        const LineSet lines =
            extract_lines(ball, {.separate_objects = true, .silhouettes = Silhouettes::smooth});
        renderer_.set_lines(lines);
        EXPECT_LT(worst_of_ball(drawn(), camera), 2.5);
        renderer_.set_transforms(std::vector{glm::rotate(glm::mat4{1}, 0.7F, glm::vec3{1, 2, 3})});
        EXPECT_LT(worst_of_ball(drawn(), camera), 2.5) << "turned";
        std::vector<glm::vec3> other = lines.vertices;
        for (glm::vec3& vertex : other) vertex = {vertex.y, vertex.z, vertex.x};
        renderer_.set_positions(0, other);
        EXPECT_LT(worst_of_ball(drawn(), camera), 2.5) << "of another shape";
    }
}

TEST_P(FillForms, BothFormsLightSmoothSurfacesAlike) {
    Camera camera;
    camera.size = {301, 203};
    camera.view = glm::lookAt(glm::vec3{3, 2, 4}, glm::vec3{0}, glm::vec3{0, 1, 0});
    camera.projection = glm::perspective(0.45F, 301.0F / 203.0F, 1.0F, 20.0F);
    renderer_.set_lines(
        extract_lines(moved(sphere(3), glm::scale(glm::mat4{1}, glm::vec3{1, 0.7F, 0.9F})),
                      {.silhouettes = Silhouettes::smooth}));
    for (const FillMode mode : {FillMode::lambert, FillMode::toon}) {
        const Picture large = expected(renderer_, camera, mode, 2);
        const Picture shown = draw(renderer_, camera, options_of(mode, StageForm::compute, 2));
        EXPECT_GT(filled(shown), 5000U);
        EXPECT_LE(share_beyond(shown, large, 1), 1e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(Devices, FillForms, testing::Values("opencl", "cpp"),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace lineatlas::test
