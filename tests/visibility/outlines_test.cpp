// Outlines and pens by rule, with known answers: the lines beside the background, in paths and in
// pictures, and the pen of every line.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/line_pens.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"
#include "test_meshes.hpp"
#include "vector/line_groups.hpp"

#include <gtest/gtest.h>

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 size{400, 300};

Style with_outline(float width = 6) {
    Style style;
    style.pens.push_back({.match = {.kinds = {"outline"}}, .width = width});
    return style;
}

Camera corner_view(const LineSet& lines, bool parallel = false) {
    return make_camera(
        {.eye = {6, 5, 8},
         .target = {0, 0, 0},
         .projection = parallel ? Projection::orthographic : Projection::perspective},
        size, lines.bounds);
}

VectorDrawing drawing_of(const LineSet& lines, const Camera& camera, const Style& style) {
    LineVisibility visibility{lines};
    const std::vector<Interval> seen = visibility.find(camera, {.hidden = true, .outlines = true});
    return make_vector_drawing(lines, camera, seen, style, {.outlines = visibility.outlines()});
}

double length_of(const VectorPath& path) {
    double length = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i)
        length += glm::distance(path.points[i - 1].at, path.points[i].at);
    return length;
}

double length_of(const VectorDrawing& drawing, bool outline) {
    double length = 0;
    for (const VectorPath& path : drawing.paths)
        if (path.outline == outline) length += length_of(path);
    return length;
}

double length_of(const std::vector<OutlinePart>& parts) {
    double length = 0;
    for (const OutlinePart& part : parts)
        length += static_cast<double>(glm::distance(part.start, part.end));
    return length;
}

glm::dvec2 on_screen(const Camera& camera, glm::vec3 point) {
    const glm::dvec4 clip =
        glm::dmat4{camera.projection} * glm::dmat4{camera.view} * glm::dvec4{glm::dvec3{point}, 1};
    return {(clip.x / clip.w + 1) * 0.5 * size.x, (1 - clip.y / clip.w) * 0.5 * size.y};
}

/// The number of ends of the outline's paths that have no other end within `gap`.
int loose_ends(const VectorDrawing& drawing, double gap) {
    std::vector<glm::dvec2> ends;
    for (const VectorPath& path : drawing.paths) {
        if (!path.outline || path.closed) continue;
        ends.push_back(path.points.front().at);
        ends.push_back(path.points.back().at);
    }
    int loose = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
        bool met = false;
        for (std::size_t k = 0; k < ends.size(); ++k)
            met = met || (k != i && glm::distance(ends[i], ends[k]) <= gap);
        loose += met ? 0 : 1;
    }
    return loose;
}

/// A box from low to high as a group of the mesh.
void add_box(Mesh& mesh, glm::vec3 low, glm::vec3 high, const MeshGroup& group) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const Mesh box = cube();
    for (const glm::vec3 at : box.positions)
        mesh.positions.push_back(low + (high - low) * (at * 0.5F + 0.5F));
    for (const glm::uvec3 triangle : box.triangles) {
        mesh.triangles.push_back(triangle + first);
        mesh.triangle_group.push_back(static_cast<std::uint32_t>(mesh.groups.size()));
    }
    mesh.groups.push_back(group);
}

