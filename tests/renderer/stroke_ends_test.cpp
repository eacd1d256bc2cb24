// Ends of strokes (§4.5): overshoot, halos, filled holes and dropped runs.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "strokes_support.hpp"

namespace lineatlas::test::strokes {

namespace {

/// Checks scenes once as they are, and once with culling of hidden segments.
template <class Make, class Check>
void culled_or_not(Make&& make, Check&& check) {
    for (const bool culled : {false, true}) {
        SCOPED_TRACE(culled ? "culled" : "not culled");
        Scene scene = make();
        if (culled) scene.crowd();
        check(scene);
    }
}

} // namespace

TEST_P(Strokes, OvershootMakesEveryEndLonger) {
    culled_or_not(
        [] {
            Scene scene = behind_a_box();
            scene.line({{60, 350, 0}, {190, 371, 0}}); // free
            scene.line({{60, 70.2F, 0}, {120, 70.2F, 0}, {168, 34.2F, 0}, {260, 34.2F, 0}});
            scene.box({80, 60}, {124, 75}); // its edge is 5 pixels behind the bend
            return scene;
        },
        [&](const Scene& scene) {
            const Drawing drawing = draw(scene, {.overshoot = 12});
            expect_strokes(drawing.of(scene.lines[0]),
                           {{-12, 90.1 + 12}, {190.4 - 12, 280.5 + 12}});
            const double free = length_of(scene.lines[1]);
            expect_strokes(drawing.of(scene.lines[1]), {{-12, free + 12}});
            expect_strokes(drawing.of(scene.lines[2]), {{-12, 20 + 12}, {65 - 12, 212 + 12}});
            for (const lineatlas::Run& run : drawing.runs) { // the run's data about its stroke
                bool found = false;
                for (const Polyline& line : scene.lines) {
                    for (const Span& s : drawing.of(line)) {
                        found |= std::abs(s.to - s.from - (run.stroke_end - run.stroke_start)) < 1;
                    }
                }
                EXPECT_TRUE(found) << run.stroke_start << " to " << run.stroke_end;
            }
        });
}

TEST_P(Strokes, OvershootNearAJoint) {
    for (const float off : {-1.7F, -1.0F, -0.5F, -0.1F, 0.0F, 0.1F, 0.5F, 1.0F, 1.7F}) {
        SCOPED_TRACE(off);
        culled_or_not(
            [&] {
                Scene scene;
                Polyline points;
                for (int i = 0; i <= 14; ++i) points.emplace_back(60 + 20 * i, 200.3F, 0);
                scene.line(points);
                scene.box({160 + off, 100}, {260 + off, 300});
                return scene;
            },
            [&](const Scene& scene) {
                expect_strokes(draw(scene, {.overshoot = 12}).of(scene.lines[0]),
                               {{-12, 100 + off + 12}, {200 + off - 12, 280 + 12}});
            });
    }
}

TEST_P(Strokes, OvershootGoesRoundALoop) {
    const Polyline loop = circle(36, 80);
    const double length = length_of(loop);
    for (int at = 0; at < 360; at += 7) {
        SCOPED_TRACE(at);
        Scene scene;
        scene.line(loop);
        // A sector of 40 degrees is hidden.
        const auto corner = [&](float degrees, float radius) {
            const float angle = degrees * std::numbers::pi_v<float> / 180;
            return glm::vec2{200.3F, 200.1F} + radius * glm::vec2{std::cos(angle), std::sin(angle)};
        };
        const auto a = static_cast<float>(at);
        scene.sheet({corner(a, 20), corner(a, 150), corner(a + 40, 150), corner(a + 40, 20)});
        const std::vector<Span> strokes = draw(scene, {.overshoot = 12}).of(loop);
        ASSERT_EQ(strokes.size(), 1U);
        double from = (at + 40) / 360.0 * length - 12;
        if (from >= length) from -= length;
        // Either place may be counted from the other end of the loop.
        const double off = std::remainder(strokes[0].from - from, length);
        EXPECT_NEAR(off, 0, 1);
        EXPECT_NEAR(strokes[0].to - strokes[0].from, length * 320 / 360 + 24, 2);

        // With gaps of 4 pixels on either side of the sector's edges nothing shows behind the
        // sector.
        FrameOptions options{.lines = mask_of(LineKind::file) | mask_of(LineKind::boundary)};
        options.style.filter = {.overshoot = 12, .halo = 3};
        double drawn = 0;
        for (const Span& s : draw(scene, options).of(loop)) drawn += s.to - s.from;
        EXPECT_NEAR(drawn, length * 320 / 360 - 8, 2);
    }
}

TEST_P(Strokes, OvershootStopsInTheMiddleOfWhatIsHidden) {
    Scene scene = behind_a_box();
    const Drawing drawing = draw(scene, {.overshoot = 60}); // more than half of the hidden part
    expect_strokes(drawing.of(scene.lines[0]), {{-60, 280.5 + 60}});
}

TEST_P(Strokes, OvershootVariesFromPathToPath) {
    Scene scene;
    for (int i = 0; i < 10; ++i) {
        const auto y = static_cast<float>(60 + 30 * i);
        scene.line({{100, y, 0}, {300, y, 0}});
    }
    FrameOptions options{.style = {.filter = {.overshoot = 12, .overshoot_variation = 0.5F}}};
    const Drawing still = draw(scene, options);
    const Drawing moved = draw(scene, options, pixel_camera({3.3F, 1.7F}));
    std::set<int> tenths;
    for (const Polyline& line : scene.lines) {
        const std::vector<Span> a = still.of(line);
        ASSERT_EQ(a.size(), 1U);
        const double grown = -a[0].from;
        EXPECT_GE(grown, 6 - 0.1);
        EXPECT_LE(grown, 12 + 0.1);
        EXPECT_NEAR(a[0].to - 200, grown, 0.1);
        tenths.insert(static_cast<int>(grown * 10));
        const Polyline seen{line[0] - glm::vec3{3.3F, 1.7F, 0}, line[1] - glm::vec3{3.3F, 1.7F, 0}};
        bool found = false;
        for (const lineatlas::Run& run : moved.runs) {
            if (std::abs(run.start[1] - seen[0].y) > 0.1F) continue;
            found = true;
            const double longer =
                0.5 * (std::hypot(run.end[0] - run.start[0], run.end[1] - run.start[1]) - 200);
            EXPECT_NEAR(longer, grown, 0.05);
        }
        EXPECT_TRUE(found);
    }
    EXPECT_GE(tenths.size(), 6U);
}

TEST_P(Strokes, UndershootIsAtHiddenEndsOnly) {
    const Scene scene = behind_a_box();
    expect_strokes(draw(scene, {.undershoot = 5}).of(scene.lines[0]),
                   {{0, 90.1 - 5}, {190.4 + 5, 280.5}});
    expect_strokes(draw(scene, {.overshoot = 12, .undershoot = 5}).of(scene.lines[0]),
                   {{-12, 90.1 + 7}, {190.4 - 7, 280.5 + 12}});
}

TEST_P(Strokes, HaloLeavesAGapBesideTheNearerOfTwoWires) {
    Scene scene; // strokes are 2 pixels wide
    scene.line({{60.3F, 200.2F, 0}, {340.3F, 200.2F, 0}});
    scene.line({{200.4F, 60.1F, front}, {200.4F, 340.1F, front}});
    const Drawing drawing = draw(scene, {.halo = 6});
    expect_strokes(drawing.of(scene.lines[0]), {{0, 140.1 - 7}, {140.1 + 7, 280}});
    expect_strokes(drawing.of(scene.lines[1]), {{0, 280}}, 0.1);
}

TEST_P(Strokes, HaloLeavesAGapBesideABox) {
    const Scene scene = behind_a_box();
    FrameOptions options{.lines = mask_of(LineKind::file) | mask_of(LineKind::boundary),
                         .style = {.filter = {.halo = 6}}};
    const Drawing drawing = draw(scene, options);
    expect_strokes(drawing.of(scene.lines[0]), {{0, 90.1 - 7}, {190.4 + 7, 280.5}});
    // The outline is whole.
    expect_strokes(drawing.of({{150.3F, 100, front}, {150.3F, 300, front}}), {{0, 200}}, 0.1);
    expect_strokes(drawing.of({{250.6F, 100, front}, {250.6F, 300, front}}), {{0, 200}}, 0.1);
}

TEST_P(Strokes, APieceBeyondThePathIsInked) {
    culled_or_not(
        [] {
            Scene scene; // its last segment is hidden
            scene.line({{60, 200.5F, 0}, {196, 200.5F, 0}, {199, 200.5F, 0}});
            scene.box({195.5F, 150}, {300, 250});
            return scene;
        },
        [&](const Scene& scene) {
            const Drawing drawing = draw(scene, {.overshoot = 12});
            expect_strokes(drawing.of(scene.lines[0]), {{-12, 147.5}});
            for (int x = 200; x < 206; ++x) EXPECT_GT(drawing.darkness(x, 200), 0.98) << x;
        });
}

TEST_P(Strokes, OvershootEndsAtAHalo) {
    culled_or_not(
        [] {
            Scene scene = behind_a_box();
            scene.box({150.3F, 20}, {160.6F, 60}); // overshoots would meet behind this one
            scene.line({{60.2F, 40.4F, 0}, {340.7F, 40.4F, 0}});
            return scene;
        },
        [&](const Scene& scene) {
            FrameOptions options{.lines = mask_of(LineKind::file) | mask_of(LineKind::boundary)};
            options.style.filter = {.overshoot = 12, .halo = 3};
            const Drawing drawing = draw(scene, options);
            expect_strokes(drawing.of(scene.lines[0]), {{-12, 90.1 - 4}, {190.4 + 4, 280.5 + 12}});
            expect_strokes(drawing.of(scene.lines[1]), {{-12, 90.1 - 4}, {100.4 + 4, 280.5 + 12}});
        });
}

TEST_P(Strokes, ACrumbBetweenHalosIsDropped) {
    Scene scene; // 20 pixels between the wires, less 4 on either side
    scene.line({{60.3F, 200.2F, 0}, {340.3F, 200.2F, 0}});
    scene.line({{180.3F, 60.1F, front}, {180.3F, 340.1F, front}});
    scene.line({{200.3F, 60.1F, front}, {200.3F, 340.1F, front}});
    scene.line({{334.3F, 60.1F, front}, {334.3F, 340.1F, front}}); // this leaves 2 pixels
    const auto strokes = [&](float drop) {
        return draw(scene, {.drop_runs = drop, .halo = 3}).of(scene.lines[0]);
    };
    expect_strokes(strokes(0), {{0, 116}, {124, 136}, {144, 270}, {278, 280}});
    expect_strokes(strokes(10), {{0, 116}, {124, 136}, {144, 270}});
    expect_strokes(strokes(14), {{0, 116}, {144, 270}});
}

TEST_P(Strokes, OvershootOfACrumbIsShort) {
    for (const float shown : {0.6F, 2.0F, 4.0F, 6.0F, 11.0F, 14.0F}) {
        SCOPED_TRACE(shown);
        Scene scene;
        scene.line({{80.2F, 120.4F, 0}, {340.2F, 120.4F, 0}});
        scene.box({140, 100}, {200.2F, 150});
        scene.box({200.2F + shown, 100}, {260, 150});
        const std::vector<Span> strokes = draw(scene, {.overshoot = 12}).of(scene.lines[0]);
        ASSERT_EQ(strokes.size(), 3U);
        const double overshoot = std::min(shown * shown / 12, 12.0F);
        EXPECT_NEAR(strokes[1].from, 120 - overshoot, 1.5);
        EXPECT_NEAR(strokes[1].to, 120 + shown + overshoot, 1.5);
    }
}

/// A line with 5 pixels hidden at 100 of it, and 5 visible between two boxes on another.
Scene hole_and_run(float phase) {
    Scene scene;
    const float x = 180.2F + phase;
    scene.line({{80.2F, 300.4F, 0}, {340.2F, 300.4F, 0}});
    scene.box({x, 250}, {x + 5, 350});
    scene.line({{80.2F, 120.4F, 0}, {340.2F, 120.4F, 0}});
    scene.box({x - 40, 100}, {x, 150});
    scene.box({x + 5, 100}, {x + 45, 150});
    return scene;
}

TEST_P(Strokes, ShortHolesAreClosedAndShortRunsDropped) {
    for (const float phase : {0.0F, 0.4F, 0.9F, 1.3F}) {
        SCOPED_TRACE(phase);
        const double at = 100 + phase;
        const Scene scene = hole_and_run(phase);
        const auto hole = [&](const StrokeFilter& f) { return draw(scene, f).of(scene.lines[0]); };
        const auto run = [&](const StrokeFilter& f) { return draw(scene, f).of(scene.lines[1]); };
        expect_strokes(hole({.fill_holes = 6}), {{0, 260}});
        expect_strokes(hole({.fill_holes = 4}), {{0, at}, {at + 5, 260}});
        expect_strokes(run({.drop_runs = 6}), {{0, at - 40}, {at + 45, 260}});
        expect_strokes(run({.drop_runs = 4}), {{0, at - 40}, {at, at + 5}, {at + 45, 260}});
        // Holes are filled before short runs are dropped, so a filled run is not short.
        expect_strokes(hole({.fill_holes = 6, .drop_runs = 120}), {{0, 260}});
    }
}

TEST_P(Strokes, AFilledHoleIsInked) {
    const Scene scene = hole_and_run(0);
    EXPECT_NEAR(draw(scene, {.fill_holes = 6}).row(300, 100, 320), 220 * 0.9, 25);
    const double filled = draw(scene, {.fill_holes = 6}).row(300, 175, 190);
    const double whole = draw(scene, {.fill_holes = 6}).row(300, 215, 230);
    EXPECT_NEAR(filled, whole, 0.1);
}

TEST_P(Strokes, NothingLeaksIntoTheNextPath) {
    chain_angle_ = 0.5F;
    Scene scene; // two sides of a corner, hidden about it
    scene.line({{80, 80, 0}, {280, 80, 0}});
    scene.line({{280, 80, 0}, {280, 300, 0}});
    scene.box({270, 60}, {300, 90});
    const auto both = [&](const StrokeFilter& filter) {
        const Drawing drawing = draw(scene, filter);
        return std::array{drawing.of(scene.lines[0]), drawing.of(scene.lines[1])};
    };
    const auto filled = both({.fill_holes = 50});
    expect_strokes(filled[0], {{0, 190}});
    expect_strokes(filled[1], {{10, 220}});
    const auto grown = both({.overshoot = 12});
    expect_strokes(grown[0], {{-12, 190 + 12}});
    expect_strokes(grown[1], {{10 - 12, 220 + 12}});
    scene.box({83, 60}, {275, 90}); // this leaves 3 pixels of the first side
    const auto dropped = both({.drop_runs = 6, .overshoot = 12});
    expect_strokes(dropped[0], {});
    expect_strokes(dropped[1], {{10 - 12, 220 + 12}});
}

} // namespace lineatlas::test::strokes
