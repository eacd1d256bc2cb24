// The item buffer methods, tested by scenes with known visibility and against the segment atlas.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glm/ext/matrix_clip_space.hpp>
#include <gtest/gtest.h>

#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/renderer.hpp"
#include "scene_cameras.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 canvas_size{200, 150};
constexpr LineKindMask file_lines = mask_of(LineKind::file);

/// One unit is one pixel, the origin is the lower left, z runs from 50 (near) to -50.
Camera pixel_camera() {
    Camera camera;
    camera.projection = glm::ortho(0.0F, static_cast<float>(canvas_size.x), 0.0F,
                                   static_cast<float>(canvas_size.y), -50.0F, 50.0F);
    camera.size = canvas_size;
    return camera;
}

FrameOptions item_buffer(bool high) {
    return {.method = Method::item_buffer, .probes = high ? 9U : 1U, .lines = file_lines};
}

void add_line(Mesh& mesh, glm::vec3 p, glm::vec3 q) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {p, q});
    mesh.polylines.push_back({first, first + 1});
}

/// An upright box between two corners.
void add_box(Mesh& mesh, glm::vec3 low, glm::vec3 high) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (unsigned i = 0; i < 8; ++i) {
        mesh.positions.emplace_back((i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y,
                                    (i & 4U) != 0 ? high.z : low.z);
    }
    for (const glm::uvec4 side : {glm::uvec4{0, 2, 3, 1},
                                  {4, 5, 7, 6},
                                  {0, 1, 5, 4},
                                  {2, 6, 7, 3},
                                  {0, 4, 6, 2},
                                  {1, 3, 7, 5}}) {
        const glm::uvec4 corner = side + first;
        mesh.triangles.emplace_back(corner.x, corner.y, corner.z);
        mesh.triangles.emplace_back(corner.x, corner.z, corner.w);
    }
}