TEST(Outlines, ReachTheTipsOfAcuteCorners) {
    // A flat pyramid from above. Its outline is its base, a triangle of 27, 63 and 90 degrees.
    Mesh mesh;
    mesh.positions = {{-2, -1, 0}, {2, -1, 0}, {2, 1, 0}, {1, -0.3F, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    const LineSet lines = extract_lines(mesh);
    for (const bool parallel : {false, true}) {
        SCOPED_TRACE(parallel);
        const Camera camera = make_camera(
            {.eye = {0, 0, 8},
             .target = {0, 0, 0},
             .projection = parallel ? Projection::orthographic : Projection::perspective},
            size, lines.bounds);
        double border = 0;
        for (int i = 0; i < 3; ++i)
            border += glm::distance(
                on_screen(camera, mesh.positions[static_cast<std::size_t>(i)]),
                on_screen(camera, mesh.positions[static_cast<std::size_t>((i + 1) % 3)]));
        const VectorDrawing drawing = drawing_of(lines, camera, with_outline());
        EXPECT_NEAR(length_of(drawing, true), border, 0.1);
        EXPECT_EQ(loose_ends(drawing, 0.1), 0);
    }
}

TEST(Outlines, OfACubeAreTheSixEdgesOfItsBorder) {
    const LineSet lines = extract_lines(cube());
    for (const bool parallel : {false, true}) {
        SCOPED_TRACE(parallel);
        const Camera camera = corner_view(lines, parallel);
        // The three edges at the corner towards the eye are the inner ones.
        double border = 0, within = 0;
        for (const float a : {-1.0F, 1.0F}) {
            for (const float b : {-1.0F, 1.0F}) {
                for (int axis = 0; axis < 3; ++axis) {
                    glm::vec3 p{0}, q{0};
                    p[axis] = -1;
                    q[axis] = 1;
                    p[(axis + 1) % 3] = q[(axis + 1) % 3] = a;
                    p[(axis + 2) % 3] = q[(axis + 2) % 3] = b;
                    const double length = glm::distance(on_screen(camera, p), on_screen(camera, q));
                    if (a > 0 && b > 0) within += length;
                    if (a * b < 0) border += length;
                }
            }
        }
        const VectorDrawing drawing = drawing_of(lines, camera, with_outline());
        EXPECT_NEAR(length_of(drawing, true), border, 0.1);
        EXPECT_NEAR(length_of(drawing, false), within, 0.1);
        EXPECT_EQ(loose_ends(drawing, 0.05), 0);
        for (const VectorPath& path : drawing.paths)
            EXPECT_EQ(drawing.pens.at(path.pen).width, path.outline ? 6 : 2);
    }
}

TEST(Outlines, WhatStandsBeforeAnotherHasNone) {
    Mesh mesh;
    add_box(mesh, {-3, -3, -3}, {3, 3, -2}, {.object = "back", .material = ""});
    add_box(mesh, {-1, -1, 0}, {1, 1, 1}, {.object = "front", .material = ""});
    const LineSet lines = extract_lines(mesh);
    const Camera camera =
        make_camera({.eye = {0.5F, 0.4F, 20}, .target = {0, 0, 0}}, size, lines.bounds);
    Style style = with_outline();
    style.pens.push_back({.match = {.object = "front"}, .color = glm::vec3{1, 0, 0}});
    const VectorDrawing drawing = drawing_of(lines, camera, style);
    double front = 0;
    for (const VectorPath& path : drawing.paths) {
        const bool red = drawing.pens.at(path.pen).color == glm::vec3{1, 0, 0};
        EXPECT_FALSE(red && path.outline);
        front += red ? length_of(path) : 0;
    }
    EXPECT_GT(front, 100);
    EXPECT_EQ(loose_ends(drawing, 0.05), 0);
    // Half beside it, the one before ends the drawing too.
    const Camera aside =
        make_camera({.eye = {14, 0.4F, 14}, .target = {0, 0, 0}}, size, lines.bounds);
    const VectorDrawing other = drawing_of(lines, aside, style);
    EXPECT_TRUE(std::ranges::any_of(other.paths, [&](const VectorPath& path) {
        return path.outline && other.pens.at(path.pen).color == glm::vec3{1, 0, 0};
    }));
    EXPECT_EQ(loose_ends(other, 2), 0);
}

TEST(Outlines, OfASphereAreClosed) {
    const LineSet lines = extract_lines(sphere(5));
    const Camera camera = corner_view(lines, true);
    const VectorDrawing drawing = drawing_of(lines, camera, with_outline());
    const double radius = glm::distance(
        on_screen(camera, {0, 0, 0}),
        on_screen(camera, glm::normalize(glm::cross(glm::vec3{6, 5, 8}, glm::vec3{0, 1, 0}))));
    const double around = 2 * std::numbers::pi * radius;
    EXPECT_NEAR(length_of(drawing, true), around, 0.02 * around);
    EXPECT_LT(length_of(drawing, false), 0.02 * around);
    EXPECT_EQ(loose_ends(drawing, 2), 0);
}

TEST(Outlines, ThinPartsHaveNone) {
    // In the view from the front a unit has 40 pixels. The strips are 4, 10, 20 and 80 pixels wide.
    for (const auto& [pixels, depth, has_one] : {std::tuple{4, 6.0F, false},
                                                 {10, 6.0F, true},
                                                 {10, 12.0F, false},
                                                 {20, 12.0F, true},
                                                 {80, 12.0F, true},
                                                 {4, 0.0F, true}}) {
        SCOPED_TRACE(pixels);
        Mesh mesh;
        const float half = static_cast<float>(pixels) / 80;
        mesh.positions = {{-half, -2, 0}, {half, -2, 0}, {half, 2, 0}, {-half, 2, 0}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
        const LineSet lines = extract_lines(mesh);
        const View view{.eye = {0, 0, 20}, .projection = Projection::orthographic};
        const Camera camera = make_camera(with_shown_height(view, 7.5F), size, lines.bounds);
        LineVisibility visibility{lines};
        visibility.find(camera, {.outlines = true, .outline_depth = depth});
        // The short ends of a thin strip have a deep body beside them.
        const double ends = 2.0 * pixels, sides = 2.0 * 4 * 40;
        EXPECT_NEAR(length_of(visibility.outlines()), ends + (has_one ? sides : 0), 0.5);
        const gl::HeadlessContext context;
        Renderer renderer;
        renderer.set_lines(lines);
        FrameOptions options;
        options.style = with_outline(depth / 2);
        options.intervals = KeptIntervals::visible;
        options.draw = false;
        options.method = Method::atlas;
        if (depth == 0) continue; // no pen
        renderer.draw(camera, options, 0);
        EXPECT_NEAR(length_of(renderer.read_outlines()), ends + (has_one ? sides : 0), 8);
    }
}

/// A plate from -1 to 1 with a round through hole, seen from z. Its thickness is `depth`.
Mesh plate_with_hole(float radius, float depth) {
    constexpr std::uint32_t sides = 48;
    Mesh mesh;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / sides;
        const glm::vec2 round{std::cos(angle), std::sin(angle)};
        const glm::vec2 square = round / std::max(std::abs(round.x), std::abs(round.y));
        for (const float z : {-0.5F * depth, 0.5F * depth})
            for (const glm::vec2 at : {square, radius * round}) mesh.positions.emplace_back(at, z);
    }
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.emplace_back(a, b, c);
        mesh.triangles.emplace_back(a, c, d);
    };
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t a = 4 * i, b = 4 * ((i + 1) % sides);
        quad(a + 2, b + 2, b + 3, a + 3); // the front
        quad(b, a, a + 1, b + 1);
        quad(a, b, b + 2, a + 2);
        quad(b + 1, a + 1, a + 3, b + 3); // the wall of the hole
    }
    return mesh;
}

