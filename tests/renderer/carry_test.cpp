// Textures of silhouettes keep their places on the surface while the picture moves.

#include <algorithm>
#include <cmath>
#include <map>

#include "compare.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/compute_device.hpp"
#include "lineatlas/renderer.hpp"
#include "test_meshes.hpp"

namespace lineatlas::test {
namespace {

/// A silhouette that is visible from end to end: its texture coordinates at the ends, and its
/// length.
struct Drawn {
    float start, end, length;
};
using DrawnLines = std::map<std::uint32_t, Drawn>; ///< by segment

DrawnLines silhouettes_of(const LineSet& lines, const Renderer::Samples& samples) {
    DrawnLines result;
    for (const lineatlas::Run& run : samples.runs) {
        const bool whole =
            run.start_sample == 0 && run.end_sample == static_cast<float>(run.samples);
        const std::uint32_t kind = lines.segments[run.segment].tag & LA_TAG_KIND_MASK;
        if (!whole || kind != LA_KIND_SILHOUETTE) continue;
        const float length = std::hypot(run.end[0] - run.start[0], run.end[1] - run.start[1]);
        result[run.segment] = {run.start_arc, run.end_arc, length};
    }
    return result;
}

/// The share of silhouettes whose texture coordinate at the middle differs between the frames by
/// more than half a pixel. It is a share of the length of all silhouettes in both frames.
double crawling(const DrawnLines& before, const DrawnLines& now) {
    double crawls = 0, all = 0;
    for (const auto& [segment, drawn] : now) {
        const auto past = before.find(segment);
        if (past == before.end()) continue;
        const float shift =
            0.5F * ((drawn.start + drawn.end) - (past->second.start + past->second.end));
        all += drawn.length;
        if (std::abs(shift) >= 0.5F) crawls += drawn.length;
    }
    EXPECT_GT(all, 400) << "nothing was compared";
    return crawls / all;
}

/// Pixels of texture per pixel of silhouette.
double stretch(const DrawnLines& silhouettes) {
    double texture = 0, length = 0;
    for (const auto& [segment, drawn] : silhouettes) {
        texture += drawn.end - drawn.start;
        length += drawn.length;
    }
    return texture / length;
}

/// A slightly rough ball. Its silhouettes along edges zigzag.
class Carry : public testing::Test {
  protected:
    DrawnLines draw(Renderer& renderer, float pixels, const FrameOptions& options) {
        constexpr float radius = 200; // on the screen
        const float angle = pixels / radius;
        const Camera camera =
            make_camera({.eye = 2.7F * glm::vec3{std::sin(angle), 0, std::cos(angle)}},
                        canvas_.size(), lines_.bounds);
        renderer.draw(camera, options, canvas_.framebuffer());
        return silhouettes_of(lines_, renderer.read_samples());
    }
    /// The mean share that crawls while the picture moves.
    double mean_crawling(const FrameOptions& options, int frames) {
        Renderer renderer;
        renderer.set_lines(lines_);
        DrawnLines before = draw(renderer, 0, options);
        double sum = 0;
        for (int i = 1; i <= frames; ++i) {
            const DrawnLines now = draw(renderer, 0.4F * static_cast<float>(i), options);
            sum += crawling(before, now);
            before = now;
        }
        last_ = before;
        return sum / frames;
    }
    static LineSet ball(Silhouettes silhouettes) {
        Random random{3};
        return extract_lines(with_random_radii(sphere(6), random, 0.999F),
                             {.crease = 2.6F, .silhouettes = silhouettes});
    }
    static FrameOptions pencil(bool steady) {
        FrameOptions options{.steady = steady};
        options.style.pen.mark = "pencil";
        return options;
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{640, 480}};
    LineSet lines_ = ball(Silhouettes::mesh);
    DrawnLines last_;
};

TEST_F(Carry, TexturesHardlyCrawlInSlowMotion) {
    EXPECT_GT(mean_crawling(pencil(false), 4), 0.5);
    EXPECT_LT(mean_crawling(pencil(true), 40), 0.05);
}

TEST_F(Carry, TexturesOfSmoothSilhouettesHardlyCrawlEither) {
    lines_ = ball(Silhouettes::smooth);
    EXPECT_GT(mean_crawling(pencil(false), 4), 0.5);
    EXPECT_LT(mean_crawling(pencil(true), 20), 0.05);
}

TEST_F(Carry, TexturesDoNotStayStretched) {
    Renderer fresh;
    fresh.set_lines(lines_);
    const double at_first = stretch(draw(fresh, 20, pencil(true)));
    mean_crawling(pencil(true), 50);
    EXPECT_NEAR(stretch(last_) / at_first, 1, 0.1);
}

TEST_F(Carry, AStillPictureStaysTheSame) {
    Renderer renderer;
    renderer.set_lines(lines_);
    for (int i = 0; i < 6; ++i) draw(renderer, static_cast<float>(i), pencil(true));
    const DrawnLines before = draw(renderer, 6, pencil(true));
    const DrawnLines now = draw(renderer, 6, pencil(true));
    std::size_t compared = 0;
    for (const auto& [segment, drawn] : now) {
        if (!before.contains(segment)) continue; // visibility is not steady yet
        ++compared;
        EXPECT_EQ(drawn.start, before.at(segment).start);
        EXPECT_EQ(drawn.end, before.at(segment).end);
    }
    EXPECT_GT(compared, before.size() / 2);
}

TEST_F(Carry, PlainPensNeedNoMemoryForCarrying) {
    Renderer renderer;
    renderer.set_lines(lines_);
    const auto bytes = [&](const FrameOptions& options) {
        const Camera camera = make_camera({.eye = {0, 0, 2.7F}}, canvas_.size(), lines_.bounds);
        return renderer.draw(camera, options, canvas_.framebuffer()).segment_bytes;
    };
    const auto plain = bytes({});
    EXPECT_EQ(bytes({}), plain);
    EXPECT_GT(bytes(pencil(true)), plain);
}

TEST_F(Carry, EdgesThatAreNoSilhouettesTakeNoRoomAmongClippedLines) {
    // Nearly all segments are candidates, and a frame finds few silhouettes among them.
    ASSERT_GT(lines_.kind_counts[LA_KIND_SILHOUETTE], 0.9 * lines_.segments.size());
    Renderer renderer;
    renderer.set_lines(lines_);
    const Camera camera = make_camera({.eye = {0, 0, 2.7F}}, canvas_.size(), lines_.bounds);
    const FrameOptions options{.method = Method::atlas, .lines = mask_of(LineKind::silhouette)};
    renderer.draw(camera, options, canvas_.framebuffer());
    const std::vector<compute::TableMemory> tables = renderer.tables();
    const auto clipped = std::ranges::find(tables, "clipped segments", &compute::TableMemory::name);
    ASSERT_NE(clipped, tables.end());
    EXPECT_GT(clipped->bytes, 0U);
    EXPECT_LT(clipped->bytes, sizeof(ClippedSegment) * lines_.segments.size() / 4);
}

} // namespace
} // namespace lineatlas::test
