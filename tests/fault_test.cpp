// What happens where a driver fails: every creation and every command of a frame, in turn.
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "fault_layer/fault_layer.hpp"
#include "gl_faults.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"

namespace lineatlas::test {
namespace {

using Picture = std::vector<std::uint8_t>;
constexpr glm::ivec2 size{160, 120};

/// The faults of the layer, which the loader must have loaded: before the first OpenCL call.
OpenClFaults& opencl_faults() {
    static OpenClFaults* faults = [] {
        setenv("OPENCL_LAYERS", LINEATLAS_FAULT_LAYER, 1);
        void* layer = dlopen(LINEATLAS_FAULT_LAYER, RTLD_NOW);
        if (layer == nullptr) throw std::runtime_error(dlerror());
        return reinterpret_cast<GetOpenClFaults*>(dlsym(layer, opencl_faults_symbol))();
    }();
    return *faults;
}

/// Everything that a frame can have, so that every stage and table is made.
FrameOptions all_effects(Method method) {
    FrameOptions options{.method = method};
    if (method != Method::atlas) return options;
    options.intervals = KeptIntervals::all;
    options.style.pen.mark = "pencil";
    options.style.hidden = true;
    options.style.filter.overshoot = 6;
    options.style.filter.halo = 3;
    options.style.density.limit = 0.2F;
    options.style.fill.mode = FillMode::lambert;
    options.style.paper.grain = 0.5F;
    return options;
}

class Fault : public testing::TestWithParam<std::string> {
  protected:
    Fault() {
        opencl_faults() = {.references = opencl_faults().references};
        static const bool hooked = (hook_gl(), true);
        EXPECT_TRUE(hooked);
        gl_faults() = {.live = gl_faults().live};
        canvas_ = std::make_unique<gl::Canvas>(size);
        const Scene scene = make_scene("clevis");
        lines_ = extract_lines(scene.mesh);
        camera_ = make_camera(scene.view(0), size, lines_.bounds);
    }

    std::unique_ptr<Renderer> make_renderer() const {
        auto renderer = std::make_unique<Renderer>(DeviceOptions{.interop = GetParam()});
        renderer->set_lines(lines_);
        return renderer;
    }

    Picture draw(Renderer& renderer, const FrameOptions& options) const {
        canvas_->clear({1, 1, 1, 1});
        renderer.draw(camera_, options, canvas_->framebuffer());
        if (options.intervals != KeptIntervals::none) {
            EXPECT_FALSE(renderer.read_intervals().empty());
        }
        return canvas_->read();
    }

    /// A renderer's whole life with the n-th creation failing, for n from 1 until none does.
    void fail_each_creation(int& fail, const int& creations, const FrameOptions& options) {
        const Picture expected = draw(*make_renderer(), options);
        const long live_gl = gl_faults().live;
        const ClCounts live_cl = opencl_faults().references;
        int failed = 0, survived = 0, n = 0;
        for (bool reached = true; reached;) {
            fail = ++n;
            const int before = creations;
            try {
                const Picture picture = draw(*make_renderer(), options);
                reached = fail == 0;
                if (reached) ++survived;
                EXPECT_EQ(picture, expected) << "creation " << n;
            } catch (const DeviceError& error) {
                ++failed;
                EXPECT_EQ(fail, 0) << "failed before creation " << n << ": " << error.what();
                EXPECT_GT(std::string{error.what()}.size(), 20U);
            }
            EXPECT_GT(creations, before);
            EXPECT_EQ(gl_faults().live, live_gl) << "objects of GL left after creation " << n;
            EXPECT_EQ(opencl_faults().references, live_cl)
                << "OpenCL objects left after creation " << n;
            fail = 0;
            if (HasFailure()) return;
        }
        EXPECT_GT(failed, 20);
        EXPECT_EQ(draw(*make_renderer(), options), expected);
        std::cout << failed << " failures ended in an error, " << survived << " were survived\n";
    }

    gl::HeadlessContext context_;
    std::unique_ptr<gl::Canvas> canvas_;
    LineSet lines_;
    Camera camera_;
};

TEST_P(Fault, EveryOpenClCreationThatFailsIsACleanError) {
    fail_each_creation(opencl_faults().fail_creation, opencl_faults().creations,
                       all_effects(Method::atlas));
}

TEST_P(Fault, EveryGlCreationThatFailsIsACleanError) {
    for (const Method method : {Method::atlas, Method::spine, Method::item_buffer}) {
        SCOPED_TRACE(static_cast<int>(method));
        fail_each_creation(gl_faults().fail_creation, gl_faults().creations, all_effects(method));
    }
}

TEST_P(Fault, ARendererGoesOnAfterAQueueThatFailsInTheMiddleOfAFrame) {
    const FrameOptions options = all_effects(Method::atlas);
    const std::unique_ptr<Renderer> renderer = make_renderer();
    const Picture expected = draw(*renderer, options);
    opencl_faults().commands = 0;
    EXPECT_EQ(draw(*renderer, options), expected);
    const int commands = opencl_faults().commands;
    EXPECT_GT(commands, 20);
    int failed = 0;
    for (int n = 1; n <= commands; ++n) {
        opencl_faults().fail_command = n;
        try {
            draw(*renderer, options);
        } catch (const DeviceError&) {
            ++failed;
        }
        opencl_faults().fail_command = 0;
        EXPECT_EQ(draw(*renderer, options), expected) << "after command " << n;
        if (HasFailure()) return;
    }
    EXPECT_EQ(failed, commands);
}

TEST_P(Fault, ALostContextIsSaidAndANewOneWorks) {
    const FrameOptions options = all_effects(Method::atlas);
    std::unique_ptr<Renderer> renderer = make_renderer();
    const Picture expected = draw(*renderer, options);
    gl_faults().context_lost = true;
    try {
        draw(*renderer, options);
        ADD_FAILURE() << "nothing was said";
    } catch (const DeviceError& error) {
        EXPECT_NE(std::string{error.what()}.find("context was lost"), std::string::npos);
    }
    EXPECT_NO_THROW(renderer.reset());
    gl_faults().context_lost = false;
    canvas_.reset(); // of the old context
    const gl::HeadlessContext another;
    canvas_ = std::make_unique<gl::Canvas>(size);
    EXPECT_EQ(draw(*make_renderer(), options), expected);
}

INSTANTIATE_TEST_SUITE_P(Modes, Fault, testing::Values("copy", "host-pointer"),
                         [](const auto& tested) {
                             return tested.param == "copy" ? "Copy" : "HostPointer";
                         });

} // namespace
} // namespace lineatlas::test