TEST(Outlines, RimsOfThroughHolesHaveNone) {
    const LineSet lines = extract_lines(plate_with_hole(0.5F, 0.2F));
    for (const glm::vec3 eye : {glm::vec3{0, 0, 20}, glm::vec3{6, 4, 20}}) {
        for (const float height : {2.6F, 0.9F}) {
            SCOPED_TRACE(height + eye.x);
            const View view{.eye = eye, .projection = Projection::orthographic};
            const Camera camera = make_camera(with_shown_height(view, height), size, lines.bounds);
            const VectorDrawing drawing = drawing_of(lines, camera, with_outline());
            double rim = 0, outline_of_rim = 0, outline_of_plate = 0;
            for (const VectorPath& path : drawing.paths) {
                if (!path.visible) continue;
                EXPECT_EQ(drawing.pens.at(path.pen).width, path.outline ? 6 : 2);
                const bool at_hole = glm::length(glm::dvec2{path.points.front().world}) < 0.6;
                if (at_hole) rim += length_of(path);
                if (path.outline) (at_hole ? outline_of_rim : outline_of_plate) += length_of(path);
            }
            EXPECT_GT(rim, 200);
            // In the larger picture the hole is not seen as a whole: it may be a bay.
            EXPECT_EQ(outline_of_rim > 0, height < 1);
            EXPECT_EQ(outline_of_plate > 0, height > 1);
        }
    }
}

