// Kinds of device by name, a device from outside the library, the comparison of two devices, and a
// change of the device between frames.

#include "compare.hpp"
#include "compute/opencl/devices.hpp"
#include "devices.hpp"
#include "examples/device/threads_device.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "planted_error.hpp"
#include "scene_cameras.hpp"
#include "stages.hpp"

namespace lineatlas::test {
namespace {

/// Registers the device of threads, once per process.
void know_threads() {
    static const bool done = (register_threads_device(), true);
    EXPECT_TRUE(done);
}

template <class Action>
std::string message_of(Action&& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing was thrown";
}

void expect_words(const std::string& message, std::initializer_list<const char*> words) {
    for (const char* word : words) {
        EXPECT_NE(message.find(word), std::string::npos) << word << " is not in: " << message;
    }
}

TEST(Backends, UnknownNamesAreRefusedWithTheList) {
    expect_words(message_of([] { compute::make_device("cuda"); }), {"\"cuda\"", "opencl", "cpp"});
}

TEST(Backends, ANameIsTakenOnlyOnce) {
    know_threads();
    EXPECT_THROW(register_threads_device(), UsageError);
    expect_words(compute::device_kind_names(), {"opencl, cpp, threads"});
}

TEST(Backends, TheExampleEqualsCppInItsStages) {
    know_threads();
    const LineSet& lines = scene_lines("house");
    const Camera camera = scene_cameras("house")[0].camera;
    FrameState expected, seen;
    for (const auto& [name, state] : {std::pair{"cpp", &expected}, {"threads", &seen}}) {
        FrameStages stages{compute::make_device(name), lines};
        stages.pyramid(camera, std::vector<float>(320 * 240 * 4, 1.0F), *state);
        stages.project(camera, false, *state);
    }
    EXPECT_TRUE(equal(expected.front, seen.front));
    EXPECT_TRUE(equal(expected.counts, seen.counts));
    EXPECT_NE(std::count(seen.front.begin(), seen.front.end(), 1), 0);
}

TEST(Backends, KernelsWithBarriersAreRefusedOnTheHost) {
    const auto tiles =
        std::ranges::find(compute::all_kernels(), true, &compute::Kernel::has_barriers);
    ASSERT_NE(tiles, compute::all_kernels().end());
    expect_words(message_of([&] { compute::run_on_host(*tiles, {}, {}, 0, 1, 1); }),
                 {"scan_tiles", "barriers", "Tuning::scan_tiles"});
}

/// Frames of several renderers, or of one on several devices.
class OnScenes : public testing::Test {
  protected:
    std::vector<std::uint8_t> draw(Renderer& renderer, const std::string& scene,
                                   const FrameOptions& options = {
                                       .forms = {.atlas = StageForm::compute}}) {
        canvas_.clear(glm::vec4{1});
        const Camera camera = scene_cameras(scene, canvas_.size())[0].camera;
        EXPECT_GT(renderer.draw(camera, options, canvas_.framebuffer()).runs, 0U);
        return canvas_.read();
    }
    std::vector<std::uint8_t> draw_with(const DeviceOptions& device, const std::string& scene) {
        Renderer renderer{device};
        renderer.set_lines(scene_lines(scene));
        return draw(renderer, scene);
    }

