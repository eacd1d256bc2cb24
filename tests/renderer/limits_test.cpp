// Devices that are too small: the pictures that they still draw, and the messages if they can't.
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <utility>

#include "compare.hpp"
#include "core/limits.hpp"
#include "core/model_limits.hpp"
#include "fault_support.hpp"
#include "test_meshes.hpp"

namespace lineatlas::test {
namespace {

constexpr std::uint64_t kib = 1024;

struct LargeFrame {
    const char* scene;
    glm::ivec2 size;
    FrameOptions options;
};

FrameOptions fine_steps() {
    return {.step = 0.02F, .steady = false};
}

FrameOptions dense() {
    FrameOptions options;
    options.style.density.limit = 0.2F;
    return options;
}

/// Frames such that each table is the largest one in some frame.
std::vector<LargeFrame> large_frames() {
    return {{"clevis", {160, 120}, all_effects(Method::atlas)},
            {"clevis", {800, 600}, fine_steps()},
            {"clevis", {1200, 900}, dense()},
            {"clevis", {160, 120}, {.depth_scale = 4}},
            {"house", {160, 120}, {.intervals = KeptIntervals::all}},
            {"clevis", {160, 120}, {.method = Method::item_buffer}},
            {"clevis", {160, 120}, {.method = Method::spine}},
            {"clevis", {160, 120}, {.method = Method::opengl}}};
}

/// Some of the large frames, for tests in which the others only repeat the same tables.
std::vector<LargeFrame> some_frames() {
    std::vector<LargeFrame> frames = large_frames();
    return {frames[0], frames[2], frames[3], frames[4], frames[6]};
}

class Limits : public FaultFixture {
  protected:
    /// Draws this frame from now on.
    Picture use(const LargeFrame& frame) {
        canvas_ = std::make_unique<gl::Canvas>(frame.size);
        const Scene scene = make_scene(frame.scene);
        lines_ = extract_lines(scene.mesh);
        camera_ = make_camera(scene.view(0), frame.size, lines_.bounds);
        return draw(*make_renderer(), frame.options);
    }

    /// A picture, by tiles if necessary. It is empty if the device is too small; then there was a
    /// message.
    Picture try_draw(Renderer& renderer, const FrameOptions& options) {
        try {
            const int tile = renderer.tile_size(camera_.size, options);
            return tile == 0 ? draw(renderer, options) : draw_tiles(renderer, options, tile);
        } catch (const Error& error) {
            note(error.what());
            return {};
        }
    }

    Picture draw_tiles(Renderer& renderer, const FrameOptions& options, int tile_size) {
        const gl::Canvas canvas{glm::min(camera_.size, tile_size)};
        const glm::ivec2 size = camera_.size;
        Picture picture(static_cast<std::size_t>(4 * size.x * size.y));
        const auto begin = [&](const PictureTile&) {
            const std::array<float, 4> white{1, 1, 1, 1};
            glClearNamedFramebufferfv(canvas.framebuffer(), GL_COLOR, 0, white.data());
        };
        const auto end = [&](const PictureTile& tile) {
            const Picture part = canvas.read(tile.size);
            const int top = size.y - tile.low.y - tile.size.y;
            for (int y = 0; y < tile.size.y; ++y) {
                std::copy_n(part.begin() + 4 * tile.size.x * y, 4 * tile.size.x,
                            picture.begin() + 4 * ((top + y) * size.x + tile.low.x));
            }
        };
        renderer.draw_tiles(camera_, options, {canvas.framebuffer(), tile_size, begin, end});
        ++tiled_;
        return picture;
    }