TEST(Outlines, BetweenPiecesAreThereAsAroundThem) {
    // Four beams, each before the next: nothing but the picture joins them.
    Mesh mesh;
    add_box(mesh, {-3, 1, 0.3F}, {3, 2, 0.4F}, {});
    add_box(mesh, {-3, -2, 0.2F}, {3, -1, 0.25F}, {});
    add_box(mesh, {-2.5F, -3, 0}, {-1.5F, 3, 0.1F}, {});
    add_box(mesh, {1.5F, -3, -0.3F}, {2.5F, 3, -0.2F}, {});
    const LineSet lines = extract_lines(mesh);
    const View view{.eye = {0, 0, 20}, .projection = Projection::orthographic};
    const Camera camera = make_camera(with_shown_height(view, 8), size, lines.bounds);
    double outline = 0;
    for (const VectorPath& path : drawing_of(lines, camera, with_outline()).paths) {
        if (!path.visible || !path.outline) continue;
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const glm::dvec2 a{path.points[i - 1].world}, b{path.points[i].world};
            const glm::dvec2 middle = 0.5 * (a + b);
            if (std::abs(middle.x) < 1.51 && std::abs(middle.y) < 1.01)
                outline += glm::distance(glm::clamp(a, -1.51, 1.51), glm::clamp(b, -1.51, 1.51));
        }
    }
    EXPECT_NEAR(outline, 2 * (3 + 2), 0.2) << "the window of 3 by 2";
}

TEST(Outlines, EndWhereTheGroundBesideALineChanges) {
    // A beam along x, and below it a window that a wire closes on one side.
    Mesh mesh;
    const MeshGroup group{.object = "frame", .material = ""};
    add_box(mesh, {-3, 0, -0.1F}, {3, 1, 0.1F}, group);            // the beam
    add_box(mesh, {-3, -2, -0.1F}, {-2.5F, 0, 0.1F}, group);       // a post
    add_box(mesh, {-3, -2.4F, -0.1F}, {0, -2, 0.1F}, group);       // a sill
    add_box(mesh, {0, -2.4F, -0.1F}, {0.02F, 0.5F, 0.15F}, group); // the wire
    const LineSet lines = extract_lines(mesh);
    const View view{.eye = {0, 0, 20}, .projection = Projection::orthographic};
    const Camera camera = make_camera(with_shown_height(view, 6), size, lines.bounds);
    const VectorDrawing drawing = drawing_of(lines, camera, with_outline());
    double outline = 0, inside = 0;
    for (const VectorPath& path : drawing.paths) {
        if (!path.visible) continue;
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const glm::dvec3 a = path.points[i - 1].world, b = path.points[i].world;
            if (std::abs(a.y) > 0.01 || std::abs(b.y) > 0.01) continue;
            const double left = std::min(a.x, b.x), right = std::max(a.x, b.x);
            if (!path.outline) continue;
            outline += std::max(0.0, right - std::max(left, 0.0));
            inside += std::max(0.0, std::min(right, 0.0) - left);
        }
    }
    // Pixels are 0.02 wide.
    EXPECT_NEAR(outline, 3, 0.1);
    EXPECT_NEAR(inside, 0, 0.1);
}

