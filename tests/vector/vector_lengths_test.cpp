#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/path_share.hpp"
#include "sources/sources.hpp"
#include "vector/halos.hpp"
#include "vector/lengths.hpp"
#include "vector/pieces.hpp"
#include "vector/strips.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

using test::Cuts;
using test::flat_camera;
using test::Lines;

using Ends = std::vector<std::array<double, 2>>;

/// A strip of 100 pixels with visible strokes. Its ends are those of the path.
Strip strip_of(const Ends& visible, bool closed = false) {
    Strip strip{.closed = closed,
                .open_start = !closed,
                .open_end = !closed,
                .length = 100,
                .steps = {},
                .strokes = {}};
    for (const auto& [from, to] : visible) {
        Stroke stroke{
            .from = from, .to = to, .start_kind = LA_END_HIDDEN, .end_kind = LA_END_HIDDEN};
        if (!closed && from == 0) stroke.start_kind = LA_END_PATH;
        if (!closed && to == 100) stroke.end_kind = LA_END_PATH;
        strip.strokes.push_back(stroke);
    }
    return strip;
}

void expect_visible(const Strip& strip, const Ends& expected) {
    std::vector<Stroke> visible;
    for (const Stroke& stroke : strip.strokes) {
        if (stroke.visible) visible.push_back(stroke);
    }
    ASSERT_EQ(visible.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_NEAR(visible[i].from, expected[i][0], 1e-4) << i;
        EXPECT_NEAR(visible[i].to, expected[i][1], 1e-4) << i;
    }
}

void expect_filtered(const Ends& visible, const StrokeFilter& filter, const Ends& expected,
                     const std::vector<Cut>& cuts = {}, bool closed = false) {
    Strip strip = strip_of(visible, closed);
    filter_lengths(strip, filter, cuts, crumb_of_samples);
    expect_visible(strip, expected);
}

TEST(Lengths, ShortHolesAreClosedAndShortStrokesDropped) {
    const Ends visible{{0, 20}, {23, 40}, {50, 52}, {60, 100}};
    expect_filtered(visible, {.fill_holes = 4}, {{0, 40}, {50, 52}, {60, 100}});
    expect_filtered(visible, {.drop_runs = 5}, {{0, 20}, {23, 40}, {60, 100}});
    expect_filtered(visible, {.fill_holes = 9, .drop_runs = 5}, {{0, 40}, {50, 100}});
    expect_filtered({{0, 3}}, {.drop_runs = 5}, {});
}

TEST(Lengths, AStrokeThatThePictureCutsIsNotShort) {
    Strip strip = strip_of({{0, 3}});
    strip.strokes[0].start_kind = LA_END_CLIPPED;
    filter_lengths(strip, {.drop_runs = 5}, {}, crumb_of_samples);
    expect_visible(strip, {{0, 3}});
}

TEST(Lengths, StrokesOvershootAndFallShort) {
    const Ends visible{{0, 30}, {60, 100}};
    expect_filtered(visible, {.overshoot = 5}, {{-5, 35}, {55, 105}});
    expect_filtered(visible, {.undershoot = 2}, {{0, 28}, {62, 100}});
    expect_filtered(visible, {.overshoot = 5, .undershoot = 2}, {{-5, 33}, {57, 105}});
    expect_filtered({{20, 30}, {38, 60}}, {.overshoot = 5}, {{15, 65}}); // they meet
}

TEST(Lengths, CrumbsOvershootLess) {
    expect_filtered({{20, 24}}, {.overshoot = 8}, {{18, 26}}); // 4 * 4 / 8
    Strip faint = strip_of({{20, 40}});
    faint.strokes[0].alpha = 1.0F / 6; // drawn at half its opacity
    filter_lengths(faint, {.overshoot = 8}, {}, crumb_of_samples);
    expect_visible(faint, {{18, 42}});
}

TEST(Lengths, TheOvershootOfAPathVariesAsInTheKernel) {
    for (const std::uint32_t path : {0U, 1U, 17U, 123456U}) {
        Strip strip = strip_of({{20, 60}});
        strip.path = path;
        filter_lengths(strip, {.overshoot = 10, .overshoot_variation = 0.5F}, {}, crumb_of_samples);
        const double grown = 10 * (1 - 0.5 * static_cast<double>(path_share(path)));
        expect_visible(strip, {{20 - grown, 60 + grown}});
    }
    // The same constants, in the same order.
    const std::string kernel = kernel_source("filter.cl");
    for (const char* line : {"path * 0x9E3779B1u", "h ^= h >> 16", "h *= 0x85EBCA6Bu",
                             "h ^= h >> 13", "(float)(h >> 8) * (1.0f / 16777216.0f)"}) {
        EXPECT_NE(kernel.find(line), std::string::npos) << line;
    }
    EXPECT_EQ(path_share(0), 0);
    EXPECT_NE(path_share(1), path_share(2));
}

