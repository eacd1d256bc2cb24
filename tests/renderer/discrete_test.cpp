// The costs of a frame on a card with its own memory: launches, bytes over the bus and waits.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <tuple>
#include <utility>

#include <dlfcn.h>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "compute/opencl/devices.hpp"
#include "environment_variable.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/handover_rates.hpp"
#include "glpasses/objects.hpp"
#include "lineatlas/mesh.hpp"
#include "lineatlas/renderer.hpp"
#include "scene_cameras.hpp"
#include "support/discrete_layer/discrete_layer.hpp"
#include "support/fault_layer/fault_layer.hpp"
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

OpenClFaults& opencl_faults() {
    void* layer = dlopen(LINEATLAS_FAULT_LAYER, RTLD_NOW);
    if (layer == nullptr) throw std::runtime_error{dlerror()};
    return *reinterpret_cast<GetOpenClFaults*>(dlsym(layer, opencl_faults_symbol))();
}

class Discrete : public testing::Test {
  protected:
    Discrete() {
        ::setenv("OPENCL_LAYERS", LINEATLAS_DISCRETE_LAYER ":" LINEATLAS_FAULT_LAYER, 1);
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
    EXPECT_EQ(counts.waits, 1U) << "for the strokes, and whatever tables were too small for";
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
    EXPECT_EQ(counts.waits, 1U);
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

/// A bumpy sheet. From above it has no silhouettes, from aside thousands.
Mesh bumps() {
    constexpr std::uint32_t side = 120;
    Mesh mesh;
    for (std::uint32_t y = 0; y <= side; ++y) {
        for (std::uint32_t x = 0; x <= side; ++x) {
            const glm::vec2 at{x, y};
            mesh.positions.emplace_back(at, 0.4F * std::sin(0.9F * at.x) * std::sin(0.7F * at.y));
        }
    }
    for (std::uint32_t y = 0; y < side; ++y) {
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint32_t i = y * (side + 1) + x, up = i + side + 1;
            mesh.triangles.insert(mesh.triangles.end(), {{i, i + 1, up + 1}, {i, up + 1, up}});
        }
    }
    return mesh;
}

/// A look at the middle of the sheet from a direction.
Camera look_from(glm::vec3 direction, glm::ivec2 size) {
    constexpr glm::vec3 middle{60, 60, 0};
    const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
    Camera camera;
    camera.view = glm::lookAt(middle + 150.0F * direction, middle, {0, 1, 0});
    camera.projection = glm::perspective(0.9F, aspect, 1.0F, 1000.0F);
    camera.size = size;
    return camera;
}

class Guessed : public Discrete,
                public testing::WithParamInterface<std::tuple<Method, Silhouettes>> {
  protected:
    std::vector<std::uint8_t> picture(Renderer& renderer, const Camera& camera) {
        FrameOptions options;
        options.method = std::get<0>(GetParam());
        options.forms.strokes = StageForm::compute;
        options.steady = false;
        canvas_.clear({1, 1, 1, 1});
        renderer.draw(camera, options, canvas_.framebuffer());
        return canvas_.read();
    }
};
INSTANTIATE_TEST_SUITE_P(ByEdgesAndSmooth, Guessed,
                         testing::Combine(testing::Values(Method::atlas, Method::exact),
                                          testing::Values(Silhouettes::mesh, Silhouettes::smooth)));

TEST_P(Guessed, FramesAreThoseThatWaitForTheNumberOfTheirSilhouettes) {
    const LineSet lines = extract_lines(
        bumps(), {.lines = mask_of(LineKind::silhouette), .silhouettes = std::get<1>(GetParam())});
    const glm::vec3 above{0, 0, 1}, aside = glm::normalize(glm::vec3{0.3F, -1, 0.15F});
    Renderer guesses{{.compute = "opencl"}};
    guesses.set_lines(lines);
    std::size_t ink = 0;
    for (const glm::vec3& direction : {above, aside, glm::vec3{aside.y, aside.x, aside.z}, above,
                                       glm::vec3{-aside.x, -aside.y, aside.z}}) {
        const Camera camera = look_from(direction, canvas_.size());
        Renderer waits{{.compute = "opencl"}};
        waits.set_lines(lines);
        const std::vector<std::uint8_t> expected = picture(waits, camera);
        ink += std::ranges::count(expected, 0);
        EXPECT_TRUE(picture(guesses, camera) == expected) << direction.x << ' ' << direction.z;
    }
    EXPECT_GT(ink, 1000U);
}

/// Ridges side by side. All show their backs, and so their silhouettes, below one angle.
Mesh ridges() {
    constexpr std::uint32_t columns = 40, rows = 120;
    Mesh mesh;
    for (std::uint32_t y = 0; y <= rows; ++y)
        for (std::uint32_t x = 0; x <= columns; ++x)
            mesh.positions.emplace_back(3.0F * static_cast<float>(x), y, x % 2 != 0 ? 0.45F : 0);
    for (std::uint32_t y = 0; y < rows; ++y) {
        for (std::uint32_t x = 0; x < columns; ++x) {
            const std::uint32_t i = y * (columns + 1) + x, up = i + columns + 1;
            mesh.triangles.insert(mesh.triangles.end(), {{i, i + 1, up + 1}, {i, up + 1, up}});
        }
    }
    return mesh;
}

/// In slow motion, with dashes that are carried over.
TEST_F(Discrete, SteadyFramesAreThoseThatWaitForTheNumberOfTheirSilhouettes) {
    const LineSet lines = extract_lines(
        ridges(), {.lines = mask_of(LineKind::silhouette) | mask_of(LineKind::boundary)});
    FrameOptions options;
    options.method = Method::atlas;
    options.forms.strokes = StageForm::compute;
    options.style.pen.mark = "dashed";
    FrameOptions waiting = options;
    waiting.intervals = KeptIntervals::visible;
    Renderer guesses{{.compute = "opencl"}}, waits{{.compute = "opencl"}};
    guesses.set_lines(lines);
    waits.set_lines(lines);
    const auto picture = [&](Renderer& renderer, const Camera& camera, const FrameOptions& as) {
        canvas_.clear({1, 1, 1, 1});
        renderer.draw(camera, as, canvas_.framebuffer());
        return canvas_.read();
    };
    std::vector<std::uint32_t> wait_counts;
    for (const float degrees : {80.4F, 80.6F, 80.8F, 81.0F, 81.2F, 81.6F, 81.8F, 82.0F, 82.2F}) {
        const float angle = glm::radians(degrees);
        Camera camera = look_from({std::sin(angle), 0, std::cos(angle)}, canvas_.size());
        camera.projection = glm::ortho(-20.0F, 20.0F, -15.0F, 15.0F, 1.0F, 1000.0F);
        const std::vector<std::uint8_t> expected = picture(waits, camera, waiting);
        take_counts();
        EXPECT_TRUE(picture(guesses, camera, options) == expected) << degrees;
        wait_counts.push_back(take_counts().waits);
    }
    const auto redone = std::ranges::find_if(wait_counts.begin() + 3, wait_counts.end(),
                                             [](std::uint32_t waits) { return waits > 1; });
    ASSERT_LT(redone - wait_counts.begin(), 7) << "no frame had more silhouettes than guessed";
    EXPECT_EQ(redone[1], 1U) << "the frame after it";
}

TEST_F(Discrete, TheSecondFrameNeedsNoMoreMemoryThanTheFirst) {
    OpenClFaults& faults = opencl_faults();
    faults.builds_once = true;
    const LineSet lines = extract_lines(bumps(), {.lines = mask_of(LineKind::silhouette)});
    const Camera camera = look_from(glm::normalize(glm::vec3{0.3F, -1, 0.15F}), canvas_.size());
    FrameOptions options;
    options.method = Method::atlas;
    options.forms.strokes = StageForm::compute;
    const auto draw_twice = [&](int& first, int& second) {
        Renderer renderer{{.compute = "opencl"}};
        renderer.set_lines(lines);
        renderer.draw(camera, options, canvas_.framebuffer());
        ++first;
        const std::uint64_t allocated = faults.allocated;
        renderer.draw(camera, options, canvas_.framebuffer());
        ++second;
        return allocated;
    };
    int first = 0, second = 0, refused = 0;
    const std::uint64_t needed = draw_twice(first, second);
    for (std::uint64_t part = 60; part < 80; ++part) {
        faults.memory = needed * part / 64;
        try {
            draw_twice(first, second);
        } catch (const DeviceError&) {
            ++refused;
        }
    }
    faults.reset();
    EXPECT_EQ(first, second);
    EXPECT_GT(first, 2);
    EXPECT_GT(refused, 2);
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
    {
        const EnvironmentVariable nowhere{"XDG_CACHE_HOME", "/dev/null"};
        EXPECT_FALSE(rates().measured) << "where nothing can be kept";
        EXPECT_EQ(take_counts().copies, 0U);
    }
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

TEST_F(Discrete, AFrameByTheExactMethodHandsOverItsPictureAlone) {
    FrameOptions options;
    options.method = Method::exact;
    options.forms.strokes = StageForm::compute;
    const BusCounts counts = draw(options).counts;
    EXPECT_LE(counts.launches, 60U);
    // Three for how much lies in lists of tiles, and how many spans there are. Two for the pieces
    // of lines in tiles and their parts. One for the strokes.
    EXPECT_LE(counts.waits, 6U);
    EXPECT_LE(counts.bytes, 1U << 20U);
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