TEST(Pens, EveryRuleThatMatchesChangesWhatItNames) {
    Mesh mesh;
    add_box(mesh, {-3, -1, -1}, {-1, 1, 1}, {.object = "Bolt 7", .material = "steel"});
    add_box(mesh, {1, -1, -1}, {3, 1, 1}, {.object = "Nut", .material = "steel"});
    const LineSet lines = extract_lines(mesh);
    const Camera camera = corner_view(lines);
    Style style;
    style.pens = {{.match = {.kinds = {"crease"}}, .width = 1},
                  {.match = {.material = "steel"}, .color = glm::vec3{0, 0, 1}},
                  {.match = {.object = "Bolt*"}, .width_factor = 2},
                  {.match = {.kinds = {"outline"}, .object = "N?t"}, .width = 5}};
    const VectorDrawing drawing = drawing_of(lines, camera, style);
    for (const VectorPath& path : drawing.paths) {
        const bool bolt = path.points.front().world.x < 0;
        const Pen& pen = drawing.pens.at(path.pen);
        EXPECT_EQ(pen.color, (glm::vec3{0, 0, 1}));
        EXPECT_EQ(pen.width, bolt ? 4 : path.outline ? 5 : 1);
    }
    std::vector<std::string> names;
    for (const LineGroup& group : line_groups(drawing)) names.push_back(group.name());
    EXPECT_EQ(names, (std::vector<std::string>{"crease", "crease-2", "outline", "outline-2"}));
}

TEST(Pens, OfPicturesAreThoseOfTheRules) {
    const gl::HeadlessContext context;
    Renderer renderer;
    const LineSet lines = extract_lines(cube());
    renderer.set_lines(lines);
    const Camera camera = corner_view(lines);
    gl::Canvas canvas{size};
    const auto ink = [&](Method method, const Style& style) {
        canvas.clear(glm::vec4{1});
        FrameOptions options;
        options.method = method;
        options.style = style;
        renderer.draw(camera, options, canvas.framebuffer());
        const std::vector<std::uint8_t> pixels = canvas.read();
        std::array<double, 3> sum{};
        for (std::size_t i = 0; i < pixels.size(); ++i)
            if (i % 4 < 3) sum[i % 4] += (255 - pixels[i]) / 255.0;
        return sum;
    };
    const VectorDrawing drawing = drawing_of(lines, camera, with_outline());
    Style style = with_outline();
    style.pens.front().color = glm::vec3{1, 0, 0}; // absorbs green and blue, but not red
    for (const Method method : {Method::exact, Method::atlas}) {
        SCOPED_TRACE(static_cast<int>(method));
        const std::array<double, 3> found = ink(method, style);
        // The outline covers an end of each of the three inner lines.
        const double within = 2 * (length_of(drawing, false) - 3 * 3);
        const double border = 6 * length_of(drawing, true);
        EXPECT_NEAR(found[0], within, 0.06 * within);
        EXPECT_NEAR(found[1] - found[0], border, 0.04 * border);
    }
    // One rule for all lines gives the same as a style with that width.
    Style ruled, plain;
    ruled.pens.push_back({.match = {}, .width = 5});
    plain.pen.width = 5;
    EXPECT_EQ(ink(Method::exact, ruled), ink(Method::exact, plain));
}

TEST(Pens, OfALineChangeWhereItsOutlineBegins) {
    // The left half of a box has a larger one behind it, the right half the background.
    Mesh mesh;
    add_box(mesh, {-1, -1, -1}, {1, 1, 1}, {});
    add_box(mesh, {-4, -4, -4}, {0, 4, -3}, {});
    const LineSet lines = extract_lines(mesh);
    const gl::HeadlessContext context;
    Renderer renderer;
    renderer.set_lines(lines);
    const Camera camera =
        make_camera({.eye = {0, 0, 30}, .target = {0, 0, 0}, .fov_y = 0.4F, .near = 1, .far = 60},
                    size, lines.bounds);
    FrameOptions options;
    options.style = with_outline();
    options.style.pens.front().color = glm::vec3{1, 0, 0};
    for (const Method method : {Method::exact, Method::atlas}) {
        SCOPED_TRACE(static_cast<int>(method));
        options.method = method;
        gl::Canvas canvas{size};
        canvas.clear(glm::vec4{1});
        renderer.draw(camera, options, canvas.framebuffer());
        const std::vector<std::uint8_t> pixels = canvas.read();
        const auto red_at = [&](glm::vec3 place) {
            const glm::vec4 clip = camera.clip_from_world() * glm::vec4{place, 1};
            const glm::ivec2 at{(glm::vec2{clip} / clip.w + 1.0F) * 0.5F * glm::vec2{size}};
            return int{pixels[4 * static_cast<std::size_t>(at.y * size.x + at.x)]};
        };
        for (const float y : {-1.0F, 1.0F}) {
            for (const float x : {0.2F, 0.5F, 0.8F}) {
                EXPECT_GT(red_at({x, y, 1}), 200) << x << ", " << y;
                EXPECT_LT(red_at({-x, y, 1}), 100) << -x << ", " << y;
            }
        }
    }
}

