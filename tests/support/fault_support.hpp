// Shared by tests of failing devices and of small devices.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "gl_faults.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "support/fault_layer/fault_layer.hpp"

namespace lineatlas::test {

using Picture = std::vector<std::uint8_t>;
constexpr glm::ivec2 fault_size{160, 120};

/// The faults of the layer. The loader must have loaded the layer before the first OpenCL call.
inline OpenClFaults& opencl_faults() {
    static OpenClFaults* faults = [] {
        setenv("OPENCL_LAYERS", LINEATLAS_FAULT_LAYER, 1);
        setenv("LINEATLAS_CACHE", "off", 1); // else a trial of the device may come first
        void* layer = dlopen(LINEATLAS_FAULT_LAYER, RTLD_NOW);
        if (layer == nullptr) throw std::runtime_error(dlerror());
        return reinterpret_cast<GetOpenClFaults*>(dlsym(layer, opencl_faults_symbol))();
    }();
    return *faults;
}

/// Options with all effects, so that every stage runs and every table is made.
inline FrameOptions all_effects(Method method) {
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

/// A renderer on devices whose faults the test chooses. The parameter is the sharing mode.
class FaultFixture : public testing::TestWithParam<std::string> {
  protected:
    FaultFixture() {
        opencl_faults().reset();
        opencl_faults().builds_once = true;
        static const bool hooked = (hook_gl(), true);
        EXPECT_TRUE(hooked);
        gl_faults() = {.live = gl_faults().live};
        canvas_ = std::make_unique<gl::Canvas>(fault_size);
        const Scene scene = make_scene("clevis");
        lines_ = extract_lines(scene.mesh);
        camera_ = make_camera(scene.view(0), fault_size, lines_.bounds);
    }
    ~FaultFixture() override {
        opencl_faults().reset();
        gl_faults() = {.live = gl_faults().live};
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

    gl::HeadlessContext context_;
    std::unique_ptr<gl::Canvas> canvas_;
    LineSet lines_;
    Camera camera_;
};

/// Names of the two modes that work everywhere.
inline std::string mode_name(const testing::TestParamInfo<std::string>& tested) {
    return tested.param == "copy" ? "Copy" : "HostPointer";
}

} // namespace lineatlas::test