    /// Checks a message about a limit: it must say what needs how much, what there is, and what
    /// helps.
    void note(const std::string& message) {
        const std::size_t needs = message.find(" needs "), there_is = message.find(", and "),
                          help = message.find("; use ");
        EXPECT_TRUE(needs < there_is && there_is < help && help != std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        // These words come before the cause.
        const std::size_t mode = message.find(" cannot share ");
        const std::size_t what = mode < needs ? message.find(": ", mode) + 2 : 0;
        ++said_[message.substr(what, needs - what)];
    }

    void expect_said(std::initializer_list<const Purpose*> purposes) const {
        for (const Purpose* purpose : purposes) {
            EXPECT_TRUE(said_.contains(std::string{purpose->what})) << purpose->what;
        }
    }

    void count(const Picture& expected, const Picture& seen, std::uint64_t limit) {
        if (seen.empty()) {
            ++refused_;
            return;
        }
        ++drawn_;
        ASSERT_EQ(expected.size(), seen.size());
        EXPECT_LE(compare_bytes(expected, seen).share(), 1e-3) << "limit " << limit;
    }

    /// Draws with a limit that shrinks. Each frame must equal that of a large device, or end in a
    /// message with all memory released. Then the same renderer must draw a frame that is small
    /// enough.
    template <class Limit>
    void shrink(Limit& limit, std::uint64_t most, std::uint64_t least, const LargeFrame& frame,
                double factor = 0.5) {
        const Picture expected = use(frame);
        const long live_gl = gl_faults().live;
        const ClCounts live_cl = opencl_faults().references;
        for (std::uint64_t value = most; value >= least;
             value = static_cast<std::uint64_t>(factor * static_cast<double>(value))) {
            SCOPED_TRACE(std::string{frame.scene} + ", limit " + std::to_string(value));
            limit = static_cast<Limit>(value);
            try {
                const std::unique_ptr<Renderer> renderer = make_renderer();
                const Picture picture = try_draw(*renderer, frame.options);
                count(expected, picture, value);
                if (picture.empty()) draw_something_small(*renderer);
            } catch (const Error& error) { // the renderer is too large even without a frame
                ++refused_;
                note(error.what());
            }
            limit = 0;
            EXPECT_EQ(gl_faults().live, live_gl);
            ClCounts left_cl = opencl_faults().references;
            for (const ClKind kind : {cl_contexts, cl_programs}) // all renderers share them
                left_cl[kind] = live_cl[kind];
            EXPECT_EQ(left_cl, live_cl);
            EXPECT_EQ(gl_faults().beyond, 0);
            if (HasFailure()) return;
        }
    }

    /// Draws if possible. Even the first tables of a frame may be too large.
    void draw_something_small(Renderer& renderer) {
        Camera small = camera_;
        small.size = {40, 30};
        try {
            EXPECT_GT(renderer.draw(small, {.depth_scale = 1}, canvas_->framebuffer()).runs, 0U);
            ++went_on_;
        } catch (const Error& error) {
            note(error.what());
        }
    }

    void report() const {
        std::cout << drawn_ << " frames were drawn, " << tiled_ << " of them by tiles, " << refused_
                  << " refused, after " << went_on_ << " of which a smaller one was drawn:";
        for (const auto& [what, times] : said_) std::cout << " " << times << " " << what << ",";
        std::cout << "\n";
    }

    std::map<std::string, int> said_;
    int drawn_ = 0, tiled_ = 0, refused_ = 0, went_on_ = 0;
};

TEST_P(Limits, OfABuffersSizeAreWorkedAroundOrNamed) {
    for (const LargeFrame& frame : large_frames()) {
        shrink(opencl_faults().largest_buffer, 7600 * kib, 400 * kib, frame, 2.0 / 3);
        if (HasFailure()) return;
    }
    report();
    EXPECT_GT(drawn_, 20);
    EXPECT_GT(tiled_, 3);
    EXPECT_GT(went_on_, 3);
    expect_said({&purpose::atlas, &purpose::intervals, &purpose::density});
}

/// A frame as picture, intervals and numbers.
struct Drawn {
    Picture picture;
    std::vector<Interval> intervals;
    std::uint32_t samples, runs;
};

class Chunks : public Limits {
  protected:
    Drawn drawn(Renderer& renderer, const FrameOptions& options) {
        canvas_->clear({1, 1, 1, 1});
        const FrameStats stats = renderer.draw(camera_, options, canvas_->framebuffer());
        Drawn result{canvas_->read(), {}, stats.samples, stats.runs};
        if (options.intervals != KeptIntervals::none) result.intervals = renderer.read_intervals();
        return result;
    }

    /// Expects the same frame from a device whose buffers hold `bytes` as from one without a limit.
    void expect_the_same(const FrameOptions& options, std::uint64_t bytes) {
        const Drawn whole = drawn(*make_renderer(), options);
        opencl_faults().largest_buffer = bytes;
        const std::unique_ptr<Renderer> renderer = make_renderer();
        for (int frame = 0; frame < 2; ++frame) { // the second frame has grown tables
            const Drawn cut = drawn(*renderer, options);
            EXPECT_EQ(cut.picture, whole.picture);
            EXPECT_EQ(cut.samples, whole.samples);
            EXPECT_EQ(cut.runs, whole.runs);
            ASSERT_EQ(cut.intervals.size(), whole.intervals.size());
            EXPECT_TRUE(same_bits(cut.intervals, whole.intervals));
        }
        opencl_faults().largest_buffer = 0;
    }