/// A cube drawn with hidden lines: creases behind it green, all other hidden lines dotted.
Style with_hidden_rules() {
    Style style;
    style.hidden = true;
    style.hidden_pen = {.mark = "solid", .width = 2, .color = {0, 0, 1}};
    style.pens = {{.match = {.kinds = {"crease"}}, .width = 3},
                  {.match = {.kinds = {"crease"}, .object = "right", .hidden = true},
                   .width_factor = 2,
                   .color = glm::vec3{0, 1, 0}},
                  {.match = {.kinds = {"crease"}, .hidden = true}, .opacity = 0.5F}};
    return style;
}

/// Two boxes side by side. The right one is another object, "right".
LineSet two_boxes() {
    Mesh mesh;
    add_box(mesh, {-3, -1, -1}, {-1, 1, 1}, {.object = "left", .material = ""});
    add_box(mesh, {1, -1, -1}, {3, 1, 1}, {.object = "right", .material = ""});
    return extract_lines(mesh);
}

TEST(Pens, HiddenLinesHaveRulesOfTheirOwn) {
    const LineSet lines = two_boxes();
    const VectorDrawing drawing = drawing_of(lines, corner_view(lines), with_hidden_rules());
    std::size_t hidden = 0;
    for (const VectorPath& path : drawing.paths) {
        const Pen& pen = (path.visible ? drawing.pens : drawing.hidden_pens).at(path.pen);
        const bool right = path.points.front().world.x > 0;
        EXPECT_EQ(pen.width, path.visible ? 3 : right ? 4 : 2);
        EXPECT_EQ(pen.opacity, path.visible ? 1 : 0.5F);
        if (path.visible) continue;
        EXPECT_EQ(pen.color, right ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1));
        ++hidden;
    }
    EXPECT_EQ(hidden, 6U);
    std::vector<std::string> names;
    std::vector<float> widths;
    for (const LineGroup& group : line_groups(drawing)) {
        names.push_back(group.name());
        widths.push_back(group.pen.width);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"crease-hidden", "crease-hidden-2", "crease"}));
    EXPECT_EQ(widths, (std::vector<float>{2, 4, 3}));
    // Rules for hidden lines do not change visible ones, and the other way round.
    Style style = with_hidden_rules();
    style.pens.erase(style.pens.begin());
    EXPECT_EQ(drawing_of(lines, corner_view(lines), style).pens.size(), 1U);
    style = with_hidden_rules();
    style.pens.resize(1);
    EXPECT_EQ(drawing_of(lines, corner_view(lines), style).hidden_pens.size(), 1U);
    // A rule for lines that are not drawn is reported as idle.
    EXPECT_TRUE(idle_rules(line_classes(lines), with_hidden_rules()).empty());
    style = with_hidden_rules();
    style.hidden = false;
    ASSERT_EQ(idle_rules(line_classes(lines), style).size(), 1U);
    EXPECT_NE(idle_rules(line_classes(lines), style)[0].find("hidden = true"), std::string::npos);
}

