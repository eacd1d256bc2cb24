// The costs of a frame on a card with its own memory: launches, bytes over the bus and waits.

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <utility>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "compute/opencl/devices.hpp"
#include "environment_variable.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/handover_rates.hpp"
#include "glpasses/objects.hpp"
#include "lineatlas/renderer.hpp"
#include "scene_cameras.hpp"
#include "support/discrete_layer/discrete_layer.hpp"
#include "temporary_folder.hpp"

namespace lineatlas::test {
namespace {

BusCounts take_counts() {
    void* layer = dlopen(LINEATLAS_DISCRETE_LAYER, RTLD_LAZY | RTLD_NOLOAD);
    if (layer == nullptr) throw std::runtime_error{"the OpenCL loader has not taken the layer"};
    const auto take = reinterpret_cast<TakeBusCounts*>(dlsym(layer, take_bus_counts_symbol));
    dlclose(layer);
    return take();
}

class Discrete : public testing::Test {
  protected:
    Discrete() {
        ::setenv("OPENCL_LAYERS", LINEATLAS_DISCRETE_LAYER, 1);
        ::setenv("LINEATLAS_CACHE", "off", 1); // no trial of the device comes first
    }

    struct Frame {
        FrameStats stats;
        BusCounts counts;
    };
    /// Draws a frame like those before it.
    Frame draw(const FrameOptions& options) {
        Renderer renderer{{.compute = "opencl"}};
        renderer.set_lines(scene_lines("ship"));
        const Camera camera = scene_cameras("ship", canvas_.size()).front().camera;
        for (int i = 0; i < 3; ++i) renderer.draw(camera, options, canvas_.framebuffer());
        take_counts();
        FrameStats stats = renderer.draw(camera, options, canvas_.framebuffer());
        EXPECT_GT(stats.runs, 1000U);
        const BusCounts counts = take_counts();
        std::cout << counts.launches << " launches, " << counts.copies << " copies of "
                  << counts.bytes << " bytes, " << counts.waits << " waits\n";
        return {std::move(stats), counts};
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{640, 480}};
};

TEST_F(Discrete, TheDeviceIsAGpuThatSharesNoMemory) {
    const compute::OpenClDevice device = compute::list_opencl_devices().at(0);
    EXPECT_TRUE(device.is_gpu);
    EXPECT_FALSE(device.is_cpu);
    EXPECT_THROW(Renderer({.compute = "opencl", .interop = "host-pointer"}), DeviceError);
}

TEST_F(Discrete, AFrameByKernelsHandsOverItsPictureAlone) {
    FrameOptions options;
    options.method = Method::atlas;
    options.forms = {
        .atlas = StageForm::compute, .depth = StageForm::compute, .strokes = StageForm::compute};
    const BusCounts counts = draw(options).counts;
    EXPECT_GT(counts.launches, 10U);
    EXPECT_LE(counts.launches, 60U);
    // The number of silhouettes sizes the tables and launches that follow. The number of runs in
    // tiles says whether tables are too small; if they are, stages run again before anything is
    // drawn. The last wait is for the strokes.
    EXPECT_LE(counts.waits, 3U);
    EXPECT_GT(counts.bytes, 100'000U) << "strokes cross";
    EXPECT_LE(counts.bytes, 1U << 20U);
}

TEST_F(Discrete, AFrameByDefaultIsOneByKernels) {
    FrameOptions options;
    options.method = Method::atlas;
    const BusCounts counts = draw(options).counts;
    EXPECT_GT(counts.bytes, 100'000U) << "strokes cross";
    EXPECT_LE(counts.bytes, 1U << 20U) << "neither depth nor samples do";
    EXPECT_LE(counts.launches, 60U);
    EXPECT_LE(counts.waits, 3U);
}

TEST_F(Discrete, AProgramsOwnDepthCrossesOnce) {
    FrameOptions options;
    options.method = Method::atlas;
    const gl::Texture2D depth = gl::Texture2D::create();
    glTextureStorage2D(depth.id(), 1, GL_DEPTH_COMPONENT32F, canvas_.size().x, canvas_.size().y);
    const float far = 1;
    glClearTexImage(depth.id(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, &far);
    options.own_depth = DepthTexture{.texture = depth.id()};
    const BusCounts counts = draw(options).counts;
    const auto pixels =
        static_cast<std::uint64_t>(canvas_.size().x) * static_cast<std::uint64_t>(canvas_.size().y);
    constexpr std::uint64_t beside = 64 << 10; // numbers that the host reads, and marks of tiles
    EXPECT_GT(counts.bytes, pixels * sizeof(float));
    EXPECT_LE(counts.bytes, pixels * (sizeof(float) + 1) + beside) << "and a layer of strokes";
}

TEST_F(Discrete, EveryKernelFindsWhatCppFinds) {
    Renderer renderer{{.compute = "opencl", .compare_with = "cpp"}};
    renderer.set_lines(scene_lines("ship"));
    for (const Method method : {Method::atlas, Method::exact}) {
        FrameOptions options;
        options.method = method;
        options.forms = {.atlas = StageForm::compute,
                         .depth = StageForm::compute,
                         .strokes = StageForm::compute};
        options.style.fill.mode = FillMode::flat;
        for (const NamedCamera& view : scene_cameras("ship", canvas_.size())) {
            EXPECT_NO_THROW(renderer.draw(view.camera, options, canvas_.framebuffer()))
                << view.name;
        }
    }
}

TEST_F(Discrete, RatesAreMeasuredOnceAndKept) {
    const TemporaryFolder cache;
    const EnvironmentVariable home{"XDG_CACHE_HOME", cache.path().string()};
    const auto rates = [] {
        interop::Connection connection = interop::connect({.compute = "opencl"});
        take_counts();
        return interop::handover_rates(*connection.sharing);
    };
    EXPECT_FALSE(rates().measured) << "with LINEATLAS_CACHE=off";
    EXPECT_EQ(take_counts().copies, 0U);
    const EnvironmentVariable on{"LINEATLAS_CACHE", "on"};
    const interop::HandoverRates found = rates();
    EXPECT_TRUE(found.measured);
    EXPECT_GT(take_counts().copies, 10U);
    // The layer takes at least 10 us and 4 GB/s. Rates are rounded to powers of two.
    for (const interop::HandoverRate& rate : {found.to_compute, found.to_gl}) {
        EXPECT_GE(rate.milliseconds, 1.0 / 64);
        EXPECT_LE(rate.bytes_per_millisecond, 1 << 24);
    }
    const interop::HandoverRates again = rates();
    EXPECT_TRUE(again.measured);
    EXPECT_EQ(take_counts().copies, 0U);
    EXPECT_EQ(again.to_compute.milliseconds, found.to_compute.milliseconds);
    EXPECT_EQ(again.to_gl.bytes_per_millisecond, found.to_gl.bytes_per_millisecond);
}

TEST_F(Discrete, TheExactMethodHandsOverItsRunsAlone) {
    FrameOptions options;
    options.method = Method::exact;
    options.forms.strokes = StageForm::raster;
    const auto [stats, counts] = draw(options);
    constexpr std::uint64_t beside = 4096; // numbers that the host reads
    EXPECT_GT(counts.launches, 10U);
    EXPECT_GE(counts.bytes, stats.runs * sizeof(lineatlas::Run));
    EXPECT_LE(counts.bytes, stats.runs * sizeof(lineatlas::Run) + beside);
}

} // namespace
} // namespace lineatlas::test
    {
        const EnvironmentVariable nowhere{"XDG_CACHE_HOME", "/dev/null"};
        EXPECT_FALSE(rates().measured) << "where nothing can be kept";
        EXPECT_EQ(take_counts().copies, 0U);
    }