    static void expect_same(const std::vector<std::uint8_t>& a,
                            const std::vector<std::uint8_t>& b) {
        const ByteDifference difference = compare_bytes(a, b);
        EXPECT_LE(difference.share(), 0.001) << "largest " << difference.largest;
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{400, 300}};
};

TEST_F(OnScenes, TheExampleDrawsThePictureOfCpp) {
    know_threads();
    EXPECT_TRUE(equal(draw_with({.compute = "cpp"}, "clevis"),
                      draw_with({.compute = "threads", .compare_with = "cpp"}, "clevis")));
}

TEST_F(OnScenes, EveryStageOfAStyleIsComparedAndEqual) {
    Renderer renderer{{.compare_with = "cpp"}};
    const FrameOptions options{
        .forms = {.atlas = StageForm::compute},
        .style = {.filter = {.fill_holes = 4, .drop_runs = 4, .overshoot = 8, .halo = 3},
                  .density = {.limit = 0.1F}},
        .intervals = KeptIntervals::visible};
    for (const char* scene : {"clevis", "house", "ship", "office"}) {
        renderer.set_lines(scene_lines(scene));
        const Renderer::Comparison before = renderer.comparison();
        EXPECT_NO_THROW(draw(renderer, scene, options)) << scene;
        // pyramid only for large models; scan twice, of two kernels each
        EXPECT_GE(renderer.comparison().kernels - before.kernels, 9U);
        EXPECT_GT(renderer.comparison().elements, before.elements);
    }
}

TEST_F(OnScenes, TheFirstStageThatDiffersIsReported) {
    const PlantedError error{"shared/run.h", "xy(c) / c.w + 1.0f", "xy(c) / c.w + 1.01f"};
    const std::string message = message_of([&] { draw_with({.compare_with = "cpp"}, "clevis"); });
    expect_words(message, {"stage compact differs", "runs, element 0", "Run::start[0]", "(cpp"});
    // No stage before this one differs.
    EXPECT_NO_THROW(draw_with({.compare_with = "cpp", .compare_until = "atlas"}, "clevis"));
}

TEST_F(OnScenes, OneIntegerThatDiffersIsReported) {
    const PlantedError error{"facing.cl", "? 1 : 0", "? 1 : i == 11 ? 2 : 0"};
    const std::string message = message_of([&] {
        Renderer renderer{{.compare_with = "cpp"}};
        renderer.set_lines(scene_lines("clevis"));
        for (const auto& view : scene_cameras("clevis", canvas_.size())) {
            renderer.draw(view.camera, {}, canvas_.framebuffer());
        }
    });
    expect_words(message, {"stage facing differs", "front, element 11: 2 (", ", 0 (cpp"});
}

TEST_F(OnScenes, ComparisonsThatMakeNoSenseAreRefused) {
    EXPECT_THROW(Renderer({.compare_with = "cuda"}), UsageError);
    EXPECT_THROW(Renderer({.compare_with = "cpp", .compare_until = "hatching"}), UsageError);
    EXPECT_THROW(Renderer({.interop = "gl-sharing", .compare_with = "cpp"}), UsageError);
}

TEST_F(OnScenes, TheDeviceMayChangeBetweenFrames) {
    Renderer renderer;
    renderer.set_lines(scene_lines("ship")); // large enough for clusters
    const FrameOptions options{.forms = {.atlas = StageForm::compute},
                               .style = {.pen = {.mark = "a/b.png", .width = 4}}};
    renderer.set_pen_image("a/b.png", {.size = {2, 1}, .pixels = {255, 255, 255, 0, 0, 0, 0, 255}});
    const std::string name = renderer.description();
    const auto first = draw(renderer, "ship", options);
    for (const DeviceOptions& device : {DeviceOptions{.compute = "cpp"},
                                        {.compute = "cpp", .interop = "host-pointer"},
                                        {.interop = "copy"}}) {
        renderer.set_device(device);
        // The samples are of a frame on the old device.
        EXPECT_THROW(renderer.read_samples(), UsageError);
        expect_same(first, draw(renderer, "ship", options));
    }
    renderer.set_device({});
    EXPECT_EQ(renderer.description(), name);
    EXPECT_TRUE(equal(first, draw(renderer, "ship", options)));
    // Other methods read the lines back from the device.
    const Camera camera = scene_cameras("ship", canvas_.size())[0].camera;
    EXPECT_NO_THROW(renderer.draw(camera, {.method = Method::spine}, canvas_.framebuffer()));
}

TEST_F(OnScenes, AChangeThatFailsChangesNothing) {
    Renderer renderer;
    EXPECT_NO_THROW(renderer.set_device({.compute = "cpp"})); // without lines too
    renderer.set_device({});
    renderer.set_lines(scene_lines("clevis"));
    const std::string name = renderer.description();
    const auto first = draw(renderer, "clevis");
    for (const DeviceOptions& device : {DeviceOptions{.compute = "cuda"},
                                        {.device = "opencl:no such platform"},
                                        {.interop = "telepathy"},
                                        {.compare_with = "cuda"}}) {
        EXPECT_THROW(renderer.set_device(device), UsageError);
        EXPECT_EQ(renderer.description(), name);
        EXPECT_FALSE(renderer.read_samples().alpha.empty()); // still of the last frame
        EXPECT_TRUE(equal(first, draw(renderer, "clevis")));
    }
}

/// Pictures of an OpenCL device compared with those of cpp.
class DevicePictures : public OnScenes, public testing::WithParamInterface<TestDevice> {};

TEST_P(DevicePictures, EqualThoseOfCpp) {
    const std::string device = compute::list_opencl_devices()[GetParam().index].name();
    Renderer renderer{{.device = device, .interop = "copy"}};
    Renderer cpp{{.compute = "cpp"}};
    for (const char* scene : {"clevis", "house", "ship", "office"}) {
        SCOPED_TRACE(scene);
        renderer.set_lines(scene_lines(scene));
        cpp.set_lines(scene_lines(scene));
        expect_same(draw(cpp, scene), draw(renderer, scene));
    }
    renderer.set_device({.compute = "cpp"});
    renderer.set_device({.device = device, .interop = "copy"});
    expect_same(draw(cpp, "office"), draw(renderer, "office"));
}

TEST_F(OnScenes, OfDepthByGlProbesKnowTheSurfacesOfEachFrame) {
    const FrameOptions options{.forms = {.atlas = StageForm::compute, .depth = StageForm::raster}};
    for (const char* mode : {"copy", "host-pointer"}) {
        SCOPED_TRACE(mode);
        Renderer renderer{{.compute = "cpp", .interop = mode}};
        const auto drawn_after = [&](const char* before) {
            renderer.set_lines(scene_lines(before));
            draw(renderer, before, options);
            renderer.set_lines(scene_lines("house"));
            return draw(renderer, "house", options);
        };
        EXPECT_TRUE(equal(drawn_after("house"), drawn_after("clevis")));
    }
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(DevicePictures);
INSTANTIATE_TEST_SUITE_P(OnDevice, DevicePictures, testing::ValuesIn(own_opencl_devices()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace lineatlas::test