class ItemBuffer : public testing::Test {
  protected:
    Renderer::Samples draw(const LineSet& lines, const Camera& camera,
                           const FrameOptions& options) {
        renderer_.set_lines(lines);
        canvas_.clear(glm::vec4{1});
        stats_ = renderer_.draw(camera, options, canvas_.framebuffer());
        return renderer_.read_samples();
    }
    Renderer::Samples draw(const Mesh& mesh, const FrameOptions& options) {
        return draw(extract_lines(mesh, {.lines = file_lines}), pixel_camera(), options);
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{canvas_size};
    Renderer renderer_{DeviceOptions{}};
    FrameStats stats_;
};

class BothQualities : public ItemBuffer, public testing::WithParamInterface<bool> {};

/// Mean visibility, 0 to 1.
double mean(std::span<const std::uint8_t> alpha) {
    double sum = 0;
    for (const std::uint8_t a : alpha) sum += a;
    return sum / 255 / static_cast<double>(alpha.size());
}

TEST_P(BothQualities, ALineBeforeABoxIsVisible) {
    Mesh mesh;
    add_box(mesh, {40, 30, -10}, {160, 120, 10});
    add_line(mesh, {20.3F, 40.2F, 20}, {180.7F, 110.6F, 20});
    const Renderer::Samples samples = draw(mesh, item_buffer(GetParam()));
    ASSERT_GT(samples.alpha.size(), 80U);
    EXPECT_EQ(std::ranges::count(samples.alpha, 255), std::ssize(samples.alpha));
}

TEST_P(BothQualities, ALineOnItsBoxIsVisible) {
    Mesh mesh;
    add_box(mesh, {40, 30, -10}, {160, 120, 10});
    add_line(mesh, {50.3F, 40.2F, 10}, {150.7F, 110.6F, 10});
    const Renderer::Samples samples = draw(mesh, item_buffer(GetParam()));
    EXPECT_EQ(std::ranges::count(samples.alpha, 255), std::ssize(samples.alpha));
}

TEST_P(BothQualities, ALineBehindABoxIsHidden) {
    Mesh mesh;
    add_box(mesh, {40, 30, -10}, {160, 120, 10});
    add_line(mesh, {50, 40, -20}, {150, 110, -20});
    const Renderer::Samples samples = draw(mesh, item_buffer(GetParam()));
    ASSERT_GT(samples.alpha.size(), 50U);
    EXPECT_EQ(std::ranges::count(samples.alpha, 0), std::ssize(samples.alpha));
    EXPECT_EQ(stats_.runs, 0U);
}

TEST_P(BothQualities, ALineHalfBehindABoxIsHalfVisible) {
    for (const glm::vec3 end : {glm::vec3{180.2F, 75.4F, -20}, {170.1F, 140.3F, -20}}) {
        Mesh mesh;
        add_box(mesh, {100, 0, -10}, {200, 150, 10});
        const glm::vec3 middle{100, 75.4F, -20};
        add_line(mesh, middle * 2.0F - end * glm::vec3{1, 1, 0} + glm::vec3{0, 0, 20}, end);
        for (const bool backwards : {false, true}) {
            if (backwards) std::swap(mesh.positions[8], mesh.positions[9]);
            Renderer::Samples samples = draw(mesh, item_buffer(GetParam()));
            if (backwards) std::ranges::reverse(samples.alpha);
            const auto half = static_cast<std::ptrdiff_t>(samples.alpha.size() / 2);
            const std::span alpha{samples.alpha};
            // Two samples are four pixels.
            EXPECT_EQ(mean(alpha.first(static_cast<std::size_t>(half - 2))), 1.0);
            EXPECT_EQ(mean(alpha.subspan(static_cast<std::size_t>(half + 2))), 0.0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Quality, BothQualities, testing::Values(false, true),
                         [](const auto& info) { return info.param ? "high" : "low"; });

/// Two lines that share texels around (100, 75) for some way. The second one is nearer.
Mesh crossing_lines() {
    Mesh mesh;
    add_line(mesh, {40.2F, 75.4F, -20}, {160.2F, 75.4F, -20});
    add_line(mesh, {40.2F, 70.4F, 20}, {160.2F, 80.4F, 20});
    return mesh;
}

TEST_F(ItemBuffer, OfTwoCrossingLinesTheNearOneWinsAtLow) {
    const Mesh mesh = crossing_lines();
    const LineSet lines = extract_lines(mesh, {.lines = file_lines});
    const Renderer::Samples samples = draw(lines, pixel_camera(), item_buffer(false));
    ASSERT_EQ(samples.offsets.size(), 3U);
    for (std::size_t i = 0; i < 2; ++i) {
        const std::span alpha = std::span{samples.alpha}.subspan(
            samples.offsets[i], samples.offsets[i + 1] - samples.offsets[i]);
        const bool near = lines.vertices[lines.segments[i].p].z > 0;
        const auto hidden = std::ranges::count(alpha, 0);
        if (near) {
            EXPECT_EQ(hidden, 0);
        } else {
            EXPECT_GE(hidden, 2);
            EXPECT_LE(hidden, 20);
        }
    }
}

TEST_F(ItemBuffer, OfTwoCrossingLinesBothAreVisibleAtHigh) {
    const Renderer::Samples samples = draw(crossing_lines(), item_buffer(true));
    EXPECT_EQ(std::ranges::count(samples.alpha, 255), std::ssize(samples.alpha));
}

TEST_F(ItemBuffer, OnlyThreeLinesFitIntoATexel) {
    Mesh mesh;
    for (const float z : {-20.0F, -10.0F, 0.0F, 10.0F}) {
        add_line(mesh, {40.2F, 75.4F, z}, {160.2F, 75.4F, z});
    }
    EXPECT_NEAR(mean(draw(mesh, item_buffer(true)).alpha), 0.75, 0.01);
    EXPECT_NEAR(mean(draw(mesh, item_buffer(false)).alpha), 0.25, 0.01);
}

TEST_F(ItemBuffer, APartlyHiddenLineIsPartlyVisibleAtHigh) {
    // The box covers the lower third of every pixel of the line.
    Mesh mesh;
    add_box(mesh, {-10, -10, -10}, {210, 75.34F, 10});
    add_line(mesh, {20.3F, 75.5F, -20}, {180.7F, 75.5F, -20});
    const Renderer::Samples high = draw(mesh, item_buffer(true));
    for (const std::uint8_t a : high.alpha) EXPECT_NEAR(a, 170, 1);
    const Renderer::Samples low = draw(mesh, item_buffer(false));
    for (const std::uint8_t a : low.alpha) EXPECT_TRUE(a == 0 || a == 255);
}

TEST_F(ItemBuffer, AnEmptyLineSetDrawsNothing) {
    for (const bool high : {false, true}) {
        EXPECT_TRUE(draw(Mesh{}, item_buffer(high)).alpha.empty());
        Mesh box;
        add_box(box, {40, 30, -10}, {160, 120, 10});
        // The box has no line of a wanted kind.
        EXPECT_TRUE(draw(box, item_buffer(high)).alpha.empty());
        EXPECT_EQ(stats_.runs, 0U);
    }
}

TEST_F(ItemBuffer, EveryDirectionIsFoundWhole) {
    for (const bool high : {false, true}) {
        for (int degrees = 0; degrees < 360; degrees += 7) {
            SCOPED_TRACE(degrees);
            const float angle = glm::radians(static_cast<float>(degrees));
            Mesh mesh;
            const glm::vec3 middle{100.3F, 75.1F, 0};
            const glm::vec3 d{std::cos(angle), std::sin(angle), 0};
            add_line(mesh, middle + d * 5.0F, middle + d * 60.0F);
            const Renderer::Samples samples = draw(mesh, item_buffer(high));
            EXPECT_EQ(std::ranges::count(samples.alpha, 255), std::ssize(samples.alpha))
                << (high ? "high" : "low") << ", the first "
                << static_cast<int>(samples.alpha.front()) << ", the last "
                << static_cast<int>(samples.alpha.back());
        }
    }
}

TEST_F(ItemBuffer, ALineShorterThanAPixelIsVisible) {
    for (const bool high : {false, true}) {
        for (int i = 0; i < 20; ++i) {
            SCOPED_TRACE(i);
            const float place = 50 + 0.05F * static_cast<float>(i);
            Mesh mesh; // two segments, because a single one would be dropped
            mesh.positions = {{place, 40.3F, 0}, {place + 0.2F, 40.4F, 0}, {place + 30, 40.4F, 0}};
            mesh.polylines = {{0, 1, 2}};
            const Renderer::Samples samples = draw(mesh, item_buffer(high));
            ASSERT_EQ(samples.offsets.size(), 3U);
            EXPECT_GE(mean(samples.alpha), high ? 1.0 : 0.8);
        }
    }
}

TEST_F(ItemBuffer, AgreesWithTheSegmentAtlasOnAModel) {
    const LineSet& lines = scene_lines("clevis");
    for (const NamedCamera& view : scene_cameras("clevis", {400, 300})) {
        for (const bool high : {false, true}) {
            SCOPED_TRACE(view.name + (high ? " high" : " low"));
            FrameOptions options{
                .probes = high ? 9U : 1U, .depth_scale = high ? 2 : 1, .cull_hidden = false};
            const Renderer::Samples atlas = draw(lines, view.camera, options);
            options.method = Method::item_buffer;
            const Renderer::Samples item = draw(lines, view.camera, options);
            ASSERT_EQ(item.offsets, atlas.offsets);
            ASSERT_GT(item.runs.size(), 0U);
            std::size_t close = 0;
            for (std::size_t i = 0; i < item.alpha.size(); ++i) {
                close += std::abs(item.alpha[i] - atlas.alpha[i]) <= 128 ? 1U : 0U;
            }
            const double share =
                static_cast<double>(close) / static_cast<double>(item.alpha.size());
            EXPECT_GE(share, 0.9);
            RecordProperty("agreement " + view.name, std::to_string(share));
        }
    }
}

} // namespace
} // namespace lineatlas::test