TEST(Lengths, ClosedStripsGoOnAcrossTheirSeam) {
    expect_filtered({{0, 100}}, {.overshoot = 5}, {{0, 100}}, {}, true);
    expect_filtered({{2, 98}}, {.fill_holes = 5}, {{0, 100}}, {}, true);
    expect_filtered({{0, 30}, {60, 100}}, {.overshoot = 5}, {{0, 35}, {55, 100}}, {}, true);
    expect_filtered({{2, 98}}, {.overshoot = 5}, {{0, 100}}, {}, true); // to the middle
    expect_filtered({{2, 3}, {90, 99}}, {.drop_runs = 5}, {{90, 99}}, {}, true);
}

TEST(Lengths, OnlyAPathThatEndsThereIsLongerThanItsStrip) {
    Strip strip = strip_of({{2, 98}});
    strip.open_start = false;
    filter_lengths(strip, {.overshoot = 5}, {}, crumb_of_samples);
    expect_visible(strip, {{0, 103}});
}

TEST(Lengths, GapsAreCutAndNotOvershot) {
    expect_filtered({{0, 100}}, {}, {{0, 40}, {46, 100}}, {{40, 46}});
    expect_filtered({{0, 100}}, {}, {{0, 40}, {48, 100}}, {{40, 46}, {44, 48}});
    expect_filtered({{0, 50}}, {.overshoot = 10}, {{-10, 53}}, {{53, 58}});
    expect_filtered({{0, 50}}, {.overshoot = 10}, {{-10, 48}}, {{48, 58}});
    expect_filtered({{0, 50}}, {.drop_runs = 4}, {{0, 44}}, {{44, 47}}); // 3 are left
}

TEST(Lengths, HiddenStrokesStay) {
    Strip strip = strip_of({{0, 50}});
    strip.strokes.push_back({.from = 50, .to = 100, .visible = false});
    filter_lengths(strip, {.drop_runs = 60}, {}, crumb_of_samples);
    ASSERT_EQ(strip.strokes.size(), 1U);
    EXPECT_FALSE(strip.strokes[0].visible);
}

/// The cuts in a level line at depth 0.8 from x = 20 to 180 by a line through (100, 50).
std::vector<Cut> halo_of(float depth, glm::vec2 direction, float reach = 40) {
    Lines lines;
    lines.add(LineKind::crease, {{20, 50, 0.8F}, {180, 50, 0.8F}});
    const glm::vec2 a = glm::vec2{100, 50} - reach * direction;
    const glm::vec2 b = glm::vec2{100, 50} + 40.0F * direction;
    lines.add(LineKind::crease, {{a.x, a.y, depth}, {b.x, b.y, depth}});
    Cuts cuts{lines.set, flat_camera()};
    cuts.add_all();
    const Pieces pieces = make_pieces(lines.set, flat_camera(), cuts.intervals);
    return find_halos(lines.set, pieces, make_strips(lines.set, pieces), {200, 100},
                      {.width = 4, .tolerance = 0.01})[0];
}

TEST(Halos, NearerLinesLeaveAGap) {
    const std::vector<Cut> upright = halo_of(0.2F, {0, 1});
    ASSERT_EQ(upright.size(), 1U);
    EXPECT_NEAR(upright[0].from, 76, 1e-3);
    EXPECT_NEAR(upright[0].to, 84, 1e-3);
    const std::vector<Cut> slanted = halo_of(0.2F, {0.8F, 0.6F});
    ASSERT_EQ(slanted.size(), 1U);
    EXPECT_NEAR(slanted[0].to - slanted[0].from, 8 / 0.6, 1e-3);
    EXPECT_TRUE(halo_of(0.9F, {0, 1}).empty());
    EXPECT_TRUE(halo_of(0.79F, {0, 1}).empty()) << "within the tolerance";
}

TEST(Halos, ReachALittleBeyondTheNearerLine) {
    EXPECT_EQ(halo_of(0.2F, {0, 1}, -0.9F).size(), 1U);
    EXPECT_TRUE(halo_of(0.2F, {0, 1}, -1.1F).empty());
}

} // namespace
} // namespace lineatlas
