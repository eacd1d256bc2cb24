// The costs of a frame on a card with its own memory: launches, bytes over the bus and waits.

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <utility>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "compute/opencl/devices.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/renderer.hpp"
#include "scene_cameras.hpp"
#include "support/discrete_layer/discrete_layer.hpp"

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

TEST_F(Discrete, TheExactMethodHandsOverItsRunsAlone) {
    FrameOptions options;
    options.method = Method::exact;
    const auto [stats, counts] = draw(options);
    constexpr std::uint64_t beside = 4096; // numbers that the host reads
    EXPECT_GT(counts.launches, 10U);
    EXPECT_GE(counts.bytes, stats.runs * sizeof(lineatlas::Run));
    EXPECT_LE(counts.bytes, stats.runs * sizeof(lineatlas::Run) + beside);
}

} // namespace
} // namespace lineatlas::test
