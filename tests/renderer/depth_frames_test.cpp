// `depth` does not clear parts that were blank in the frame before. After any frame the picture is
// that of a new renderer.

#include <functional>
#include <tuple>

#include <gtest/gtest.h>

#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/renderer.hpp"
#include "scene_cameras.hpp"

namespace lineatlas::test {
namespace {

using Picture = std::vector<std::uint8_t>;

/// A frame, and changes of the renderer before it.
struct Step {
    const char* name;
    std::string scene;
    int view;
    glm::ivec2 size;
    std::function<void(FrameOptions&)> change = [](FrameOptions&) {};
};

/// The fill shows the number of every texel, lines show depth.
FrameOptions options_of(const Step& step) {
    FrameOptions options{.forms = {.depth = StageForm::compute}, .steady = false};
    options.style.fill.mode = FillMode::lambert;
    step.change(options);
    return options;
}

Picture draw(Renderer& renderer, const Step& step) {
    const Camera camera =
        scene_cameras(step.scene, step.size).at(static_cast<std::size_t>(step.view)).camera;
    gl::Canvas canvas{camera.size};
    canvas.clear(glm::vec4{0});
    renderer.draw(camera, options_of(step), canvas.framebuffer());
    return canvas.read();
}

class DepthFrames : public testing::TestWithParam<std::tuple<std::string, std::string>> {
  protected:
    DeviceOptions device() const {
        return {.compute = std::get<0>(GetParam()), .interop = std::get<1>(GetParam())};
    }
    void expect_each_as_alone(const std::vector<Step>& steps) {
        Renderer all{device()};
        const char* before = "the first";
        std::string scene;
        for (const Step& step : steps) {
            SCOPED_TRACE(std::string{step.name} + " after " + before);
            if (scene != step.scene) all.set_lines(scene_lines(step.scene));
            scene = step.scene;
            Renderer alone{device()};
            alone.set_lines(scene_lines(step.scene));
            EXPECT_TRUE(draw(all, step) == draw(alone, step));
            before = step.name;
        }
    }

  private:
    gl::HeadlessContext context_;
};

constexpr glm::ivec2 usual{301, 203};

TEST_P(DepthFrames, AreWhatTheyAreAloneWhateverWasDrawnBefore) {
    const auto raster = [](FrameOptions& options) { options.forms.depth = StageForm::raster; };
    const auto scale = [](int scale) {
        return [scale](FrameOptions& options) { options.depth_scale = scale; };
    };
    const auto method = [](Method method) {
        return [method](FrameOptions& options) { options.method = method; };
    };
    const auto raster_atlas = [](FrameOptions& options) {
        options.forms.atlas = StageForm::raster;
    };
    expect_each_as_alone({{"a view", "clevis", 0, usual},
                          {"another view", "clevis", 1, usual},
                          {"a view from inside", "clevis", 2, usual},
                          {"the first view", "clevis", 0, usual},
                          {"a larger picture", "clevis", 1, {340, 260}},
                          {"as many texels in fewer pixels", "clevis", 0, {170, 130}, scale(4)},
                          {"a smaller picture", "clevis", 1, usual},
                          {"one texel a pixel", "clevis", 0, usual, scale(1)},
                          {"two", "clevis", 1, usual},
                          {"depth by GL", "clevis", 2, usual, raster},
                          {"depth by kernels", "clevis", 0, usual},
                          {"a large picture by GL", "clevis", 1, {500, 400}, raster},
                          {"a small one by kernels", "clevis", 0, usual},
                          {"a texture for the atlas", "clevis", 1, usual, raster_atlas},
                          {"spine", "clevis", 0, usual, method(Method::spine)},
                          {"exact", "clevis", 1, usual, method(Method::exact)},
                          {"exact again", "clevis", 0, usual, method(Method::exact)},
                          {"an item buffer", "clevis", 2, usual, method(Method::item_buffer)},
                          {"atlas", "clevis", 1, usual},
                          {"another model", "house", 0, usual},
                          {"the first model", "clevis", 0, usual}});
}

INSTANTIATE_TEST_SUITE_P(Devices, DepthFrames,
                         testing::Combine(testing::Values("opencl", "cpp"),
                                          testing::Values("", "copy")),
                         [](const auto& info) {
                             return std::get<0>(info.param) + std::get<1>(info.param);
                         });

} // namespace
} // namespace lineatlas::test
