#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lineatlas/scenes.hpp"
#include "test_meshes.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

using test::Cuts;
using test::flat_camera;

/// A scene's lines with random visibility: every segment is cut at random places.
VectorDrawing scene_drawing(const char* name, bool hidden, const VectorOptions& options = {}) {
    const Scene scene = make_scene(name);
    const LineSet lines = extract_lines(scene.mesh);
    const Camera camera = make_camera(scene.view(0.3F), {1200, 900}, lines.bounds);
    test::Random random{3};
    Cuts cuts{lines, camera};
    for (std::uint32_t i = 0; i < lines.segments.size(); ++i) {
        const bool candidate = (lines.segments[i].tag & LA_TAG_KIND_MASK) == LA_KIND_SILHOUETTE;
        if (candidate && random.below(8) != 0) continue; // most candidates are no silhouette
        bool visible = random.coin();
        float from = 0;
        while (from < 1) {
            const float to = random.coin() ? 1 : random.between(from, 1.2F);
            cuts.add(i, from, std::min(to, 1.0F), visible);
            visible = !visible;
            from = to;
        }
    }
    Style style{};
    style.hidden = hidden;
    VectorOptions with_mesh = options;
    with_mesh.mesh = &scene.mesh;
    return make_vector_drawing(lines, camera, cuts.intervals, style, with_mesh);
}

TEST(VectorDrawings, OfScenesAreSound) {
    for (const char* name : {"clevis", "house"}) {
        for (const bool hidden : {false, true}) {
            const VectorDrawing drawing = scene_drawing(name, hidden);
            EXPECT_GT(drawing.paths.size(), 50U);
            EXPECT_EQ(test::flaws_of(drawing), "");
            EXPECT_LE(test::longest_overlap(drawing.paths), 0.5) << name << ' ' << hidden;
            EXPECT_EQ(std::ranges::any_of(drawing.paths,
                                          [](const VectorPath& path) { return !path.visible; }),
                      hidden);
        }
    }
}

TEST(VectorDrawings, ForAPlotterAreSoundToo) {
    const VectorDrawing plain = scene_drawing("house", false);
    const VectorDrawing drawing = scene_drawing("house", false, {.plotter = true});
    EXPECT_EQ(test::flaws_of(drawing), "");
    EXPECT_LE(test::longest_overlap(drawing.paths), 0.5);
    ASSERT_TRUE(drawing.travel);
    EXPECT_LT(drawing.travel->after, 0.1 * drawing.travel->before);
    EXPECT_NEAR(test::total_length(drawing.paths), test::total_length(plain.paths),
                0.1 * static_cast<double>(plain.paths.size()));
}

TEST(VectorDrawings, HiddenLinesComeFirst) {
    const VectorDrawing drawing = scene_drawing("clevis", true);
    EXPECT_TRUE(std::ranges::is_sorted(drawing.paths, {}, &VectorPath::visible));
}

TEST(VectorDrawings, OfNothingAreEmpty) {
    const VectorDrawing drawing = make_vector_drawing({}, flat_camera(), {}, {});
    EXPECT_TRUE(drawing.paths.empty());
}

TEST(VectorDrawings, ExactIntervalsStayAsTheyAre) {
    // A tiny piece before a nearer line, and an end beside that line.
    test::Lines lines;
    lines.add(LineKind::crease, {{20, 50, 0.5F}, {180, 50, 0.9F}});
    lines.add(LineKind::silhouette, {{100, 10, 0.2F}, {100, 90, 0.2F}});
    Cuts cuts{lines.set, flat_camera()};
    const auto share = [](float x) { return (x - 20) / 160; };
    cuts.add(0, 0, share(99.25F), true);
    cuts.add(0, share(99.25F), share(140), false);
    cuts.add(0, share(140), share(140.5F), true);
    cuts.add(0, share(140.5F), 1, false);
    cuts.add(1, 0, 1, true);
    const auto length = [&] {
        return test::total_length(
            make_vector_drawing(lines.set, flat_camera(), cuts.intervals, {}).paths);
    };
    // As by samples: the line is met, and there is no tiny piece.
    EXPECT_NEAR(length(), 80 + 80, 1e-3);
    for (Interval& interval : cuts.intervals) interval.flags |= LA_INTERVAL_EXACT;
    EXPECT_NEAR(length(), 80 + 79.25 + 0.5, 1e-3);
}

/// Random intervals of all kinds that a table may hold.
std::vector<Interval> wild_intervals(const LineSet& lines, const Camera& camera,
                                     test::Random& random) {
    Cuts cuts{lines, camera};
    for (std::uint32_t i = 0; i < lines.segments.size(); ++i) {
        for (std::uint32_t k = random.below(5); k > 0; --k) {
            cuts.add(i, random.between(0, 1), random.between(0, 1), random.coin());
            Interval& interval = cuts.intervals.back();
            if (random.below(4) == 0) interval.flags = random.below(4096);
            if (random.below(9) == 0) interval.end[0] = interval.start[0];
            if (random.below(50) == 0) interval.start[1] = random.between(-1e6F, 1e6F);
            if (random.below(90) == 0) interval.start[random.below(2)] = std::nanf("");
        }
    }
    return cuts.intervals;
}

TEST(VectorDrawings, OfAnyIntervalsAreSound) {
    test::Random random{77};
    for (int round = 0; round < 60; ++round) {
        const Mesh mesh = test::with_random_groups(test::random_soup(random, 12, 20), random, 3);
        const LineSet lines = extract_lines(mesh);
        const View view{.eye = random.point(2), .target = random.point(1), .near = 0.1F, .far = 9};
        const Camera camera = make_camera(view, {300, 200}, lines.bounds);
        Style style{};
        style.hidden = random.coin();
        style.filter = {.fill_holes = random.between(0, 9),
                        .drop_runs = random.between(0, 9),
                        .overshoot = random.between(0, 9),
                        .overshoot_variation = random.between(0, 1),
                        .undershoot = random.between(0, 4),
                        .halo = random.between(0, 4)};
        const VectorDrawing drawing =
            make_vector_drawing(lines, camera, wild_intervals(lines, camera, random), style,
                                {.mesh = &mesh, .plotter = random.coin()});
        EXPECT_EQ(test::flaws_of(drawing), "");
        EXPECT_FALSE(to_svg(drawing).empty());
        EXPECT_FALSE(to_json(drawing).empty());
    }
}

} // namespace
} // namespace lineatlas
