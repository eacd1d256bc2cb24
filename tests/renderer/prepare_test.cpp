// Kernels are built before all frames if the caller asks for it. The tests count requests to the
// driver.
#include <algorithm>
#include <string>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "fault_support.hpp"
#include "lineatlas/style_files.hpp"
#include "test_meshes.hpp"

namespace lineatlas::test {
namespace {

struct Look {
    std::string name;
    FrameOptions options;
};

/// Looks that together use every stage in every form.
std::vector<Look> make_looks() {
    std::vector<Look> looks{{"atlas", {}}, {"exact", {.method = Method::exact}}};
    for (const StyleInfo& style : list_styles()) {
        looks.push_back({"atlas, " + style.name, {.style = load_style(style.name)}});
    }
    const auto add = [&](std::string name, const FrameOptions& options) {
        looks.push_back({std::move(name), options});
    };
    for (const Method method : {Method::spine, Method::item_buffer, Method::opengl})
        add("method " + std::to_string(static_cast<int>(method)), {.method = method});
    for (const std::uint32_t probes : {1U, 4U, 16U})
        add(std::to_string(probes) + " probes", {.probes = probes});
    for (const Method method : {Method::atlas, Method::exact, Method::spine}) {
        const std::string by = " by " + std::to_string(static_cast<int>(method));
        add("raster" + by, {.method = method,
                            .forms = {.atlas = StageForm::raster,
                                      .depth = StageForm::raster,
                                      .strokes = StageForm::raster}});
        add("compute" + by, {.method = method,
                             .forms = {.atlas = StageForm::compute,
                                       .depth = StageForm::compute,
                                       .strokes = StageForm::compute}});
        if (method == Method::spine) continue;
        add("intervals" + by, {.method = method, .intervals = KeptIntervals::all, .draw = false});
        FrameOptions all = all_effects(Method::atlas);
        all.method = method;
        add("all effects" + by, all);
        all.style.pen.mark = "solid";
        all.style.filter = {};
        all.style.density = {};
        add("hidden lines" + by, all);
        Style& style = all.style;
        style.pens = {PenRule{.match = {.kinds = {"outline"}}, .width = 4.0F},
                      PenRule{.match = {.kinds = {"crease"}}, .mark = "pencil"}};
        add("rules" + by, all);
        style.pens[1].mark.reset();
        style.pens[1].cap = Cap::round;
        add("caps by rules" + by, all);
    }
    add("restless", {.cull_hidden = false, .steady = false});
    add("creases", {.lines = mask_of(LineKind::crease)});
    return looks;
}

const std::vector<Look>& looks() {
    static const std::vector<Look> all = make_looks();
    return all;
}

/// Line sets: small ones, smooth ones, and one that is large enough for culling.
std::vector<LineSet> make_line_sets() {
    Random random{7};
    std::vector<LineSet> sets{extract_lines(make_scene("clevis").mesh)};
    sets.push_back(extract_lines(sphere(4), {.silhouettes = Silhouettes::smooth}));
    sets.push_back(extract_lines(height_field(random, 90, 1)));
    return sets;
}

int period = 0; ///< OpenClFaults::period

class Prepare : public FaultFixture {
  protected:
    Prepare() { opencl_faults().builds_once = false; }

    static std::unique_ptr<Renderer> make_empty() {
        return std::make_unique<Renderer>(
            DeviceOptions{.compute = "opencl", .interop = GetParam()});
    }

    /// Draws several frames. Some stages need an earlier frame, others a movement.
    void draw_some(Renderer& renderer, const LineSet& lines, const FrameOptions& options) {
        renderer.set_lines(lines);
        Camera camera = make_camera(View{.eye = {3, 2, 4}}, fault_size, lines.bounds);
        const auto draw = [&] {
            canvas_->clear({1, 1, 1, 1});
            renderer.draw(camera, options, canvas_->framebuffer());
        };
        for (int frame = 0; frame < 3; ++frame) draw();
        camera = make_camera(View{.eye = {3.001F, 2, 4}}, fault_size, lines.bounds);
        draw();
        renderer.set_transforms(std::vector<glm::mat4>(
            std::max<std::size_t>(lines.objects.size(), 1),
            glm::translate(glm::mat4{1},
                           {0.1F * (lines.bounds.max.x - lines.bounds.min.x), 0, 0})));
        draw();
        renderer.set_positions(0, lines.vertices);
        draw();
    }
};

TEST_P(Prepare, NoFrameBuildsWhatWasPrepared) {
    const std::vector<LineSet> sets = make_line_sets();
    for (const Look& look : looks()) {
        SCOPED_TRACE(look.name);
        const std::unique_ptr<Renderer> renderer = make_empty();
        opencl_faults().period = ++period; // launches of earlier tests do not count
        renderer->prepare(look.options);
        opencl_faults().builds = opencl_faults().new_forms = 0;
        for (const LineSet& lines : sets) draw_some(*renderer, lines, look.options);
        EXPECT_EQ(opencl_faults().builds, 0);
        EXPECT_EQ(opencl_faults().new_forms, 0) << opencl_faults().new_form;
    }
}

TEST_P(Prepare, NoFrameOfALargeModelBuildsWhatWasPrepared) {
    Random random{7};
    const LineSet lines = extract_lines(height_field(random, 220, 1));
    for (const StageForm form : {StageForm::compute, StageForm::raster}) {
        const FrameOptions options{.forms = {.depth = form}};
        const std::unique_ptr<Renderer> renderer = make_empty();
        renderer->set_lines(lines);
        opencl_faults().period = ++period;
        renderer->prepare(options);
        opencl_faults().builds = opencl_faults().new_forms = 0;
        draw_some(*renderer, lines, options);
        EXPECT_EQ(opencl_faults().builds, 0);
        EXPECT_EQ(opencl_faults().new_forms, 0) << opencl_faults().new_form;
    }
}

TEST_P(Prepare, TellsHowFarItIsAndStops) {
    const std::unique_ptr<Renderer> renderer = make_empty();
    std::vector<float> told;
    renderer->prepare({}, [&](float done) {
        told.push_back(done);
        return true;
    });
    EXPECT_GT(told.size(), 20U);
    EXPECT_EQ(told.front(), 0);
    EXPECT_EQ(told.back(), 1);
    EXPECT_TRUE(std::ranges::is_sorted(told));
    std::size_t calls = 0;
    EXPECT_THROW(renderer->prepare({}, [&](float) { return ++calls < 5; }), Cancelled);
    EXPECT_EQ(calls, 5U);
    renderer->set_lines(lines_);
    EXPECT_EQ(draw(*renderer, {}), draw(*make_renderer(), {}));
}

TEST_P(Prepare, RefusesWhatDrawRefuses) {
    const std::unique_ptr<Renderer> renderer = make_empty();
    EXPECT_THROW(renderer->prepare({.probes = 7}), UsageError);
    EXPECT_THROW(renderer->prepare({.depth_scale = 9}), UsageError);
    EXPECT_THROW(renderer->prepare({.method = Method::spine, .draw = false}), UsageError);
}

TEST_P(Prepare, AFailureIsSaidAndTheNextOneWorks) {
    const std::unique_ptr<Renderer> renderer = make_empty();
    opencl_faults().fail_command = 40;
    EXPECT_THROW(renderer->prepare({}), DeviceError);
    opencl_faults().reset();
    EXPECT_NO_THROW(renderer->prepare({}));
}

// Kernels do not depend on the sharing mode.
INSTANTIATE_TEST_SUITE_P(OneMode, Prepare, testing::Values("host-pointer"), mode_name);

} // namespace
} // namespace lineatlas::test
