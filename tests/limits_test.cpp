// Devices that are too small: what is drawn nevertheless, and what is said where nothing can be.
#include <algorithm>
#include <array>
#include <iostream>
#include <map>

#include "compare.hpp"
#include "core/limits.hpp"
#include "core/tiles.hpp"
#include "fault_support.hpp"
#include "renderer/model_limits.hpp"

namespace lineatlas::test {
namespace {

constexpr std::uint64_t kib = 1024;

/// What a message must say is short.
using Words = std::vector<std::string_view>;

class Limits : public FaultFixture {
  protected:
    /// A picture, by tiles where it must be; empty if the device is too small, which was then said.
    Picture try_draw(Renderer& renderer, const FrameOptions& options) {
        try {
            const int tile = renderer.tile_size(fault_size, options);
            return tile == 0 ? draw(renderer, options) : draw_tiles(renderer, options, tile);
        } catch (const Error& error) {
            note(error.what());
            return {};
        }
    }

    Picture draw_tiles(Renderer& renderer, const FrameOptions& options, int tile_size) {
        const gl::Canvas canvas{glm::min(fault_size, tile_size)};
        Picture picture(std::size_t{4} * fault_size.x * fault_size.y);
        const auto begin = [&](const PictureTile&) {
            const std::array<float, 4> white{1, 1, 1, 1};
            glClearNamedFramebufferfv(canvas.framebuffer(), GL_COLOR, 0, white.data());
        };
        const auto end = [&](const PictureTile& tile) {
            const Picture part = canvas.read(tile.size);
            const int top = fault_size.y - tile.low.y - tile.size.y;
            for (int y = 0; y < tile.size.y; ++y) {
                std::copy_n(part.begin() + std::ptrdiff_t{4} * tile.size.x * y, 4 * tile.size.x,
                            picture.begin() +
                                std::ptrdiff_t{4} * ((top + y) * fault_size.x + tile.low.x));
            }
        };
        renderer.draw_tiles(camera_, options, {canvas.framebuffer(), tile_size, begin, end});
        return picture;
    }

