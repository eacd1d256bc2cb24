// Whole frames by counting kernels have the same picture as on every other device.

#include <set>

#include <gtest/gtest.h>

#include "devices.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/kernel_profile.hpp"
#include "lineatlas/renderer.hpp"
#include "planted_error.hpp"
#include "scene_cameras.hpp"

namespace lineatlas::test {
namespace {

TEST(CountingFrames, AreThoseOfCppAndCountEveryKernel) {
    register_counting_device();
    register_counting_device(); // a second call does nothing
    const gl::HeadlessContext context;
    gl::Canvas canvas{{300, 200}};
    const Camera camera = scene_cameras("clevis", canvas.size())[0].camera;
    for (const Method method : {Method::exact, Method::atlas}) {
        Renderer renderer{{.compute = "cpp"}};
        renderer.set_lines(scene_lines("clevis"));
        FrameOptions options{
            .method = method,
            .forms = {.atlas = StageForm::compute,
                      .depth = StageForm::compute,
                      .strokes = StageForm::compute},
            .style = {.filter = {.fill_holes = 4, .halo = 3}, .density = {.limit = 0.1F}}};
        const auto draw = [&] {
            canvas.clear(glm::vec4{1});
            renderer.draw(camera, options, canvas.framebuffer());
            return canvas.read();
        };
        const std::vector<std::uint8_t> expected = draw();
        options.profile = true;
        draw();
        std::set<std::string> launched;
        for (const FrameProfile& frame : renderer.take_profiles())
            for (const ProfileEvent& event : frame.events)
                if (event.items > 0) launched.insert(event.name);
        options.profile = false;
        renderer.set_device({.compute = "counting"});
        EXPECT_EQ(draw(), expected);
        take_launch_counts();
        EXPECT_EQ(draw(), expected);
        std::set<std::string> counted, computing;
        for (const LaunchCounts& launch : take_launch_counts()) {
            EXPECT_GT(launch.bytes, 0U) << launch.kernel;
            counted.insert(launch.kernel);
            if (launch.operations > 0) computing.insert(launch.kernel);
        }
        for (const std::string& kernel : launched) EXPECT_TRUE(counted.contains(kernel)) << kernel;
        for (const char* kernel : {"project_clip", "halo_cut", "strokes_tiles"})
            EXPECT_TRUE(computing.contains(kernel)) << kernel;
        EXPECT_FALSE(computing.contains("scan_chunks_reduce")); // it computes with integers alone
    }
}

/// The forms of a GPU count too, where a device launches them. Scans stay in chunks.
TEST(CountingFrames, CountTheFormsOfADevice) {
    register_counting_device();
    compute::register_device({"as gpu", "", [](std::string_view) { return cpp_as_gpu().make(); }});
    const PlantedError gpu{"tuning.toml", "type = \"cpu\"", "type = \"other\""};
    const gl::HeadlessContext context;
    gl::Canvas canvas{{300, 200}};
    const Camera camera = scene_cameras("clevis", canvas.size())[0].camera;
    for (const Method method : {Method::exact, Method::atlas}) {
        Renderer renderer{{.compute = "as gpu"}};
        renderer.set_lines(scene_lines("clevis"));
        const FrameOptions options{.method = method,
                                   .forms = {.atlas = StageForm::compute,
                                             .depth = StageForm::compute,
                                             .strokes = StageForm::compute}};
        const auto draw = [&] {
            canvas.clear(glm::vec4{1});
            renderer.draw(camera, options, canvas.framebuffer());
            return canvas.read();
        };
        const std::vector<std::uint8_t> expected = draw();
        renderer.set_device({.compute = "counting", .device = "opencl"});
        take_launch_counts();
        EXPECT_EQ(draw(), expected);
        std::set<std::string> counted;
        for (const LaunchCounts& launch : take_launch_counts()) counted.insert(launch.kernel);
        for (const char* kernel : {"strokes_pixels", "strokes_boxes", "scan_chunks_reduce",
                                   method == Method::exact ? "visible_cut" : "depth_small"})
            EXPECT_TRUE(counted.contains(kernel)) << kernel;
        EXPECT_FALSE(counted.contains("strokes_tiles"));
    }
}

} // namespace
} // namespace lineatlas::test