TEST(Pens, OfHiddenLinesOfPicturesAreThoseOfTheRules) {
    const gl::HeadlessContext context;
    Renderer renderer;
    const LineSet lines = two_boxes();
    renderer.set_lines(lines);
    const Camera camera = corner_view(lines);
    gl::Canvas canvas{size};
    Style style = with_hidden_rules();
    style.pens.pop_back(); // all opaque: lengths can be told from ink
    style.pen.color = {1, 1, 1};
    const VectorDrawing drawing = drawing_of(lines, camera, style);
    for (const Method method : {Method::exact, Method::atlas}) {
        SCOPED_TRACE(static_cast<int>(method));
        canvas.clear(glm::vec4{1});
        FrameOptions options;
        options.method = method;
        options.style = style;
        renderer.draw(camera, options, canvas.framebuffer());
        const std::vector<std::uint8_t> pixels = canvas.read();
        std::array<double, 3> ink{};
        for (std::size_t i = 0; i < pixels.size(); ++i)
            if (i % 4 < 3) ink[i % 4] += (255 - pixels[i]) / 255.0;
        double green = 0, blue = 0;
        for (const VectorPath& path : drawing.paths) {
            if (path.visible) continue;
            const bool right = path.points.front().world.x > 0;
            (right ? green : blue) += (right ? 4 : 2) * length_of(path);
        }
        // Green lines absorb red and blue, and blue ones red and green. Ends of visible lines cover
        // some of them.
        EXPECT_NEAR(ink[2], green, 0.1 * green);
        EXPECT_NEAR(ink[1], blue, 0.1 * blue);
    }
}

TEST(Pens, LengthsGrowWithThePicture) {
    const LineSet lines = extract_lines(cube());
    Style style = with_outline(6);
    style.made_for = 150; // the picture is twice as large
    const VectorDrawing drawing = drawing_of(lines, corner_view(lines), style);
    EXPECT_EQ(drawing.pens.front().width, 4);
    EXPECT_EQ(drawing.pens.back().width, 12);
    style.made_for = 600; // the picture is half as large: thinner lines would fade
    EXPECT_EQ(drawing_of(lines, corner_view(lines), style).pens.back().width, 6);
}

TEST(Outlines, TakeMemoryByTheVisibleSegments) {
    const gl::HeadlessContext context;
    Mesh mesh = cube();
    for (int i = 0; i < 1000; ++i) { // behind the first, and smaller
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        const glm::vec3 at{0, 0, -2 - 0.5F * static_cast<float>(i)};
        const Mesh other = cube();
        for (const glm::vec3& p : other.positions) mesh.positions.push_back(0.1F * p + at);
        for (const glm::uvec3& t : other.triangles) mesh.triangles.push_back(t + first);
    }
    const LineSet lines = extract_lines(mesh);
    const Camera camera = make_camera({.eye = {0, 0, 8}}, size, lines.bounds);
    const auto bytes = [&](const Style& style) {
        Renderer renderer;
        renderer.set_lines(lines);
        const FrameOptions options{.method = Method::exact, .style = style, .draw = false};
        const FrameStats stats = renderer.draw(camera, options, 0);
        EXPECT_GT(stats.runs, 3);
        EXPECT_LT(stats.runs, lines.segments.size() / 100);
        return stats.segment_bytes;
    };
    EXPECT_LT(bytes(with_outline()), bytes({}) + 32 * lines.segments.size());
}

TEST(Outlines, OfARendererAreThoseOfLineVisibility) {
    const gl::HeadlessContext context;
    Renderer renderer;
    const LineSet lines = extract_lines(sphere(4));
    renderer.set_lines(lines);
    const Camera camera = corner_view(lines);
    LineVisibility visibility{lines};
    visibility.find(camera, {.outlines = true, .outline_depth = 12});
    const std::vector<OutlinePart>& ours = visibility.outlines();
    FrameOptions options;
    options.style = with_outline();
    options.intervals = KeptIntervals::visible;
    options.draw = false;
    options.method = Method::exact;
    renderer.draw(camera, options, 0);
    const std::vector<OutlinePart> exact = renderer.read_outlines();
    ASSERT_EQ(exact.size(), ours.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
        EXPECT_EQ(exact[i].segment, ours[i].segment);
        EXPECT_LT(glm::distance(exact[i].start, ours[i].start), 1e-3F);
        EXPECT_LT(glm::distance(exact[i].end, ours[i].end), 1e-3F);
    }
    options.method = Method::atlas;
    renderer.draw(camera, options, 0);
    EXPECT_NEAR(length_of(renderer.read_outlines()), length_of(ours), 0.03 * length_of(ours));
    visibility.find(camera);
    EXPECT_TRUE(visibility.outlines().empty());
}

} // namespace
} // namespace lineatlas::test
