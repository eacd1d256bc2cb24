// Economies while the camera moves, on imitated machines with known times per picture.

#include <array>

#include <gtest/gtest.h>

#include "viewer/economy.hpp"
#include "viewer/long_lines.hpp"

namespace lineatlas::test {
namespace {

using viewer::Economy;
using viewer::Pace;

/// Seconds per picture for each economy.
using Machine = std::array<double, viewer::economies>;

/// Options with a pen's mark, halos and all else that an economy may leave out.
FrameOptions rich() {
    FrameOptions options;
    options.style.pen.mark = "charcoal";
    options.style.filter.halo = 4;
    return options;
}

double cost(const Machine& machine, Economy economy) {
    return machine.at(static_cast<std::size_t>(economy));
}

/// Draws pictures of a movement. Returns the economy of each.
std::vector<Economy> move(Pace& pace, const Machine& machine, int pictures,
                          const FrameOptions& options = rich()) {
    std::vector<Economy> all;
    for (int i = 0; i < pictures; ++i) {
        all.push_back(pace.choose(options, false));
        pace.note(all.back(), cost(machine, all.back()));
    }
    return all;
}

TEST(ViewerEconomy, NothingGivesWayWherePicturesAreFast) {
    Pace pace;
    pace.note(Economy::none, 0.3); // the first picture makes shaders and tables
    const Machine fast{0.01, 0.008, 0.007, 0.006, 0.004};
    const std::vector<Economy> drawn = move(pace, fast, 10);
    EXPECT_NE(drawn.front(), Economy::none) << "nobody could know";
    for (std::size_t i = 3; i < drawn.size(); ++i) EXPECT_EQ(drawn[i], Economy::none) << i;
}

TEST(ViewerEconomy, AsMuchAsIsNeededGivesWayFromTheFirstPictureOn) {
    Pace pace;
    pace.note(Economy::none, 1);
    pace.note(Economy::none, 0.1);
    const Machine slow{0.1, 0.055, 0.041, 0.035, 0.021};
    for (const Economy economy : move(pace, slow, 10)) EXPECT_EQ(economy, Economy::pixels);
    pace.note(Economy::none, 0.04);
    const Machine faster{0.04, 0.022, 0.02, 0.018, 0.01};
    for (const Economy economy : move(pace, faster, 10)) EXPECT_EQ(economy, Economy::samples);
}

TEST(ViewerEconomy, MeasuredSavingsCount) {
    Pace pace;
    pace.note(Economy::none, 1);
    // On this machine to leave out marks saves nearly all time, which cannot be known before.
    const Machine machine{0.2, 0.19, 0.18, 0.02, 0.012};
    for (int i = 0; i < 3; ++i) {
        pace.note(Economy::none, 0.2);
        move(pace, machine, 30);
    }
    pace.note(Economy::none, 0.2);
    for (const Economy economy : move(pace, machine, 30)) {
        EXPECT_LE(cost(machine, economy), Pace::longest);
        EXPECT_EQ(economy, Economy::marks);
    }
}

TEST(ViewerEconomy, EffectsThatAreNotDrawnCannotGiveWay) {
    Pace pace;
    pace.note(Economy::none, 1);
    pace.note(Economy::none, 0.05);
    const FrameOptions plain{.probes = 1, .depth_scale = 1};
    const Machine machine{0.05, 0.05, 0.05, 0.05, 0.03};
    for (const Economy economy : move(pace, machine, 10, plain))
        EXPECT_EQ(economy, Economy::pixels) << "nothing else would save any time";
    pace.note(Economy::none, 0.08);
    pace.note(Economy::none, 0.08);
    EXPECT_TRUE(pace.falls_short()) << "half of the pixels may save 0.4 of it, other steps nothing";
    pace.choose(rich(), false);
    EXPECT_FALSE(pace.falls_short()) << "they may here";
}

TEST(ViewerEconomy, OneSlowPictureIsNoReason) {
    Pace pace;
    pace.note(Economy::none, 0.02);
    const Machine machine{0.02, 0.015, 0.014, 0.013, 0.01};
    move(pace, machine, 5);
    pace.note(Economy::none, 0.2);
    EXPECT_EQ(pace.choose(rich(), false), Economy::none);
    pace.note(Economy::none, 0.2);
    EXPECT_NE(pace.choose(rich(), false), Economy::none) << "two are";
}

TEST(ViewerEconomy, DetailsGoLastAndOnlyWhereTheyMay) {
    Pace pace;
    pace.note(Economy::none, 1);
    pace.note(Economy::none, 0.4);
    EXPECT_TRUE(pace.falls_short());
    EXPECT_EQ(pace.choose(rich(), false), Economy::pixels);
    EXPECT_EQ(pace.choose(rich(), true), Economy::details);
    pace.note(Economy::none, 0.1);
    pace.note(Economy::none, 0.1);
    EXPECT_FALSE(pace.falls_short());
    EXPECT_EQ(pace.choose(rich(), true), Economy::pixels);
}

/// A path of two segments from the origin to x = 1, a path a tenth as long, and an edge that may be
/// a silhouette.
LineSet two_paths() {
    LineSet lines;
    lines.vertices = {{0, 0, 0}, {0.5F, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1F, 1, 0}};
    const auto add = [&](la_uint p, la_uint q, la_uint path, la_uint kind) {
        lines.segments.push_back({p, q, LA_NO_FACE, LA_NO_FACE, 0, 0, path, kind});
        lines.sources.emplace_back();
        ++lines.kind_counts.at(kind);
    };
    add(0, 1, 0, LA_KIND_CREASE);
    add(1, 2, 0, LA_KIND_CREASE);
    add(3, 4, 1, LA_KIND_CREASE);
    add(3, 4, 2, LA_KIND_SILHOUETTE);
    return lines;
}

TEST(ViewerEconomy, ShortPathsAreLeftOutByTheirLengthInPixels) {
    const LineSet lines = two_paths();
    // Parallel lines of sight, and 100 pixels for a unit of length.
    Camera camera{.size = {400, 200}};
    const auto kept = [&](float pixels) {
        return viewer::long_lines(lines, camera, pixels).segments.size();
    };
    EXPECT_EQ(kept(9.9F), 4U);
    EXPECT_EQ(kept(10.1F), 3U);
    EXPECT_EQ(kept(99), 3U) << "a path counts as a whole";
    EXPECT_EQ(kept(101), 1U) << "what may be a silhouette stays";
    const LineSet left = viewer::long_lines(lines, camera, 50);
    EXPECT_EQ(left.kind_counts[LA_KIND_CREASE], 2U);
    EXPECT_EQ(left.sources.size(), 3U);
    // A perspective view from twice as far away, in which w is 2.
    camera.projection[3][3] = 2;
    EXPECT_EQ(kept(9.9F), 3U);
}

TEST(ViewerEconomy, LengthsStayWhatTheyAreInTheWindow) {
    FrameOptions options = rich();
    options.style.pen.width = 3;
    options.style.made_for = 400;
    save_time(options, Economy::pixels, {1600, 800});
    EXPECT_EQ(options.style.pen.width, 3) << "twice as long for 800 pixels, half for half of them";
    EXPECT_EQ(options.style.made_for, 0);
    EXPECT_EQ(options.style.pen.mark, "solid");
    EXPECT_EQ(options.probes, 1U);
}

} // namespace
} // namespace lineatlas::test
