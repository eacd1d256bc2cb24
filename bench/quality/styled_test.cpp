// The figures of styled drawings on lines whose figures are known by hand.

#include "shared/constants.h"
#include "styled.hpp"

#include <gtest/gtest.h>

namespace lineatlas::bench {
namespace {

using Runs = std::vector<Run>; // testing::Test has a Run of its own

constexpr glm::ivec2 viewport{400, 400};
constexpr std::uint32_t l = 100; // samples, over the middle 200 pixels of the viewport
constexpr std::size_t frame_count = 5;

ClippedLines line(float shift = 0) {
    ClippedSegment segment{};
    segment.p[0] = -0.5F + shift / 200;
    segment.q[0] = 0.5F + shift / 200;
    segment.p[3] = segment.q[3] = 1;
    segment.t1 = 1;
    return {{segment}, {0, l}};
}

LineSet one_segment() {
    LineSet lines;
    lines.segments.push_back({});
    return lines;
}

Run stroke(float from, float to) {
    Run run{};
    run.start_sample = from;
    run.end_sample = to;
    return run;
}

/// Frames of one line, each with a stroke over the whole line.
struct Film {
    std::array<ClippedLines, frame_count> lines;
    std::array<Runs, frame_count> runs;
    std::vector<std::uint8_t> alpha = std::vector<std::uint8_t>(l, 255);

    Film() {
        lines.fill(line());
        runs.fill({stroke(0, l)});
    }

    StyledFigures figures(float wavelength = 0) const {
        std::vector<const ClippedLines*> clipped;
        std::vector<std::vector<float>> drawn;
        for (std::size_t f = 0; f < frame_count; ++f) {
            clipped.push_back(&lines[f]);
            drawn.push_back(shown_samples({lines[f], alpha, runs[f], {}, viewport}));
        }
        const std::vector<std::vector<float>> truth(frame_count, std::vector<float>(l, 1));
        std::optional<Textures> textures;
        if (wavelength > 0) textures = {{}, wavelength};
        for (std::size_t f = 0; textures && f < frame_count; ++f)
            textures->arcs.emplace_back(runs[f], 1);
        return restlessness(one_segment(), clipped, follow_points(clipped, viewport), drawn, truth,
                            textures);
    }
};

TEST(Styled, WhatStaysIsStill) {
    Film film;
    for (std::size_t f = 0; f < frame_count; ++f) film.lines[f] = line(0.5F * float(f));
    const StyledFigures figures = film.figures();
    EXPECT_EQ(figures.changes, l * (frame_count - 1));
    EXPECT_EQ(figures.mean_shown(), 1);
    EXPECT_NEAR(*figures.sparkle(), 0, 1e-6);
    EXPECT_NEAR(*figures.flicker(), 0, 1e-6);
    EXPECT_EQ(figures.jumps(), 0);
}

TEST(Styled, AStrokeThatComesAndGoesFlickers) {
    Film film; // planted: an overshoot of 10 samples in every second frame
    for (std::size_t f = 0; f < frame_count; ++f) film.runs[f] = {stroke(0, f % 2 == 0 ? 50 : 60)};
    const StyledFigures figures = film.figures();
    // 10 of 100 points change four times and end as they began.
    EXPECT_NEAR(*figures.sparkle(), 0.1, 1e-6);
    EXPECT_NEAR(*figures.flicker(), 0.05, 1e-6);
    EXPECT_NEAR(*figures.jumps(), 0.09, 0.011); // more than a shift by two samples explains
}

TEST(Styled, ATextureThatCrawlsSparkles) {
    Film film;
    const auto put_arcs = [&](float pixels_a_frame) {
        for (std::size_t f = 0; f < frame_count; ++f) {
            film.runs[f][0].start_arc = pixels_a_frame * float(f);
            film.runs[f][0].end_arc = 200 + pixels_a_frame * float(f);
        }
    };
    put_arcs(0);
    EXPECT_NEAR(*film.figures(16).sparkle(), 0, 1e-6);
    EXPECT_NEAR(*film.figures(16).mean_shown(), 0.5, 0.03);
    put_arcs(0.5F); // the mean slope of half a cosine over 8 pixels is an eighth
    EXPECT_NEAR(*film.figures(16).sparkle(), 0.5 / 8, 2e-3);
    EXPECT_NEAR(*film.figures().sparkle(), 0, 1e-6); // without texture
}

TEST(Styled, AnEndThatMovesOnDoesNotFlicker) {
    Film film;
    for (std::size_t f = 0; f < frame_count; ++f) film.runs[f] = {stroke(0, 50 + 0.4F * float(f))};
    const StyledFigures figures = film.figures();
    EXPECT_NEAR(*figures.sparkle(), 0.004, 1e-6);
    EXPECT_NEAR(*figures.flicker(), 0, 1e-6);
    EXPECT_EQ(figures.jumps(), 0);
}

TEST(Styled, AStrokeThatAppearsJumpsOnce) {
    Film film;
    for (std::size_t f = 0; f < frame_count; ++f) {
        film.runs[f] = f < 2 ? Runs{} : Runs{stroke(20, 30)};
    }
    const StyledFigures figures = film.figures();
    EXPECT_NEAR(*figures.flicker(), 0, 1e-6);
    EXPECT_NEAR(*figures.jumps(), 0.1 / 4, 1e-6);
}

TEST(Styled, DrawnIsCoverageTimesOpacityTimesDensity) {
    const ClippedLines lines = line();
    std::vector<std::uint8_t> alpha(l, 255);
    alpha[11] = 51; // a fifth: drawn at three fifths
    const glm::ivec2 cells = viewport / LA_DENSITY_CELL;
    const std::size_t plane = std::size_t(cells.x) * std::size_t(cells.y);
    std::vector<float> weights(LA_DENSITY_BINS * plane, 1);
    std::fill_n(weights.begin() + 3 * std::ptrdiff_t(plane), plane, 0.25F);
    Runs runs{stroke(10.25F, 20)};
    const auto drawn = [&] { return shown_samples({lines, alpha, runs, weights, viewport}); };
    EXPECT_FLOAT_EQ(drawn()[9], 0);
    EXPECT_FLOAT_EQ(drawn()[10], 0.75F);
    EXPECT_FLOAT_EQ(drawn()[11], 0.6F);
    EXPECT_FLOAT_EQ(drawn()[20], 0);
    runs[0].flags = (2 * LA_BIN_STEPS + LA_BIN_STEPS / 2) << LA_RUN_BIN_SHIFT; // half of bin 3
    EXPECT_FLOAT_EQ(drawn()[12], 0.625F);
}

} // namespace
} // namespace lineatlas::bench
