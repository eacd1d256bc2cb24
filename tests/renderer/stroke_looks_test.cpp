// Looks of strokes: caps, profiles, dashes, hidden lines, focus, density, transparency.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare.hpp"
#include "strokes_support.hpp"

namespace lineatlas::test::strokes {

TEST_P(Strokes, CapsEndWhereTheyShould) {
    const auto pen = [&](Cap cap, Cap path_cap, float drop = 0.01F) {
        FrameOptions options;
        options.style.filter.drop_runs = drop;
        options.style.pen.width = 12;
        options.style.pen.cap = cap;
        options.style.pen.path_cap = path_cap;
        options.style.pen.cap_length = 24;
        return draw(behind_a_box(), options);
    };
    // Along the middle of the stroke: to the box, and from it.
    const Drawing butt = pen(Cap::butt, Cap::butt);
    EXPECT_NEAR(butt.row(200, 100, 200), 150.3 - 100, 0.6);
    EXPECT_NEAR(butt.row(200, 200, 300), 300 - 250.6, 0.6);
    EXPECT_NEAR(butt.row(200, 20, 100), 100 - 60.2, 0.6);
    EXPECT_NEAR(butt.row(200, 300, 380), 340.7 - 300, 0.6);
    // If no effect needs whole strokes, visible runs fade out.
    const Drawing plain = pen(Cap::butt, Cap::butt, 0);
    EXPECT_NEAR(plain.row(200, 100, 200), 150.3 - 100, 2);
    EXPECT_NEAR(plain.row(200, 20, 100), 100 - 60.2, 0.6);
    const Drawing round = pen(Cap::round, Cap::round);
    EXPECT_NEAR(round.row(200, 100, 200), 150.3 - 100 + 6, 0.6);
    EXPECT_NEAR(round.row(200, 200, 300), 300 - 250.6 + 6, 0.6);
    EXPECT_NEAR(round.row(200, 20, 100), 100 - 60.2 + 6, 0.6);
    EXPECT_NEAR(round.row(200, 300, 380), 340.7 - 300 + 6, 0.6);
    const Drawing taper = pen(Cap::taper, Cap::taper);
    for (int d = 1; d < 40; ++d) {
        SCOPED_TRACE(d);
        const auto width = [&](double end, int x, double sign) {
            const double from_end = (x + 0.5 - end) * sign;
            EXPECT_NEAR(taper.column(x, 180, 220), 12 * std::clamp(from_end / 24, 0.0, 1.0), 1);
        };
        width(60.2, 60 + d, 1);
        width(150.3, 150 - d, -1);
        width(250.6, 250 + d, 1);
        width(340.7, 340 - d, -1);
    }
}

TEST_P(Strokes, ProfilesRunAlongTheStroke) {
    FrameOptions options;
    options.style.pen.width = 8;
    options.style.pen.path_cap = Cap::butt;
    options.style.pen.width_profile = {1, 0.5F, 2};
    const Drawing wide = draw(behind_a_box(), options);
    const auto expected = [](double t) { return t < 0.5 ? 1 - t : 0.5 + 3 * (t - 0.5); };
    for (int x = 64; x < 148; x += 4) {
        EXPECT_NEAR(wide.column(x, 180, 220), 8 * expected((x + 0.5 - 60.2) / 90.1), 0.7) << x;
    }
    for (int x = 254; x < 338; x += 4) {
        EXPECT_NEAR(wide.column(x, 180, 220), 8 * expected((x + 0.5 - 250.6) / 90.1), 0.7) << x;
    }
    options.style.pen.width_profile = {1};
    options.style.pen.opacity_profile = {0, 1};
    const Drawing faint = draw(behind_a_box(), options);
    for (int x = 64; x < 148; x += 4) {
        EXPECT_NEAR(faint.darkness(x, 200), (x + 0.5 - 60.2) / 90.1, 0.03) << x;
    }
}

TEST_P(Strokes, ALoopHasTheSameProfileAllAround) {
    Scene scene;
    scene.line(circle(36, 80));
    FrameOptions options;
    options.style.pen.width = 12;
    options.style.pen.cap = options.style.pen.path_cap = Cap::taper;
    options.style.pen.width_profile = {0, 0.5F, 2};
    const Drawing drawing = draw(scene, options);
    for (int degrees = 0; degrees < 360; degrees += 3) {
        const double angle = degrees * std::numbers::pi / 180;
        double width = 0;
        for (double r = 65; r < 95; r += 0.25) {
            width += 0.25 * drawing.darkness(static_cast<int>(200.3 + r * std::cos(angle)),
                                             static_cast<int>(200.1 + r * std::sin(angle)));
        }
        EXPECT_NEAR(width, 6, 0.8) << degrees;
    }
}

TEST_P(Strokes, HiddenLinesAreDrawnWithTheirPen) {
    FrameOptions options;
    options.style.hidden = true;
    options.style.pen = {.width = 4, .color = {1, 0, 0}};
    options.style.hidden_pen = {.mark = "solid", .width = 4, .color = {0, 0, 1}};
    Scene scene = behind_a_box();
    scene.line({{200.2F, 60, 100}, {200.2F, 340, 100}}); // crosses in front of the hidden part
    scene.crowd();
    options.cull_hidden = false;
    const Drawing kept = draw(scene, options);
    options.cull_hidden = true;
    const Drawing culled = draw(scene, options);
    EXPECT_TRUE(equal(kept.pixels, culled.pixels));
    const auto color = [&](int x) {
        const auto at = (static_cast<std::size_t>(side - 1 - 200) * side + std::size_t(x)) * 4;
        return std::array{int{kept.pixels[at]}, int{kept.pixels[at + 1]}, int{kept.pixels[at + 2]}};
    };
    for (int x = 63; x < 338; ++x) {
        if (std::abs(x - 150) < 4 || std::abs(x - 250) < 4 || std::abs(x - 198) == 4) continue;
        const bool hidden = x > 150 && x < 250 && std::abs(x + 0.5 - 200.2) > 3.5;
        if (!hidden && std::abs(x + 0.5 - 200.2) > 1 && std::abs(x + 0.5 - 200.2) < 4) continue;
        EXPECT_EQ(color(x), (hidden ? std::array{0, 0, 255} : std::array{255, 0, 0})) << x;
    }
}

TEST_P(Strokes, HiddenPathsShorterThanAPixelAreLeftOut) {
    FrameOptions options;
    options.style.hidden = true;
    options.style.hidden_pen = {.mark = "solid", .width = 1, .path_cap = Cap::butt};
    const auto with_spur = [&](float length, bool crowded) {
        Scene scene;
        scene.line({{160, 200.5F, 0}, {200, 200.5F, 0}, {240, 200.5F, 0}});
        if (length > 0) scene.line({{200, 200.5F, 0}, {200, 200.5F + length, 0}});
        scene.box({150.3F, 100}, {250.6F, 300});
        if (crowded) scene.crowd();
        return draw(scene, options).pixels;
    };
    for (const bool crowded : {false, true}) {
        EXPECT_TRUE(equal(with_spur(0.9F, crowded), with_spur(0, crowded)));
        EXPECT_FALSE(equal(with_spur(1.5F, crowded), with_spur(0, crowded)));
    }
}

TEST_P(Strokes, TheFocusChangesWidthAndOpacity) {
    Scene scene;
    scene.line({{20, 200.5F, 0}, {380, 200.5F, 0}});
    FrameOptions options;
    options.style.pen.width = 8;
    options.style.focus = {.on = true,
                           .point = {0.1F, 0.5F, 0},
                           .radius = 0.2F,
                           .falloff = 0.3F,
                           .width = 0.5F,
                           .opacity = 0.4F};
    const Drawing drawing = draw(scene, options);
    for (int x = 30; x < 370; x += 5) {
        const double t = std::clamp((x + 0.5 - 40 - 80) / 120, 0.0, 1.0);
        const double away = t * t * (3 - 2 * t);
        EXPECT_NEAR(drawing.darkness(x, 200), 1 - 0.6 * away, 0.02) << x;
        EXPECT_NEAR(drawing.column(x, 180, 221), 8 * (1 - 0.5 * away) * (1 - 0.6 * away), 0.4) << x;
    }
}

TEST_P(Strokes, NoLineNearAFocusIsLostWithThoseFarAway) {
    Scene scene;
    scene.line({{20, 150.5F, 0}, {380, 150.5F, 0}});
    for (int x = 20; x < 380; x += 12) {
        const auto from = static_cast<float>(x);
        scene.line({{from, 200.5F, 0}, {from + 8, 200.5F, 0}});
    }
    FrameOptions options;
    options.style.focus = {.on = true, .radius = 0.1F, .falloff = 0.1F, .opacity = 0};
    for (const bool in_scene : {false, true}) {
        options.style.focus.in_scene = in_scene;
        options.style.focus.point = in_scene ? glm::vec3{200, 200, 0} : glm::vec3{0.5F, 0.5F, 0};
        options.style.focus.opacity = 0; // lines may be left out
        const Drawing without = draw(scene, options);
        options.style.focus.opacity = 1e-9F; // all lines are drawn although they cannot be seen
        const Drawing with = draw(scene, options);
        EXPECT_TRUE(equal(without.pixels, with.pixels));
        EXPECT_GT(without.row(200, 0, side), 20);
    }
}

TEST_P(Strokes, DensityFallsToAboutItsLimit) {
    Scene scene;
    for (int i = 0; i < 20; ++i) {
        const float y = 150.5F + 5 * static_cast<float>(i);
        scene.line({{60, y, 0}, {340, y, 0}});
    }
    FrameOptions options;
    options.style.pen.width = 2;
    const auto mean = [&] { // pixels of line per pixel
        const Drawing drawing = draw(scene, options);
        double sum = 0;
        for (int y = 180; y < 220; ++y) sum += drawing.row(y, 150, 250);
        return sum / (40 * 100) / 2;
    };
    EXPECT_NEAR(mean(), 0.2, 0.01);
    for (const float limit : {0.05F, 0.1F}) {
        options.style.density.limit = limit;
        EXPECT_NEAR(mean(), limit, 0.25 * limit) << limit;
    }
}

TEST_P(Strokes, HiddenLinesHaveALimitOfTheirOwn) {
    Scene scene; // twenty lines behind a box, and as many beside it
    scene.box({100, 140}, {300, 260});
    for (int i = 0; i < 20; ++i) {
        const float y = 150.5F + 5 * static_cast<float>(i);
        scene.line({{10, y, -100}, {390, y, -100}});
    }
    FrameOptions options{.lines = mask_of(LineKind::file)};
    options.style.pen.width = 2;
    options.style.hidden = true;
    options.style.hidden_pen = options.style.pen;
    const auto mean = [&](int from, int to) { // pixels of line per pixel
        const Drawing drawing = draw(scene, options);
        double sum = 0;
        for (int y = 180; y < 220; ++y) sum += drawing.row(y, from, to);
        return sum / (40 * (to - from)) / 2;
    };
    EXPECT_NEAR(mean(150, 250), 0.2, 0.01);
    for (const float limit : {0.05F, 0.1F}) {
        options.style.hidden_density = limit;
        EXPECT_LE(mean(150, 250), 1.05 * limit) << "hidden";
        EXPECT_GE(mean(150, 250), 0.7 * limit) << "hidden";
        EXPECT_NEAR(mean(30, 70), 0.2, 0.01) << "visible";
    }
}

TEST_P(Strokes, LinesOfMorePriorityStay) {
    Scene scene; // edges of boxes, and wires between them
    for (int i = 0; i < 10; ++i) {
        const float y = 120.5F + 16 * static_cast<float>(i);
        scene.box({60, y}, {340, y + 8});
        scene.line({{60, y + 4, 100}, {340, y + 4, 100}});
        scene.line({{60, y + 12, 100}, {340, y + 12, 100}});
    }
    FrameOptions options{.lines = mask_of(LineKind::file) | mask_of(LineKind::boundary)};
    options.style.density = {.limit = 0.15F, .priority = {0, 0, 0, 0, 1}};
    const auto means = [&](const Drawing& drawing) {
        std::array<double, 2> mean{}; // boundaries, wires
        for (int i = 3; i < 7; ++i) {
            const int y = 120 + 16 * i;
            mean[0] += (drawing.darkness(200, y) + drawing.darkness(200, y + 8)) / 8;
            mean[1] += (drawing.darkness(200, y + 4) + drawing.darkness(200, y + 12)) / 8;
        }
        return mean;
    };
    const auto wires = means(draw(scene, options));
    EXPECT_GT(wires[1], wires[0] + 0.4) << wires[0] << " " << wires[1];
    options.style.density.priority = {0, 1, 0, 0, 0};
    const auto edges = means(draw(scene, options));
    EXPECT_GT(edges[0], edges[1] + 0.4) << edges[0] << " " << edges[1];
}

TEST_P(Strokes, OutlinesStayWhereLinesAreDense) {
    Scene scene; // wires beside the upper edge of a box, on both sides
    scene.box({60, 120}, {340, 280});
    for (int i = 0; i < 12; ++i) {
        const float y = 96.5F + 4 * static_cast<float>(i) + (i < 6 ? 0 : 4);
        scene.line({{60, y, 100}, {340, y, 100}});
    }
    FrameOptions options{.lines = mask_of(LineKind::file) | mask_of(LineKind::boundary)};
    options.style.density = {.limit = 0.15F, .priority = {0, 0, 0, 0, 1}};
    const auto edge = [&] {
        const Drawing drawing = draw(scene, options);
        return std::max(drawing.darkness(200, 119), drawing.darkness(200, 120));
    };
    EXPECT_LT(edge(), 0.3);
    options.style.pens = {{.match = {.kinds = {"outline"}}, .width = 4}};
    EXPECT_GT(edge(), 0.9);
    options.style.pens = {{.match = {.kinds = {"boundary"}}, .width = 4}};
    EXPECT_LT(edge(), 0.4) << "any other rule leaves it as it was";
}

TEST_P(Strokes, DashesKeepTheirPhase) {
    for (const float overshoot : {0.0F, 6.0F}) {
        SCOPED_TRACE(overshoot);
        FrameOptions options;
        options.style.pen.mark = "dashed";
        options.style.filter.overshoot = overshoot;
        Scene free;
        free.line({{60.2F, 200.4F, 0}, {340.7F, 200.4F, 0}});
        const Drawing whole = draw(free, options), part = draw(behind_a_box(), options);
        options.style.filter.overshoot = 0;
        const Drawing plain = draw(free, options);
        double dark = 0, light = 0;
        for (int x = 66; x < 336; ++x) {
            EXPECT_NEAR(whole.darkness(x, 200), plain.darkness(x, 200), 0.02) << x;
            if (x < 146 || x > 255) {
                EXPECT_NEAR(whole.darkness(x, 200), part.darkness(x, 200), 0.02) << x;
            }
            (whole.darkness(x, 200) > 0.5 ? dark : light) += 1;
        }
        EXPECT_GT(dark, 40);
        EXPECT_GT(light, 40);
    }
}

namespace {

/// Distance from a polyline, and whether the nearest place is an inner vertex.
std::pair<double, bool> nearest(const Polyline& line, glm::vec2 place) {
    double best = 1e9;
    bool at_vertex = false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const glm::vec2 a{line[i]}, b{line[i + 1]};
        const float t = glm::dot(place - a, b - a) / glm::dot(b - a, b - a);
        const double d = glm::distance(place, a + (b - a) * std::clamp(t, 0.0F, 1.0F));
        if (d < best) {
            best = d;
            at_vertex = t <= 0 || t >= 1;
        }
    }
    return {best, at_vertex};
}

} // namespace