    /// A message about a limit: what needs how much, what there is, and what helps.
    void note(const std::string& message) {
        const std::size_t needs = message.find(" needs "), there_is = message.find(", and "),
                          help = message.find("; use ");
        EXPECT_TRUE(needs < there_is && there_is < help && help != std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        const std::size_t device = message.find(" cannot share "); // before the cause
        const std::size_t what = device < needs ? message.find(": ", device) + 2 : 0;
        if (++said_[message.substr(what, needs - what)] == 1) std::cout << message << "\n";
    }

    void expect_said(const Words& words) const {
        for (const std::string_view word : words) {
            EXPECT_TRUE(said_.contains(std::string{word})) << "nothing was said of " << word;
        }
    }

    static void expect_same(const Picture& expected, const Picture& seen, std::uint64_t limit) {
        ASSERT_EQ(expected.size(), seen.size());
        EXPECT_LE(compare_bytes(expected, seen).share(), 1e-3) << "limit " << limit;
    }

    /// Draws with ever less: each frame is the one of a large device, or ends in a message with
    /// all released; then the same renderer goes on as soon as it can.
    void shrink(std::uint64_t& limit, std::uint64_t most, std::uint64_t least,
                const FrameOptions& options) {
        const Picture expected = draw(*make_renderer(), options);
        const long live_gl = gl_faults().live;
        const ClCounts live_cl = opencl_faults().references;
        for (std::uint64_t value = most; value >= least; value = value * 2 / 3) {
            limit = value;
            try {
                const std::unique_ptr<Renderer> renderer = make_renderer();
                const Picture picture = try_draw(*renderer, options);
                if (!picture.empty()) {
                    expect_same(expected, picture, value);
                    ++drawn_;
                } else {
                    ++refused_;
                }
                limit = 0;
                EXPECT_EQ(try_draw(*renderer, options).empty(),
                          renderer_keeps_limits_ && picture.empty())
                    << "limit " << value;
            } catch (const Error& error) { // of a renderer without a frame
                ++refused_;
                note(error.what());
            }
            limit = 0;
            EXPECT_EQ(gl_faults().live, live_gl) << "limit " << value;
            EXPECT_EQ(opencl_faults().references, live_cl) << "limit " << value;
            EXPECT_EQ(gl_faults().beyond, 0) << "limit " << value;
            if (HasFailure()) return;
        }
    }

    void report() const {
        std::cout << drawn_ << " frames were drawn, " << refused_ << " refused:";
        for (const auto& [what, count] : said_) std::cout << " " << count << " " << what << ",";
        std::cout << "\n";
    }

    std::map<std::string, int> said_;
    int drawn_ = 0, refused_ = 0;
    bool renderer_keeps_limits_ = false;
};

/// Frames that have one table each that is larger than all others.
std::vector<FrameOptions> large_frames() {
    std::vector<FrameOptions> frames{all_effects(Method::atlas)};
    frames.push_back({.depth_scale = 4});
    frames.push_back({.step = 0.02F, .steady = false});
    frames.push_back({.step = 0.02F});
    frames.push_back({.method = Method::item_buffer});
    frames.push_back({.method = Method::spine});
    frames.push_back({.method = Method::opengl});
    return frames;
}

TEST_P(Limits, OfABufferAreSaidOrPassed) {
    renderer_keeps_limits_ = true; // it has asked when it was made
    for (const FrameOptions& options : large_frames()) {
        shrink(opencl_faults().largest_buffer, 4096 * kib, 16 * kib, options);
        if (HasFailure()) return;
    }
    report();
    EXPECT_GT(drawn_, 20);
    EXPECT_GT(refused_, 20);
    expect_said({"the segment atlas", "the table of strokes", "the depth buffer"});
}

TEST_P(Limits, OfADevicesMemoryAreSaidOrPassed) {
    renderer_keeps_limits_ = true;
    for (const FrameOptions& options : large_frames()) {
        shrink(opencl_faults().memory, 16384 * kib, 64 * kib, options);
        if (HasFailure()) return;
    }
    report();
    EXPECT_GT(drawn_, 20);
    EXPECT_GT(refused_, 20);
    expect_said({"the segment atlas", "the table of strokes", "the depth buffer"});
}

TEST_P(Limits, ThatADriverKeepsToItselfAreSaid) {
    for (const bool memory : {false, true}) {
        opencl_faults().says_limits = false;
        std::uint64_t& limit = memory ? opencl_faults().memory : opencl_faults().largest_buffer;
        for (const FrameOptions& options : large_frames()) {
            shrink(limit, memory ? 16384 * kib : 4096 * kib, 16 * kib, options);
            if (HasFailure()) return;
        }
    }
    report();
    EXPECT_GT(refused_, 20);
    expect_said({"the segment atlas", "the table of strokes", "the depth buffer"});
}

INSTANTIATE_TEST_SUITE_P(Modes, Limits, testing::Values("copy", "host-pointer"), mode_name);

/// Of GL: they do not depend on the mode.
class GlLimits : public Limits {};

TEST_P(GlLimits, OfMemoryAreSaid) {
    for (const FrameOptions& options : large_frames()) {
        const Picture expected = draw(*make_renderer(), options);
        const long live = gl_faults().live;
        for (long bytes = 4096 * kib; bytes > 16; bytes /= 3) {
            try {
                const std::unique_ptr<Renderer> renderer = make_renderer();
                gl_faults().largest_allocation = bytes;
                const Picture picture = try_draw(*renderer, options);
                gl_faults().largest_allocation = 0;
                if (!picture.empty()) expect_same(expected, picture, static_cast<unsigned>(bytes));
                ++(picture.empty() ? refused_ : drawn_);
                EXPECT_EQ(draw(*renderer, options), expected);
            } catch (const Error& error) {
                ADD_FAILURE() << error.what();
            }
            EXPECT_EQ(gl_faults().live, live);
            if (HasFailure()) return;
        }
    }
    report();
    expect_said({"the segment atlas", "the depth buffer", "the item buffer", "the spine test",
                 "the grain of paper", "the mark of a pen", "line density"});
}

TEST_P(GlLimits, OfTheSidesOfTexturesAreSaidOrPassed) {
    const FrameOptions effects = all_effects(Method::atlas);
    FrameOptions spine{.method = Method::spine}, items{.method = Method::item_buffer};
    for (const FrameOptions& options : {effects, FrameOptions{}, spine, items}) {
        FrameOptions still = options;
        still.intervals = KeptIntervals::none; // depth is not kept for tiles
        const Picture expected = draw(*make_renderer(), still);
        for (const int side : {400, 300, 200, 128, 100, 64}) {
            gl_faults().largest_side = side;
            const std::unique_ptr<Renderer> renderer = make_renderer();
            const Picture picture = try_draw(*renderer, still);
            if (!picture.empty()) expect_same(expected, picture, static_cast<unsigned>(side));
            ++(picture.empty() ? refused_ : drawn_);
            if (still.method == Method::atlas && side >= 200) EXPECT_FALSE(picture.empty()) << side;
            EXPECT_EQ(gl_faults().beyond, 0) << side;
            gl_faults().largest_side = 0;
            EXPECT_EQ(draw(*make_renderer(), still), expected);
        }
    }
    report();
    EXPECT_GT(drawn_, 12);
}

TEST_P(GlLimits, OfBufferTexturesAreSaidOrPassed) {
    LineSet coloured = lines_;
    coloured.colors = {{1, 0, 0}};
    coloured.triangle_color.assign(coloured.triangles.size(), 0);
    for (const FrameOptions& options : large_frames()) {
        const std::unique_ptr<Renderer> reference = make_renderer();
        reference->set_lines(coloured);
        const Picture expected = draw(*reference, options);
        for (const int texels : {1 << 20, 1 << 18, 1 << 16, 1 << 14, 1 << 12, 1 << 10, 256}) {
            gl_faults().largest_buffer_texture = texels;
            const std::unique_ptr<Renderer> renderer = make_renderer();
            renderer->set_lines(coloured);
            const Picture picture = try_draw(*renderer, options);
            if (!picture.empty()) expect_same(expected, picture, static_cast<unsigned>(texels));
            ++(picture.empty() ? refused_ : drawn_);
            EXPECT_EQ(gl_faults().beyond, 0) << texels;
            gl_faults().largest_buffer_texture = 0;
        }
    }
    report();
    expect_said({"the segment atlas", "the colours of the fill", "the spine test", "line density"});
}

/// GL that is not software draws the atlas; where it has too many rows for that, kernels do.
TEST_P(GlLimits, OfTheAtlasInRasterArePassedByKernels) {
    const FrameOptions options{.step = 0.05F, .steady = false};
    const Picture expected = draw(*make_renderer(), options);
    gl_faults().renderer = "a GPU";
    const std::unique_ptr<Renderer> renderer = make_renderer();
    FrameOptions raster = options;
    raster.depth_scale = 1;
    const Picture expected_raster = draw(*renderer, raster);
    gl_faults().largest_side = 4100; // of a row: 200 pixels in steps of 0.05
    raster.atlas = AtlasForm::raster;
    EXPECT_FALSE(draw(*make_renderer(), raster).empty());
    gl_faults().largest_side = 0;
    EXPECT_FALSE(expected.empty());
    EXPECT_FALSE(expected_raster.empty());
}

INSTANTIATE_TEST_SUITE_P(Modes, GlLimits, testing::Values("copy"), mode_name);

TEST(ModelLimits, AreWhatGlCanCount) {
    EXPECT_NO_THROW(check_counts({100, 100, 100}));
    EXPECT_NO_THROW(check_counts({0x7FFFFFFF, 715'827'882, 1'073'741'823}));
    for (const ModelCounts& counts : {ModelCounts{0x80000000, 1, 1},
                                      {1, 715'827'883, 1},
                                      {1, 1, 1'073'741'824},
                                      {1ULL << 33U, 1, 1}}) {
        EXPECT_THROW(check_counts(counts), DeviceError);
    }
}

TEST(Messages, NameSizesAsPeopleDo) {
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
