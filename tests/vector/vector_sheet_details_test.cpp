// Details on sheets: their places, and what their circle leaves of paths.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "core/drawing_scale.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/sheet.hpp"
#include "sheet_support.hpp"
#include "vector/clip_drawing.hpp"

namespace lineatlas {
namespace {

/// A drawing with one path.
VectorDrawing drawing_of(VectorPath path) {
    VectorDrawing drawing{.size = {100, 100}, .groups = {}, .paths = {}};
    drawing.paths.push_back(std::move(path));
    return drawing;
}

VectorPath arc_path(const VectorArc& arc, std::uint32_t chords) {
    VectorPath path{.closed = std::abs(arc.sweep) > 6.28, .points = {}, .pieces = {}};
    for (std::uint32_t i = 0; i <= chords; ++i)
        path.points.push_back({.at = arc.at(arc.from + arc.sweep * i / chords)});
    path.curves.push_back({.first = 0, .last = chords, .arc = arc});
    return path;
}

TEST(Sheet, ADetailIsLargerAndHasALetter) {
    const Box box;
    for (const auto& [scale, own, factor] :
         {std::tuple{"1:1", "2:1", 2.0}, {"1:2", "1:1", 1.0}, {"1:5", "1:2", 0.5}}) {
        SCOPED_TRACE(scale);
        const glm::vec3 corner = box.high;
        const SheetLayout layout = box.layout({.views = {"front", "section:x=10"},
                                               .details = {{"front", corner, 12}},
                                               .page = parse_page("a2"),
                                               .scale = scale});
        ASSERT_EQ(layout.views.size(), 3U);
        const SheetView& detail = layout.views[2];
        EXPECT_EQ(detail.letter, "B");
        const glm::dvec2 size = detail.high - detail.low;
        EXPECT_NEAR(size.x, 24 * factor, 1e-9);
        EXPECT_NEAR(size.y, 24 * factor, 1e-9);
        const glm::dvec2 middle = detail.low + 0.5 * size;
        EXPECT_LT(glm::distance(on_paper(detail, corner), middle), 1e-3);
        const auto length = [&](const SheetView& view) {
            return glm::distance(on_paper(view, corner), on_paper(view, {0, corner.y, 0}));
        };
        const double of_sheet = parse_scale("", scale);
        EXPECT_NEAR(length(detail), factor / of_sheet * length(layout.views[0]), 2e-3);
        std::vector<SheetCircle> circles;
        for (const SheetCircle& circle : layout.circles)
            if (circle.layer == "details") circles.push_back(circle);
        ASSERT_EQ(circles.size(), 2U);
        EXPECT_LT(glm::distance(circles[0].center, on_paper(layout.views[0], corner)), 1e-3);
        EXPECT_NEAR(circles[0].radius, 12 * of_sheet, 1e-9);
        EXPECT_NEAR(circles[1].radius, 12 * factor, 1e-9);
        EXPECT_EQ(texts_of(layout, "details"),
                  (std::set<std::string>{"B", std::string{"B ("} + own + ")"}));
    }
}

TEST(Sheet, ADetailEndsAtItsCircle) {
    const Box box;
    const SheetOptions options{.views = {"front"},
                               .details = {{"front", box.high, 12, "5:1"}},
                               .page = parse_page("a2"),
                               .scale = "1:1"};
    const auto lines = lines_of(to_dxf(box.sheet(options)));
    EXPECT_EQ(lines.count("detail_A-crease"), 2U); // the two edges that meet in the corner
    for (auto [at, end] = lines.equal_range("detail_A-crease"); at != end; ++at)
        EXPECT_NEAR(at->second.length(), 60, 1e-3);
    EXPECT_TRUE(group(parsed(to_svg(box.sheet(options))), "detail_A"));
}

TEST(Sheet, DetailsThatCannotBeAreRefused) {
    const SheetDetail parsed = parse_detail("section:x=1/20,-35,0.5/8/5:1");
    EXPECT_EQ(parsed.view, "section:x=1");
    EXPECT_EQ(parsed.center, (glm::dvec3{20, -35, 0.5}));
    EXPECT_EQ(parsed.radius, 8);
    EXPECT_EQ(parsed.scale, "5:1");
    const std::string oblique = "section:1,2,3/0,1,1";
    EXPECT_EQ(parse_detail(oblique + "/4,5,6/2").view, oblique);
    EXPECT_EQ(parse_detail(oblique + "/4,5,6/2").radius, 2);
    for (const char* wrong : {"", "front", "front/1,2/8", "front/1,2,3", "front/1,2,3/0",
                              "front/1,2,3/-2", "front/1,2,3/8/big", "front/1,2,3,4/8"})
        EXPECT_THROW(parse_detail(wrong), UsageError) << wrong;
    const auto refused = [](SheetDetail detail, const std::string& words) {
        try {
            Box{}.layout(
                {.views = {"front", "top"}, .details = {std::move(detail)}, .scale = "1:2"});
            ADD_FAILURE() << "not refused: " << words;
        } catch (const UsageError& error) {
            EXPECT_NE(std::string{error.what()}.find(words), std::string::npos) << error.what();
        }
    };
    refused({"right", {0, 20, 10}, 5}, "a detail of \"right\": the sheet has no such view");
    refused({"front", {200, 20, 10}, 5}, "its circle about 200,20,10 lies beside the model");
    refused({"front", {0, 20, 10}, 5, "1:2"}, "must be larger than 1:2");
    refused({"front", {0, 20, 10}, 0}, "radius must be above 0");
    refused({"front", {0, 20, 10}, 50, "10:1"},
            "no room for views and details of their own scales");
    // A detail with a scale of its own keeps the sheet's below that.
    EXPECT_EQ((Box{}.layout({.details = {{"front", {0, 20, 10}, 5, "1:1"}}}).scale), "1:2");
}

TEST(Sheet, AnArcThatIsClippedStaysAnArc) {
    VectorPath whole{.closed = true, .points = {}, .pieces = {}};
    constexpr int chords = 24;
    const VectorArc arc{.center = {50, 50}, .major = {10, 0}, .sweep = 2 * std::numbers::pi};
    for (int i = 0; i <= chords; ++i) {
        whole.points.push_back({.at = arc.at(2 * std::numbers::pi * i / chords)});
        if (i < chords) whole.pieces.push_back({.point = static_cast<std::uint32_t>(i)});
    }
    whole.curves.push_back({.first = 0, .last = chords, .arc = arc});
    for (const double side : {1.0, -1.0}) { // its first point is within the circle, or is not
        VectorDrawing drawing = drawing_of(whole);
        clip_to_circle(drawing, {50 + 10 * side, 50}, 10);
        ASSERT_EQ(drawing.paths.size(), 1U);
        const VectorPath& path = drawing.paths[0];
        EXPECT_FALSE(path.closed);
        ASSERT_EQ(path.curves.size(), 1U);
        const VectorArc& part = path.curves[0].arc;
        EXPECT_NEAR(part.sweep, 2 * std::numbers::pi / 3, 1e-9);
        for (const VectorPoint& end : {path.points.front(), path.points.back()}) {
            EXPECT_NEAR(end.at.x, 50 + 5 * side, 1e-9);
            EXPECT_NEAR(glm::distance(end.at, arc.center), 10, 1e-9);
        }
        EXPECT_LT(glm::distance(part.at(part.from), path.points.front().at), 1e-9);
        EXPECT_LT(glm::distance(part.at(part.from + part.sweep), path.points.back().at), 1e-9);
        EXPECT_EQ(path.curves[0].last, path.points.size() - 1);
        EXPECT_EQ(path.pieces.size(), path.points.size() - 1);
        for (std::size_t i = 0; i < path.pieces.size(); ++i) EXPECT_EQ(path.pieces[i].point, i);
    }
    VectorDrawing within = drawing_of(whole), beside = drawing_of(whole);
    clip_to_circle(within, {50, 50}, 11);
    clip_to_circle(beside, {50, 50}, 9);
    EXPECT_TRUE(within.paths.at(0).closed);
    EXPECT_TRUE(beside.paths.empty());
}

TEST(Sheet, ASmallDetailOfALargeCurveHasIt) {
    constexpr double large = 3000, small = 10, radians = 2 * std::numbers::pi;
    for (const double ratio : {1.0, 0.5}) {
        const VectorArc arc{.major = {large, 0}, .ratio = ratio, .sweep = -radians};
        for (int i = 0; i < 100; ++i) {
            SCOPED_TRACE(i);
            const glm::dvec2 center = arc.at(0.05 + 0.0601 * i);
            VectorDrawing drawing = drawing_of(arc_path(arc, 48));
            clip_to_circle(drawing, center, small);
            ASSERT_EQ(drawing.paths.size(), 1U);
            const VectorPath& part = drawing.paths[0];
            EXPECT_NEAR(glm::distance(part.points.front().at, center), small, 1e-7);
            EXPECT_NEAR(glm::distance(part.points.back().at, center), small, 1e-7);
            EXPECT_NEAR(glm::distance(part.points.front().at, part.points.back().at), 2 * small,
                        0.001);
        }
    }
    VectorPath curve{.points = {{.at = {0, 0}}, {.at = {3000, 0}}},
                     .pieces = {{.point = 0}},
                     .curves = {{.first = 0, .last = 1}}};
    curve.curves[0].cubic = {{1000, 400}, {2000, 400}}; // x is 3000 t
    for (int i = 1; i < 100; ++i) {
        SCOPED_TRACE(i);
        const double t = i / 100.0;
        VectorDrawing drawing = drawing_of(curve);
        clip_to_circle(drawing, {3000 * t, 1200 * t * (1 - t)}, 2);
        ASSERT_EQ(drawing.paths.size(), 1U);
        const VectorPath& part = drawing.paths[0];
        EXPECT_NEAR(glm::distance(part.points.front().at, part.points.back().at), 4, 0.001);
    }
}

TEST(Sheet, APathThatStartsOnTheCircleOfADetailIsNotTurnedInsideOut) {
    const glm::dvec2 center{1234.5, 678.9};
    constexpr double radius = 37.7;
    const auto at = [&](double distance, double angle) {
        return center + distance * glm::dvec2{std::cos(angle), std::sin(angle)};
    };
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const double angle = 0.03 * i;
        VectorDrawing drawing = drawing_of({.points = {{.at = at(radius, angle)},
                                                       {.at = at(2 * radius, angle)},
                                                       {.at = at(2 * radius, angle + 0.5)},
                                                       {.at = at(radius, angle + 0.5)},
                                                       {.at = center}},
                                            .pieces = {}});
        clip_to_circle(drawing, center, radius);
        ASSERT_EQ(drawing.paths.size(), 1U);
        const std::vector<VectorPoint>& points = drawing.paths[0].points;
        ASSERT_EQ(points.size(), 2U);
        EXPECT_LT(glm::distance(points[0].at, at(radius, angle + 0.5)), 1e-6);
        EXPECT_EQ(points[1].at, center);
    }
}

TEST(Sheet, WhatTouchesTheCircleOfADetailStaysWhole) {
    const VectorPath touching{.points = {{.at = {0, 10}}, {.at = {100, 10}}}, .pieces = {}};
    VectorDrawing outside = drawing_of(touching);
    clip_to_circle(outside, {50, 50}, 40);
    EXPECT_TRUE(outside.paths.empty());
    for (const double radius : {40.0, 15.0}) { // the same circle, and one that touches it within
        const VectorArc arc{
            .center = {90 - radius, 50}, .major = {radius, 0}, .sweep = 2 * std::numbers::pi};
        for (const double from : {0.0, 1.0}) {
            VectorArc turned = arc;
            turned.from = from;
            VectorDrawing drawing = drawing_of(arc_path(turned, 24));
            clip_to_circle(drawing, {50, 50}, 40);
            ASSERT_EQ(drawing.paths.size(), 1U);
            EXPECT_TRUE(drawing.paths[0].closed);
            EXPECT_EQ(drawing.paths[0].curves[0].arc.sweep, arc.sweep);
        }
    }
}

TEST(Sheet, CubicsLinesAndAreasAreClipped) {
    VectorPath curve{.points = {{.at = {40, 50}}, {.at = {50, 43.875}}, {.at = {60, 50}}},
                     .pieces = {{.point = 0}, {.point = 1}},
                     .curves = {{.first = 0, .last = 2}}};
    curve.curves[0].cubic = {{42, 41.8}, {58, 41.9}};
    VectorDrawing drawing = drawing_of(curve);
    clip_to_circle(drawing, {60, 50}, 8);
    const VectorPath& part = drawing.paths.at(0);
    EXPECT_NEAR(glm::distance(part.points.front().at, {60, 50}), 8, 1e-9);
    EXPECT_EQ(part.points.back().at, (glm::dvec2{60, 50}));
    ASSERT_TRUE(part.curves.at(0).cubic);
    const auto at = [](glm::dvec2 a, const VectorCubic& c, glm::dvec2 d, double t) {
        const double s = 1 - t;
        return s * s * s * a + 3 * s * s * t * c.first_control + 3 * s * t * t * c.last_control +
               t * t * t * d;
    };
    double nearest = 1e9; // the middle of the part lies on the whole
    const glm::dvec2 middle =
        at(part.points.front().at, *part.curves[0].cubic, part.points.back().at, 0.5);
    for (int i = 0; i <= 100000; ++i)
        nearest = std::min(nearest, glm::distance(middle, at({40, 50}, *curve.curves[0].cubic,
                                                             {60, 50}, i / 100000.0)));
    EXPECT_LT(nearest, 1e-4);

    VectorPath line{.points = {{.at = {0, 50}, .depth = 0.25}, {.at = {100, 50}, .depth = 0.75}},
                    .pieces = {{.point = 0, .from = 0, .to = 0.5F}, {.point = 0, .from = 0.5F}}};
    VectorDrawing straight = drawing_of(line);
    straight.fills.push_back({.object = {}, .rings = {{{0, 0}, {100, 0}, {100, 100}, {0, 100}}}});
    straight.fills.push_back({.object = {}, .rings = {{{0, 0}, {10, 0}, {10, 10}}}});
    clip_to_circle(straight, {60, 50}, 20);
    ASSERT_EQ(straight.paths.size(), 1U);
    const VectorPath& rest = straight.paths[0];
    EXPECT_NEAR(rest.points[0].at.x, 40, 1e-9);
    EXPECT_NEAR(rest.points[1].at.x, 80, 1e-9);
    EXPECT_NEAR(rest.points[0].depth, 0.45, 1e-9);
    ASSERT_EQ(rest.pieces.size(), 2U);
    EXPECT_NEAR(rest.pieces[0].to, 0.25F, 1e-6F);
    EXPECT_NEAR(rest.pieces[1].from, 0.25F, 1e-6F);
    ASSERT_EQ(straight.fills.size(), 1U);
    double area = 0;
    const std::vector<glm::dvec2>& ring = straight.fills[0].rings.at(0);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        area += 0.5 * (a.x * b.y - a.y * b.x);
    }
    EXPECT_NEAR(area, std::numbers::pi * 400, 0.05);
}

} // namespace
} // namespace lineatlas
