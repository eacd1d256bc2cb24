// The two forms of `strokes` compared. Kernels and GL draw the same picture, except for rounding.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "scene_cameras.hpp"

#include <gtest/gtest.h>

namespace lineatlas::test {
namespace {

using Picture = std::vector<std::uint8_t>;

constexpr glm::ivec2 size{640, 480};

struct Look {
    const char* name;
    void (*apply)(FrameOptions&);
};

void as_it_is(FrameOptions&) {}
void wide(FrameOptions& options) {
    options.style.pen.width = 7;
    options.style.pen.color = {0.8F, 0.2F, 0.1F};
}
void thin(FrameOptions& options) {
    options.style.pen.width = 0.6F;
}
void pale(FrameOptions& options) {
    options.style.pen.width = 4;
    options.style.pen.opacity = 0.5F;
}
void round_all(FrameOptions& options) {
    options.style.pen.width = 5;
    options.style.pen.join = Join::round;
    options.style.pen.cap = Cap::round;
}
void square(FrameOptions& options) {
    options.style.pen.width = 5;
    options.style.pen.path_cap = Cap::butt;
}
void dashed(FrameOptions& options) {
    options.style.pen.mark = "dashed";
    options.style.pen.width = 3;
}
void hidden(FrameOptions& options) {
    options.style.hidden = true;
}
void overshot(FrameOptions& options) {
    options.style.filter.overshoot = 6;
}
void haloed(FrameOptions& options) {
    options.style.filter.halo = 3;
}
void thinned(FrameOptions& options) {
    options.style.density.limit = 0.15F;
    options.style.hidden = true;
    options.style.hidden_density = 0.05F;
}
void pens(FrameOptions& options) {
    options.style.hidden = true;
    options.style.pens = {
        {.match = {.kinds = {"outline"}}, .width = 5, .color = glm::vec3{0.1F, 0.2F, 0.7F}},
        {.match = {.kinds = {"boundary"}}, .color = glm::vec3{0.7F, 0.1F, 0.1F}, .opacity = 0.6F},
        {.match = {.kinds = {"crease"}, .hidden = true}, .mark = "solid", .width = 2}};
}
void exact(FrameOptions& options) {
    options.method = Method::exact;
    options.style.hidden = true;
    options.style.hidden_density = 0.05F;
}

constexpr Look looks[] = {{"as it is", as_it_is}, {"wide", wide},       {"thin", thin},
                          {"pale", pale},         {"round", round_all}, {"square", square},
                          {"dashed", dashed},     {"hidden", hidden},   {"overshot", overshot},
                          {"haloed", haloed},     {"thinned", thinned}, {"pens", pens},
                          {"exact", exact}};

class StrokeForms : public testing::TestWithParam<std::string> {
  protected:
    Renderer renderer(const std::string& scene) {
        Renderer result{{.compute = GetParam()}};
        result.set_lines(scene_lines(scene));
        return result;
    }
    static Camera camera(const std::string& scene) {
        return make_camera(make_scene(scene).view(0.1F), size, scene_lines(scene).bounds);
    }
    static Picture draw(Renderer& renderer, const Camera& camera, FrameOptions options,
                        StageForm form, int bits = 8) {
        gl::Canvas canvas{size, bits};
        canvas.clear(glm::vec4{1});
        options.forms.strokes = form;
        options.steady = false;
        renderer.draw(camera, options, canvas.framebuffer());
        return canvas.read();
    }

    gl::HeadlessContext context_;
};

/// The share of the values that are further apart than `most`.
double share_beyond(const Picture& a, const Picture& b, int most) {
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < a.size(); ++i) beyond += std::abs(a[i] - b[i]) > most ? 1 : 0;
    return static_cast<double>(beyond) / static_cast<double>(a.size());
}

std::size_t drawn_values(const Picture& picture) {
    return static_cast<std::size_t>(
        std::ranges::count_if(picture, [](std::uint8_t value) { return value < 200; }));
}

TEST_P(StrokeForms, DrawTheSamePicture) {
    for (const char* scene : {"clevis", "house"}) {
        Renderer r = renderer(scene);
        const Camera view = camera(scene);
        for (const Look& look : looks) {
            SCOPED_TRACE(std::string{scene} + ", " + look.name);
            FrameOptions options;
            look.apply(options);
            const Picture by_gl = draw(r, view, options, StageForm::raster);
            const Picture by_kernels = draw(r, view, options, StageForm::compute);
            ASSERT_GT(drawn_values(by_gl), 3000U);
            EXPECT_NE(by_gl, by_kernels); // else both are the same form
            const double beyond = share_beyond(by_gl, by_kernels, 2);
            EXPECT_LE(beyond, 1e-4);
            std::cout << scene << ' ' << look.name << ": " << 100 * beyond
                      << " % of the values differ by more than 2\n";
        }
    }
}

TEST_P(StrokeForms, WhatKernelsDoNotKnowIsDrawnByGl) {
    const std::string scene = "clevis";
    Renderer r = renderer(scene);
    const Camera view = camera(scene);
    const std::function<void(Style&)> changes[] = {
        [](Style& style) { style.pen.mark = "pencil"; },
        [](Style& style) { style.pen.mark = "dotted"; },
        [](Style& style) { style.pen.cap = Cap::taper; },
        [](Style& style) { style.pen.path_cap = Cap::texture; },
        [](Style& style) { style.pen.join = Join::bevel; },
        [](Style& style) { style.pen.mitre_limit = 2; },
        [](Style& style) {
            style.pen.width_profile = {0.5F, 1};
        },
        [](Style& style) { style.pen.opacity_profile = {0.5F}; },
        [](Style& style) { style.focus.on = true; },
        [](Style& style) {
            style.hidden = true;
            style.hidden_pen.mark = "fine";
        },
    };
    for (const auto& change : changes) {
        FrameOptions options;
        options.style.pen.width = 4;
        change(options.style);
        EXPECT_EQ(draw(r, view, options, StageForm::raster),
                  draw(r, view, options, StageForm::compute));
    }
    // Pictures finer than coverage are drawn alike, too.
    EXPECT_EQ(draw(r, view, {}, StageForm::raster, 16), draw(r, view, {}, StageForm::compute, 16));
}

TEST_P(StrokeForms, FramesOfEitherFollowEachOther) {
    Renderer r = renderer("clevis");
    const Camera view = camera("clevis");
    FrameOptions plain, with_hidden;
    with_hidden.style.hidden = true;
    const Picture first = draw(r, view, plain, StageForm::compute);
    const Picture by_gl = draw(r, view, plain, StageForm::raster);
    const Picture second = draw(r, view, with_hidden, StageForm::compute);
    EXPECT_EQ(draw(r, view, plain, StageForm::compute), first);
    EXPECT_EQ(draw(r, view, plain, StageForm::raster), by_gl);
    EXPECT_EQ(draw(r, view, with_hidden, StageForm::compute), second);
    EXPECT_NE(first, second);
}

INSTANTIATE_TEST_SUITE_P(OnBackend, StrokeForms, testing::Values("cpp", "opencl"),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace lineatlas::test