    /// Repeats the model's lines except silhouettes, so that few triangles have many lines.
    void repeat_lines(std::uint32_t times) {
        std::vector<Segment>& all = lines_.segments;
        const auto candidates = std::ranges::find_if(all, [](const Segment& segment) {
            return (segment.tag & LA_TAG_KIND_MASK) == LA_KIND_SILHOUETTE;
        });
        const std::vector<Segment> once{all.begin(), candidates};
        std::uint32_t paths = 0;
        for (const Segment& segment : all) paths = std::max(paths, segment.path + 1);
        std::vector<Segment> copies;
        for (std::uint32_t copy = 1; copy < times; ++copy) {
            for (Segment segment : once) {
                segment.path += copy * paths;
                copies.push_back(segment);
            }
        }
        all.insert(all.begin(), copies.begin(), copies.end()); // candidates stay last
    }

    /// Options for all effects that need a single path at a time, or sums over paths.
    static FrameOptions by_paths(Method method) {
        FrameOptions options{.method = method, .depth_scale = 1, .steady = false};
        options.style.pen.opacity = 0.3F; // lines that are drawn twice or in another order show
        if (method == Method::spine) return options;
        options.intervals = KeptIntervals::all;
        options.style.pen.mark = "pencil";
        options.style.pen.cap = Cap::taper;
        options.style.hidden = true;
        options.style.hidden_pen.color = {1, 0, 0};
        options.style.filter.overshoot = 6;
        options.style.filter.fill_holes = 3;
        options.style.density.limit = 0.1F;
        options.style.fill.mode = FillMode::lambert;
        return options;
    }
};

constexpr std::uint64_t small_buffer = 300 * kib; // a quarter of the tables of the house

TEST_P(Chunks, OfSegmentsMakeTheSamePicturesAndPaths) {
    use({"house", {160, 120}, {}});
    for (const StageForm form : {StageForm::compute, StageForm::raster}) {
        FrameOptions options = by_paths(Method::atlas);
        options.forms.atlas = form;
        expect_the_same(options, small_buffer);
        options.style.hidden = false;
        options.cull_hidden = false;
        expect_the_same(options, small_buffer);
    }
    expect_the_same(by_paths(Method::spine), small_buffer);
    FrameOptions pens = by_paths(Method::atlas);
    pens.style.pens = {{.match = {.kinds = {"crease"}}, .width = 5, .color = glm::vec3{0, 0, 1}},
                       {.match = {.kinds = {"silhouette"}}, .width = 4}};
    expect_the_same(pens, small_buffer);
    FrameOptions paths = by_paths(Method::atlas);
    paths.draw = false;
    expect_the_same(paths, small_buffer);
}

TEST_P(Chunks, OfTheExactMethodMakeTheSame) {
    use({"clevis", {160, 120}, {}});
    repeat_lines(40);
    FrameOptions options = by_paths(Method::exact);
    options.style.pen.opacity = 0.02F;
    options.style.hidden_pen.opacity = 0.02F;
    expect_the_same(options, 700 * kib); // about 7 chunks
    options.draw = false;
    expect_the_same(options, 700 * kib);
}

TEST_P(Chunks, KeepChainsOfSilhouettesWhole) {
    use({"clevis", {160, 120}, {}});
    // 12,288 candidates, as many as 8 chunks hold
    lines_ = extract_lines(sphere(5), {.silhouettes = Silhouettes::mesh});
    camera_ = make_camera({.eye = {1, 2, 3}, .target = {}}, {160, 120}, lines_.bounds);
    expect_the_same(by_paths(Method::atlas), 500 * kib);
}

TEST_P(Chunks, KeepSmoothSilhouettesWhole) {
    use({"clevis", {160, 120}, {}});
    Mesh mesh = cube(), ball = sphere(5);
    for (glm::vec3& p : mesh.positions) p += glm::vec3{2.5F, 0, 0};
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), ball.positions.begin(), ball.positions.end());
    for (const glm::uvec3& t : ball.triangles) mesh.triangles.push_back(t + first);
    lines_ = extract_lines(mesh, {.silhouettes = Silhouettes::automatic});
    ASSERT_EQ(lines_.contours.faces.size(), ball.triangles.size());
    camera_ = make_camera({.eye = {1, 2, 6}, .target = {1, 0, 0}}, {160, 120}, lines_.bounds);
    FrameOptions options = by_paths(Method::atlas);
    expect_the_same(options, 800 * kib); // 20,480 candidates, creases by themselves
    options.method = Method::exact;
    expect_the_same(options, 800 * kib);
}

TEST_P(Chunks, WithoutRoomForContoursSilhouettesRunAlongEdges) {
    use({"clevis", {160, 120}, {}});
    struct Seen {
        double length = 0;
        bool on_triangles = false; ///< some
    };
    const auto seen = [&](Silhouettes silhouettes, std::uint64_t bytes) {
        lines_ = extract_lines(sphere(5), {.silhouettes = silhouettes});
        camera_ = make_camera({.eye = {1, 2, 3}, .target = {}}, {160, 120}, lines_.bounds);
        const std::size_t edges = lines_.segments.size() - lines_.contours.faces.size();
        opencl_faults().largest_buffer = bytes;
        Seen result;
        for (const Interval& one : drawn(*make_renderer(), by_paths(Method::atlas)).intervals) {
            if ((one.flags & LA_INTERVAL_VISIBLE) != 0)
                result.length += one.end_arc - one.start_arc;
            if (one.segment >= edges) result.on_triangles = true;
        }
        opencl_faults().largest_buffer = 0;
        return result;
    };
    const double along_edges = seen(Silhouettes::mesh, 500 * kib).length;
    EXPECT_GT(along_edges, 100);
    const Seen without_room = seen(Silhouettes::smooth, 500 * kib);
    EXPECT_NEAR(without_room.length, along_edges, 1e-3 * along_edges);
    EXPECT_FALSE(without_room.on_triangles);
    EXPECT_TRUE(seen(Silhouettes::smooth, 0).on_triangles) << "there is no room for anything";
}

TEST_P(Chunks, GoByTilesToo) {
    const LargeFrame frame{"house", {400, 300}, by_paths(Method::atlas)};
    FrameOptions options = frame.options;
    options.intervals = KeptIntervals::none; // intervals need depth that tiles lack
    options.depth_scale = 2;
    use({frame.scene, frame.size, options});
    const Picture whole = draw_tiles(*make_renderer(), options, 120);
    opencl_faults().largest_buffer = small_buffer;
    const std::unique_ptr<Renderer> renderer = make_renderer();
    EXPECT_GT(renderer->tile_size(camera_.size, options), 0);
    EXPECT_EQ(draw_tiles(*renderer, options, 120), whole);
}

TEST_P(Chunks, AreCutAnewForAnotherDevice) {
    const FrameOptions options = by_paths(Method::atlas);
    use({"house", {160, 120}, options});
    const std::unique_ptr<Renderer> renderer = make_renderer();
    const Drawn whole = drawn(*renderer, options);
    for (const std::uint64_t bytes : {small_buffer, 2 * small_buffer, std::uint64_t{0}}) {
        opencl_faults().largest_buffer = bytes;
        renderer->set_device({.interop = GetParam()});
        EXPECT_EQ(drawn(*renderer, options).picture, whole.picture);
    }
}

TEST_P(Chunks, AreRefusedForEffectsThatNeedAllLinesAtOnce) {
    use({"house", {160, 120}, {}});
    opencl_faults().largest_buffer = small_buffer;
    const std::unique_ptr<Renderer> renderer = make_renderer();
    const FrameOptions plain = by_paths(Method::atlas);
    FrameOptions halo = plain, items = plain;
    halo.style.filter.halo = 3;
    items.method = Method::item_buffer;
    items.intervals = KeptIntervals::none;
    for (const FrameOptions& options : {halo, items})
        EXPECT_TRUE(try_draw(*renderer, options).empty());
    EXPECT_FALSE(try_draw(*renderer, plain).empty()); // the renderer still works
    try {
        renderer->read_samples();
        ADD_FAILURE();
    } catch (const DeviceError& error) {
        note(error.what());
    }
    expect_said({&purpose::all_halos, &purpose::all_items, &purpose::samples});
}

INSTANTIATE_TEST_SUITE_P(Modes, Chunks, testing::Values("copy", "host-pointer"), mode_name);

TEST_P(Limits, OfADevicesMemoryAreWorkedAroundOrNamed) {
    for (const LargeFrame& frame : some_frames()) {
        shrink(opencl_faults().memory, 8192 * kib, 400 * kib, frame, 0.75);
        if (HasFailure()) return;
    }
    report();
    EXPECT_GT(drawn_, 5);
    EXPECT_GT(went_on_, 2);
    expect_said({&purpose::strokes, &purpose::depth});
}

TEST_P(Limits, ThatADriverDoesNotTellAreNamed) {
    for (const bool memory : {false, true}) {
        opencl_faults().says_limits = false;
        std::uint64_t& limit = memory ? opencl_faults().memory : opencl_faults().largest_buffer;
        for (const LargeFrame& frame : some_frames()) {
            shrink(limit, memory ? 16384 * kib : 7600 * kib, 400 * kib, frame);
            if (HasFailure()) return;
        }
    }
    report();
    EXPECT_GT(refused_, 10);
    expect_said({&purpose::strokes, &purpose::depth});
}

TEST_P(Limits, OfWorkGroupsAreWorkedAround) {
    for (const LargeFrame& frame : some_frames()) {
        const Picture expected = use(frame);
        for (const std::size_t group : {48, 1}) {
            for (const bool says : {true, false}) {
                opencl_faults().largest_group = group;
                opencl_faults().says_limits = says;
                const Picture seen = draw(*make_renderer(), frame.options);
                opencl_faults().reset();
                EXPECT_LE(compare_bytes(expected, seen).share(), 1e-3) << group;
            }
        }
    }
}

TEST_P(Limits, LeaveAModelThatCannotMoveWhereItWas) {
    const FrameOptions options;
    const std::unique_ptr<Renderer> renderer = make_renderer();
    const Picture expected = draw(*renderer, options);
    const std::vector<glm::mat4> upside_down(std::max<std::size_t>(lines_.objects.size(), 1),
                                             glm::mat4{glm::mat3{-1}});
    opencl_faults().memory = opencl_faults().allocated + 1;
    EXPECT_THROW(renderer->set_transforms(upside_down), DeviceError);
    EXPECT_THROW(renderer->set_positions(0, lines_.vertices), DeviceError);
    opencl_faults().memory = 0;
    EXPECT_EQ(draw(*renderer, options), expected);
    renderer->set_transforms(upside_down);
    EXPECT_NE(draw(*renderer, options), expected);
}

INSTANTIATE_TEST_SUITE_P(Modes, Limits, testing::Values("copy", "host-pointer"), mode_name);

/// Limits of GL, which do not depend on the mode.
class GlLimits : public Limits {};

TEST_P(GlLimits, OfMemoryAreNamed) {
    for (const LargeFrame& frame : some_frames()) {
        shrink(gl_faults().largest_allocation, 16384 * kib, 400 * kib, frame);
        if (HasFailure()) return;
    }
    report();
    EXPECT_GT(drawn_, 5);
    expect_said({&purpose::strokes, &purpose::depth});
}

/// The renderer exists before the limit, so that objects of a frame are too large, not its own.
TEST_P(GlLimits, OfMemoryInTheMiddleOfAFrameAreNamed) {
    for (const LargeFrame& frame : large_frames()) {
        const Picture expected = use(frame);
        const long live = gl_faults().live;
        for (long bytes = 4096 * kib; bytes > 16; bytes /= 16) {
            SCOPED_TRACE(bytes);
            std::unique_ptr<Renderer> renderer = make_renderer();
            gl_faults().largest_allocation = bytes;
            count(expected, try_draw(*renderer, frame.options), static_cast<std::uint64_t>(bytes));
            gl_faults().largest_allocation = 0;
            EXPECT_EQ(draw(*renderer, frame.options), expected);
            renderer.reset();
            EXPECT_EQ(gl_faults().live, live);
            if (HasFailure()) return;
        }
    }
    report();
    expect_said(
        {&purpose::atlas, &purpose::depth, &purpose::item_buffer, &purpose::spine, &purpose::pen});
}

TEST_P(GlLimits, AFillByGlGivesItsMemoryBackToTheNextFrameWithoutOne) {
    const std::unique_ptr<Renderer> renderer = make_renderer();
    FrameOptions options{.method = Method::opengl};
    const auto live_after = [&](FillMode mode) {
        options.style.fill.mode = mode;
        draw(*renderer, options);
        return gl_faults().live;
    };
    live_after(FillMode::none);
    const long with_fill = live_after(FillMode::flat);
    EXPECT_LT(live_after(FillMode::none), with_fill);
    EXPECT_EQ(live_after(FillMode::flat), with_fill);
}

TEST_P(GlLimits, OfTheSidesOfTexturesAreWorkedAroundOrNamed) {
    FrameOptions effects = all_effects(Method::atlas);
    effects.intervals = KeptIntervals::none; // intervals need depth that tiles lack
    effects.style.pen.mark = "solid";        // others are textures of 1024 texels
    effects.style.hidden_pen.mark = "solid";
    effects.style.paper.grain = 0;
    for (const FrameOptions& options :
         {effects, FrameOptions{}, FrameOptions{.method = Method::spine},
          FrameOptions{.method = Method::item_buffer},
          FrameOptions{.forms = {.atlas = StageForm::raster}}}) {
        shrink(gl_faults().largest_side, 600, 20, {"clevis", {160, 120}, options}, 2.0 / 3);
    }
    report();
    EXPECT_GT(drawn_, 15);
    EXPECT_GT(tiled_, 5);
    expect_said({&purpose::whole_picture, &purpose::depth});
}

TEST_P(GlLimits, OfBufferTexturesAreWorkedAroundOrNamed) {
    for (const LargeFrame& frame : large_frames()) {
        shrink(gl_faults().largest_buffer_texture, 1U << 20U, 4096, frame);
        if (HasFailure()) return;
    }
    LineSet coloured = lines_;
    coloured.colors = {{1, 0, 0}};
    coloured.triangle_color.assign(coloured.triangles.size(), 0);
    gl_faults().largest_buffer_texture = static_cast<int>(coloured.triangles.size()) - 1;
    EXPECT_TRUE(try_draw(*make_renderer(), {.method = Method::spine}).empty());
    FrameOptions fill{.method = Method::opengl};
    fill.style.fill.mode = FillMode::flat;
    const std::unique_ptr<Renderer> renderer = make_renderer();
    renderer->set_lines(coloured);
    EXPECT_TRUE(try_draw(*renderer, fill).empty());
    report();
    expect_said({&purpose::atlas, &purpose::fill, &purpose::depth, &purpose::density});
}

/// A hardware GL draws the atlas. If the atlas has too many rows for GL, kernels draw it.
TEST_P(GlLimits, OfTheAtlasInRasterAreWorkedAroundByKernels) {
    FrameOptions options{.depth_scale = 1, .step = 1, .cull_hidden = false, .steady = false};
    options.forms.depth = StageForm::raster;   // `automatic` depends on the GL
    options.forms.strokes = StageForm::raster; // the same
    options.forms.atlas = StageForm::compute;
    const Picture expected = use({"house", {100, 75}, options});
    gl_faults().renderer = "a GPU";
    gl_faults().largest_side = 128;
    options.forms.atlas = StageForm::automatic;
    const std::unique_ptr<Renderer> renderer = make_renderer();
    EXPECT_EQ(draw(*renderer, options), expected);
    // The atlas is large enough from the start.
    EXPECT_EQ(draw(*renderer, options), expected);
    options.forms.atlas = StageForm::raster;
    EXPECT_TRUE(try_draw(*renderer, options).empty());
    EXPECT_EQ(said_.size(), 1U);
    expect_said({&purpose::atlas});
}

INSTANTIATE_TEST_SUITE_P(Modes, GlLimits, testing::Values("copy"), mode_name);

TEST(ModelLimits, AreWhatGlCanCount) {
    EXPECT_NO_THROW(check_counts({0x7FFFFFFF, 715'827'882, 1'073'741'823}));
    for (const ModelCounts& counts : {ModelCounts{0x80000000, 1, 1},
                                      {1, 715'827'883, 1},
                                      {1, 1, 1'073'741'824},
                                      {1ULL << 33U, 1, 1}}) {
        EXPECT_THROW(check_counts(counts), DeviceError);
    }
}

TEST(Messages, NameSizesInKibAndMib) {
    EXPECT_EQ(written_bytes(512), "512 bytes");
    EXPECT_EQ(written_bytes(1536), "1.50 KiB");
    EXPECT_EQ(written_bytes(200 * kib * kib), "200 MiB");
    EXPECT_EQ(written_bytes(std::uint64_t{1} << 60U), "1048576 TiB");
    EXPECT_EQ(with_room_to_grow(100, 1000), 125U);
    EXPECT_EQ(with_room_to_grow(100, 110), 110U);
    EXPECT_EQ(with_room_to_grow(100, 50), 100U); // said when it is made
}

} // namespace
} // namespace lineatlas::test
