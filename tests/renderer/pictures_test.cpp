// Whole frames with every choice that must not change the picture, compared in the four scenes.
// Small scenes are drawn at several cameras, one of them inside the model.

#include "compare.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "planted_error.hpp"
#include "scene_cameras.hpp"

namespace lineatlas::test {
namespace {

struct Drawn {
    std::vector<std::uint8_t> pixels;
    Renderer::Samples samples;
    FrameStats stats;
};

/// The reason why the renderer's device cannot share memory with GL; empty if it can.
std::string why_no_shared_memory() {
    try {
        Renderer{DeviceOptions{.interop = "host-pointer"}};
    } catch (const DeviceError& error) {
        return error.what();
    }
    return {};
}

/// The base of all comparisons of pictures.
class Pictures : public testing::Test {
  protected:
    Drawn draw(Renderer& renderer, const Camera& camera, const FrameOptions& options) {
        canvas_.clear(glm::vec4{1});
        Drawn drawn;
        drawn.stats = renderer.draw(camera, options, canvas_.framebuffer());
        drawn.pixels = canvas_.read();
        if (options.method == Method::atlas) drawn.samples = renderer.read_samples();
        return drawn;
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{400, 300}};
};

class SamePicture : public Pictures, public testing::WithParamInterface<std::string> {
  protected:
    Renderer renderer(const DeviceOptions& options) {
        Renderer result{options};
        result.set_lines(scene_lines(GetParam()));
        // By boxes around batches the renderer drops hidden segments without any sample. It makes
        // these boxes when the model stands still.
        const Camera camera = few_scene_cameras(GetParam(), canvas_.size())[0].camera;
        for (int frame = 0; frame < 2; ++frame) draw(result, camera, {.steady = false});
        return result;
    }