TEST_P(Strokes, HalfTransparentPathsHaveOneLayerAndNoGap) {
    Polyline zigzag{{40, 60, 0}}, arc;
    for (const float degrees : {20.0F, -40.0F, 50.0F, -40.0F, 60.0F, 0.0F}) { // turns to 100
        const float angle = degrees * std::numbers::pi_v<float> / 180;
        zigzag.push_back(zigzag.back() + 55.3F * glm::vec3{std::cos(angle), std::sin(angle), 0});
    }
    for (int i = 0; i <= 12; ++i) {
        const float angle = static_cast<float>(i) * 0.22F;
        arc.emplace_back(200 + 110.3F * std::cos(angle), 200 + 110.3F * std::sin(angle), 0);
    }
    Scene scene;
    scene.line(zigzag);
    scene.line(arc);
    for (const Join join : {Join::mitre, Join::round, Join::bevel}) {
        for (const Cap cap : {Cap::butt, Cap::round}) {
            SCOPED_TRACE(std::to_string(static_cast<int>(join)) + " " +
                         std::to_string(static_cast<int>(cap)));
            FrameOptions options;
            options.style.pen.width = 10;
            options.style.pen.opacity = 0.5F;
            options.style.pen.join = join;
            options.style.pen.cap = cap;
            options.style.pen.path_cap = Cap::butt;
            const Drawing drawing = draw(scene, options);
            int dark = 0, gaps = 0;
            double darkest = 0, lightest = 1;
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    const glm::vec2 place{x + 0.5F, y + 0.5F};
                    const double ink = drawing.darkness(x, y);
                    darkest = std::max(darkest, ink);
                    if (ink > 0.5 + 2.5 / 255) ++dark;
                    for (const Polyline& line : {zigzag, arc}) {
                        const auto [distance, at_vertex] = nearest(line, place);
                        const bool ends = glm::distance(place, glm::vec2{line.front()}) < 6 ||
                                          glm::distance(place, glm::vec2{line.back()}) < 6;
                        // A bevel may leave less beside a vertex.
                        const double inside = at_vertex && join == Join::bevel ? 2 : 4;
                        if (ends || distance > inside) continue;
                        lightest = std::min(lightest, ink);
                        if (ink < 0.5 - 2.5 / 255) ++gaps;
                    }
                }
            }
            EXPECT_EQ(dark, 0) << darkest;
            EXPECT_EQ(gaps, 0) << lightest;
        }
    }
}

} // namespace lineatlas::test::strokes