    /// Draws every camera in both ways and passes the results to `compare`.
    template <class Compare>
    void compare_each(Renderer& a, const FrameOptions& a_options, Renderer& b,
                      const FrameOptions& b_options, Compare&& compare) {
        for (const NamedCamera& view : few_scene_cameras(GetParam(), canvas_.size())) {
            SCOPED_TRACE(view.name);
            const Drawn first = draw(a, view.camera, a_options);
            const Drawn second = draw(b, view.camera, b_options);
            ASSERT_GT(first.stats.runs, 0U) << "an empty picture proves nothing";
            compare(first, second);
        }
    }
};

void expect_same_samples(const Drawn& a, const Drawn& b) {
    EXPECT_TRUE(equal(a.samples.offsets, b.samples.offsets));
    const ByteDifference difference = compare_bytes(a.samples.alpha, b.samples.alpha);
    EXPECT_LE(difference.share(), 0.001)
        << difference.beyond << " of " << difference.count << ", largest " << difference.largest;
}

void expect_identical(const Drawn& a, const Drawn& b) {
    EXPECT_TRUE(equal(a.samples.offsets, b.samples.offsets));
    EXPECT_TRUE(equal(a.samples.alpha, b.samples.alpha));
    EXPECT_TRUE(equal(a.pixels, b.pixels));
}

void expect_same_picture(const Drawn& a, const Drawn& b) {
    const ByteDifference difference = compare_bytes(a.pixels, b.pixels);
    EXPECT_LE(difference.share(), 0.001)
        << difference.beyond << " of " << difference.count << ", largest " << difference.largest;
}

/// All effects of strokes at once.
Style every_effect() {
    Style style{.pen = {.width = 3, .cap = Cap::taper},
                .filter = {.fill_holes = 3, .drop_runs = 4, .overshoot = 9, .halo = 3},
                .density = {.limit = 0.1F}};
    style.hidden = true;
    style.focus = {.on = true, .point = {0.4F, 0.6F, 0}};
    return style;
}

TEST_P(SamePicture, RasterAtlasEqualsComputeAtlas) {
    Renderer r = renderer({});
    for (const bool high : {false, true}) {
        FrameOptions raster{.probes = high ? 9U : 1U, .depth_scale = high ? 2 : 1};
        FrameOptions compute = raster;
        raster.forms.atlas = StageForm::raster;
        compute.forms.atlas = StageForm::compute;
        compare_each(r, raster, r, compute, expect_same_samples);
    }
}

TEST_P(SamePicture, OpenClEqualsReference) {
    Renderer opencl = renderer({});
    Renderer cpp = renderer({.compute = "cpp"});
    compare_each(opencl, {.forms = {.atlas = StageForm::compute}}, cpp,
                 {.forms = {.atlas = StageForm::compute}}, [](const Drawn& a, const Drawn& b) {
                     expect_same_samples(a, b);
                     expect_same_picture(a, b);
                 });
    for (const Style& style : {Style{}, every_effect()}) {
        const FrameOptions exact{.method = Method::exact, .style = style};
        compare_each(opencl, exact, cpp, exact, expect_same_picture);
    }
}

TEST_P(SamePicture, ExactDrawsTheAtlasesPictureButForItsErrors) {
    // The atlas draws a line that lies less than two pixels behind the surface that hides it.
    Renderer r = renderer({});
    compare_each(r, {.method = Method::exact}, r, {}, [](const Drawn& exact, const Drawn& atlas) {
        const auto ink = [](const Drawn& drawn, std::size_t i) { return 255 - drawn.pixels[i]; };
        std::size_t dark = 0, exact_alone = 0;
        for (std::size_t i = 0; i < exact.pixels.size(); i += 4) {
            if (ink(exact, i) < 200) continue;
            ++dark;
            if (ink(atlas, i) < 30) ++exact_alone;
        }
        EXPECT_GT(dark, 200U);
        EXPECT_LE(static_cast<double>(exact_alone), 0.002 * static_cast<double>(dark));
    });
}

TEST_P(SamePicture, HostPointerEqualsCopy) {
    if (const std::string reason = why_no_shared_memory(); !reason.empty()) GTEST_SKIP() << reason;
    Renderer host = renderer({.interop = "host-pointer"});
    Renderer copy = renderer({.interop = "copy"});
    for (const StageForm form : {StageForm::raster, StageForm::compute}) {
        compare_each(host, {.forms = {.atlas = form}}, copy, {.forms = {.atlas = form}},
                     expect_identical);
    }
    const FrameOptions exact{.method = Method::exact, .style = every_effect()};
    compare_each(host, exact, copy, exact, expect_identical);
}

TEST_P(SamePicture, CullingHiddenSegmentsChangesNoPixel) {
    Renderer r = renderer({});
    for (const StageForm form : {StageForm::raster, StageForm::compute}) {
        for (const bool high : {false, true}) {
            const FrameOptions culled{.probes = high ? 9U : 1U,
                                      .depth_scale = high ? 2 : 1,
                                      .forms = {.atlas = form},
                                      .style = {.pen = {.mark = "pencil"}},
                                      .cull_hidden = true};
            FrameOptions kept = culled;
            kept.cull_hidden = false;
            compare_each(r, culled, r, kept, [](const Drawn& a, const Drawn& b) {
                if (a.stats.segments >= 10'000) { // small models are not culled
                    EXPECT_LT(a.stats.samples, b.stats.samples) << "nothing was culled";
                }
                EXPECT_EQ(a.stats.runs, b.stats.runs);
                EXPECT_TRUE(equal(a.pixels, b.pixels));
            });
        }
    }
}

TEST_P(SamePicture, CullingHiddenSegmentsChangesNoPixelOfFilteredStrokes) {
    Renderer r = renderer({});
    const FrameOptions culled{
        .style = {.filter = {.fill_holes = 4, .drop_runs = 4, .overshoot = 12, .halo = 3}},
        .cull_hidden = true};
    FrameOptions kept = culled;
    kept.cull_hidden = false;
    compare_each(r, culled, r, kept, [](const Drawn& a, const Drawn& b) {
        EXPECT_EQ(a.stats.runs, b.stats.runs);
        EXPECT_TRUE(equal(a.pixels, b.pixels));
    });
}

TEST_P(SamePicture, SpineHostPointerEqualsCopy) {
    if (const std::string reason = why_no_shared_memory(); !reason.empty()) GTEST_SKIP() << reason;
    Renderer host = renderer({.interop = "host-pointer"});
    Renderer copy = renderer({.interop = "copy"});
    const FrameOptions options{.method = Method::spine, .probes = 4};
    for (const NamedCamera& view : few_scene_cameras(GetParam(), canvas_.size())) {
        SCOPED_TRACE(view.name);
        EXPECT_TRUE(equal(draw(host, view.camera, options).pixels,
                          draw(copy, view.camera, options).pixels));
    }
}

TEST_P(SamePicture, CullingHiddenSegmentsChangesNoPixelOfTheSpineTest) {
    Renderer r = renderer({});
    const FrameOptions culled{.method = Method::spine, .probes = 4, .cull_hidden = true};
    FrameOptions kept = culled;
    kept.cull_hidden = false;
    for (const NamedCamera& view : few_scene_cameras(GetParam(), canvas_.size())) {
        SCOPED_TRACE(view.name);
        EXPECT_TRUE(equal(draw(r, view.camera, culled).pixels, draw(r, view.camera, kept).pixels));
    }
}

TEST_P(SamePicture, TheSameFrameTwiceIsIdentical) {
    Renderer r = renderer({});
    compare_each(r, {}, r, {}, expect_identical);
    const FrameOptions exact{.method = Method::exact, .style = every_effect()};
    compare_each(r, exact, r, exact, expect_identical);
}

TEST_P(SamePicture, MeasuringStagesChangesNothing) {
    Renderer r = renderer({});
    compare_each(r, {}, r, {.measure_stages = true}, expect_identical);
}

INSTANTIATE_TEST_SUITE_P(Scene, SamePicture, testing::Values("clevis", "house", "ship", "office"),
                         [](const auto& info) { return info.param; });

/// The comparisons above, each with an error planted on one side.
class Planted : public Pictures {
  protected:
    Drawn draw_clevis(const FrameOptions& options, const DeviceOptions& device = {}) {
        Renderer fresh{device};
        fresh.set_lines(scene_lines("clevis"));
        return draw(fresh, scene_cameras("clevis", canvas_.size())[0].camera, options);
    }
    static bool samples_differ(const Drawn& a, const Drawn& b) {
        return compare_bytes(a.samples.alpha, b.samples.alpha).share() > 0.001;
    }
    static bool pictures_differ(const Drawn& a, const Drawn& b) {
        return compare_bytes(a.pixels, b.pixels).share() > 0.001;
    }
};

TEST_F(Planted, InTheAtlasKernelIsSeenBesideTheRasterForm) {
    const PlantedError error{"atlas.cl", "PROBES_PER_AXIS) + shift", "PROBES_PER_AXIS) + 0.3f"};
    EXPECT_TRUE(samples_differ(draw_clevis({.forms = {.atlas = StageForm::raster}}),
                               draw_clevis({.forms = {.atlas = StageForm::compute}})));
}

TEST_F(Planted, InTheProbeShaderIsSeenBesideTheKernel) {
    const PlantedError error{"probe.glsl", "per_axis) + shift", "per_axis) + 0.3"};
    EXPECT_TRUE(samples_differ(draw_clevis({.forms = {.atlas = StageForm::raster}}),
                               draw_clevis({.forms = {.atlas = StageForm::compute}})));
}

TEST_F(Planted, InTheSecondDrawIsSeenBesideTheKernel) {
    // The error is in values, not in places, because a texel that is not drawn may hold the right
    // value.
    const PlantedError error{"atlas.frag", "alpha = visibility(",
                             "alpha = texel.y > sample_base.x / uint(atlas_size.x) ? 0.5 : "
                             "visibility("};
    EXPECT_TRUE(
        samples_differ(draw_clevis({.step = 0.25F, .forms = {.atlas = StageForm::raster}}),
                       draw_clevis({.step = 0.25F, .forms = {.atlas = StageForm::compute}})));
}

TEST_F(Planted, InTheKernelIsSeenBesideTheReference) {
    const PlantedError error{"shared/run.h", "xy(c) / c.w + 1.0f", "xy(c) / c.w + 1.01f"};
    const Drawn opencl = draw_clevis({});
    const Drawn cpp = draw_clevis({}, {.compute = "cpp"});
    EXPECT_FALSE(samples_differ(opencl, cpp));
    EXPECT_TRUE(pictures_differ(opencl, cpp));
}

class Frames : public testing::Test {
  protected:
    Frames() { renderer_.set_lines(scene_lines("house")); }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{400, 300}};
    Renderer renderer_;
    Camera camera_ = scene_cameras("house", {400, 300})[0].camera;
};

TEST_F(Frames, AnAtlasThatIsTooSmallGrowsAndDrawsEverything) {
    // A finer step needs more samples and runs than the renderer starts with.
    for (const StageForm form : {StageForm::compute, StageForm::raster}) {
        Renderer fresh;
        fresh.set_lines(scene_lines("house"));
        const FrameOptions fine{
            .probes = 1, .depth_scale = 1, .step = 0.05F, .forms = {.atlas = form}};
        const FrameStats first = fresh.draw(camera_, fine, canvas_.framebuffer());
        EXPECT_GT(first.samples, 1U << 20U) << "the test must exceed the first capacity";
        const Renderer::Samples grown = fresh.read_samples();
        fresh.draw(camera_, fine, canvas_.framebuffer());
        const Renderer::Samples settled = fresh.read_samples();
        EXPECT_EQ(grown.alpha.size(), first.samples);
        EXPECT_TRUE(equal(grown.alpha, settled.alpha));
        EXPECT_EQ(grown.runs.size(), settled.runs.size());
    }
}

TEST_F(Frames, LineKindsAreChosenPerFrame) {
    const FrameStats all = renderer_.draw(camera_, {}, canvas_.framebuffer());
    const FrameStats creases =
        renderer_.draw(camera_, {.lines = mask_of(LineKind::crease)}, canvas_.framebuffer());
    const FrameStats none = renderer_.draw(camera_, {.lines = 0}, canvas_.framebuffer());
    EXPECT_LT(creases.samples, all.samples);
    EXPECT_GT(creases.samples, 0U);
    EXPECT_EQ(none.samples, 0U);
    EXPECT_EQ(none.runs, 0U);
}

TEST_F(Frames, SizeMayChangeFromFrameToFrame) {
    for (const glm::ivec2 size : {glm::ivec2{400, 300}, {1, 1}, {33, 700}, {900, 20}, {400, 300}}) {
        gl::Canvas canvas{size};
        const Camera camera = scene_cameras("house", size)[0].camera;
        EXPECT_NO_THROW(renderer_.draw(camera, {}, canvas.framebuffer()))
            << size.x << "x" << size.y;
    }
    const FrameStats again = renderer_.draw(camera_, {}, canvas_.framebuffer());
    EXPECT_GT(again.runs, 0U);
}

TEST_F(Frames, ScenesMayBeReplaced) {
    renderer_.set_lines(scene_lines("clevis"));
    const Camera camera = scene_cameras("clevis", {400, 300})[0].camera;
    EXPECT_EQ(renderer_.draw(camera, {}, canvas_.framebuffer()).segments,
              scene_lines("clevis").segments.size());
    renderer_.set_lines(LineSet{});
    EXPECT_EQ(renderer_.draw(camera, {}, canvas_.framebuffer()).runs, 0U);
}

TEST_F(Frames, BadOptionsAreRefused) {
    const auto draw = [&](const FrameOptions& options) {
        renderer_.draw(camera_, options, canvas_.framebuffer());
    };
    EXPECT_THROW(draw({.probes = 5}), UsageError);
    EXPECT_THROW(draw({.probes = 0}), UsageError);
    EXPECT_THROW(draw({.depth_scale = 0}), UsageError);
    EXPECT_THROW(draw({.depth_scale = 5}), UsageError);
    EXPECT_THROW(draw({.step = 0}), UsageError);
    EXPECT_THROW(draw({.step = NAN}), UsageError);
    EXPECT_THROW(draw({.style = {.pen = {.width = -1}}}), UsageError);
    EXPECT_THROW(draw({.style = {.pen = {.mark = "crayon"}}}), UsageError);
    EXPECT_THROW(Renderer{DeviceOptions{.compute = "cuda"}}, UsageError);
    EXPECT_THROW(Renderer{DeviceOptions{.device = "opencl:no such platform"}}, UsageError);
    EXPECT_THROW(Renderer{DeviceOptions{.interop = "telepathy"}}, UsageError);
    EXPECT_THROW(Renderer{}.read_samples(), UsageError);
    EXPECT_NO_THROW(draw({})); // the renderer still works
}

} // namespace
} // namespace lineatlas::test
