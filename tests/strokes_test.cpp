// Changes to strokes (§4.5) on small drawings with known answers, through the whole renderer:
// OpenCL and plain C++, raster and compute atlas, wrapped and with gutters. A unit is a pixel.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "compare.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas::test {
namespace {

using Runs = std::vector<Run>; // testing::Test has a Run of its own

constexpr int side = 400;
constexpr float front = 50; // depth of what hides lines; they lie at 0

Camera pixel_camera(glm::vec2 shift = {0, 0}) {
    Camera camera;
    camera.size = {side, side};
    camera.view = glm::lookAt(glm::vec3{shift, 200}, glm::vec3{shift, 0}, glm::vec3{0, 1, 0});
    camera.projection = glm::ortho(0.0F, float{side}, 0.0F, float{side}, 1.0F, 401.0F);
    return camera;
}

using Polyline = std::vector<glm::vec3>;

struct Scene {
    Mesh mesh;
    std::vector<Polyline> lines{};

    /// A loop where the last point is the first.
    void line(const Polyline& points) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), points.begin(), points.end());
        std::vector<std::uint32_t> indices;
        for (std::uint32_t i = 0; i < points.size(); ++i) indices.push_back(first + i);
        mesh.polylines.push_back(indices);
        lines.push_back(points);
    }
    /// Facing the eye, with corners in order around it.
    void sheet(const std::array<glm::vec2, 4>& corners, float z = front) {
        const auto a = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec2 corner : corners) mesh.positions.emplace_back(corner, z);
        mesh.triangles.emplace_back(a, a + 1, a + 2);
        mesh.triangles.emplace_back(a, a + 2, a + 3);
    }
    void box(glm::vec2 low, glm::vec2 high, float z = front) {
        sheet({low, {high.x, low.y}, high, {low.x, high.y}}, z);
    }
    /// So many hidden segments in a corner that hidden ones are culled.
    void crowd() {
        box({2, 2}, {40, 40});
        Polyline points;
        for (int y = 0; y < 105; ++y) {
            for (int x = 0; x < 105; ++x) {
                const int turned = y % 2 == 0 ? x : 104 - x;
                points.emplace_back(8 + 0.25F * static_cast<float>(turned),
                                    8 + 0.25F * static_cast<float>(y), 0);
            }
        }
        line(points);
    }
};

/// A stretch of a polyline, pixels from its start.
struct Stretch {
    double from, to;
};

float length_of(const Polyline& line) {
    float length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) length += glm::distance(line[i], line[i + 1]);
    return length;
}

bool is_closed(const Polyline& line) {
    return line.front() == line.back();
}

/// What is drawn of a polyline, from the places of the runs alone; touching pieces are one.
std::vector<Stretch> drawn_of(const LineSet& set, const Runs& runs, const Polyline& line) {
    std::vector<Stretch> pieces;
    for (const Run& run : runs) {
        const glm::vec3 p = set.vertices[set.segments[run.segment].p];
        const glm::vec3 q = set.vertices[set.segments[run.segment].q];
        float arc = 0;
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const bool same = p == line[i] && q == line[i + 1];
            if (same || (q == line[i] && p == line[i + 1])) {
                const glm::vec2 along = glm::normalize(glm::vec2{line[i + 1] - line[i]});
                const glm::vec2 from = glm::vec2{run.start[0], run.start[1]} - glm::vec2{line[i]};
                const glm::vec2 to = glm::vec2{run.end[0], run.end[1]} - glm::vec2{line[i]};
                EXPECT_NEAR(along.x * from.y - along.y * from.x, 0, 0.1);
                const double a = arc + glm::dot(from, along), b = arc + glm::dot(to, along);
                pieces.push_back({std::min(a, b), std::max(a, b)});
            }
            arc += glm::distance(line[i], line[i + 1]);
        }
    }
    std::ranges::sort(pieces, {}, &Stretch::from);
    std::vector<Stretch> strokes;
    for (const Stretch& piece : pieces) {
        if (!strokes.empty() && piece.from - strokes.back().to < 0.1)
            strokes.back().to = std::max(strokes.back().to, piece.to);
        else
            strokes.push_back(piece);
    }
    // A loop's first and last piece may be one.
    if (is_closed(line) && strokes.size() > 1 && strokes.front().from < 0.1 &&
        strokes.back().to > length_of(line) - 0.1) {
        strokes.back().to += strokes.front().to;
        strokes.erase(strokes.begin());
    }
    return strokes;
}

void expect_strokes(const std::vector<Stretch>& seen, const std::vector<Stretch>& expected,
                    double tolerance = 1) {
    std::string all;
    for (const Stretch& s : seen) {
        all += " " + std::to_string(s.from) + ".." + std::to_string(s.to);
    }
    ASSERT_EQ(seen.size(), expected.size()) << all;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        EXPECT_NEAR(seen[i].from, expected[i].from, tolerance) << all;
        EXPECT_NEAR(seen[i].to, expected[i].to, tolerance) << all;
    }
}

struct Drawing {
    LineSet set;
    Runs runs;
    std::vector<std::uint8_t> pixels;

    std::vector<Stretch> of(const Polyline& line) const { return drawn_of(set, runs, line); }
    /// 0 white to 1 black; y from below.
    double darkness(int x, int y) const {
        const auto at = (static_cast<std::size_t>(side - 1 - y) * side + std::size_t(x)) * 4;
        return 1 - pixels[at] / 255.0;
    }
    double column(int x, int low, int high) const {
        double sum = 0;
        for (int y = low; y < high; ++y) sum += darkness(x, y);
        return sum;
    }
    double row(int y, int low, int high) const {
        double sum = 0;
        for (int x = low; x < high; ++x) sum += darkness(x, y);
        return sum;
    }
};

struct Setting {
    std::string name, compute;
    AtlasForm form;
    AtlasLayoutChoice layout;
};

class Strokes : public testing::TestWithParam<Setting> {
  protected:
    Drawing draw(const Scene& scene, FrameOptions options, const Camera& camera = pixel_camera()) {
        // No turn is too sharp for a path to go on.
        Drawing drawing{extract_lines(scene.mesh, {.chain_angle = chain_angle_}), {}, {}};
        renderer_.set_lines(drawing.set);
        canvas_.clear(glm::vec4{1});
        options.atlas = GetParam().form;
        options.atlas_layout = GetParam().layout;
        if (options.lines == all_line_kinds) options.lines = mask_of(LineKind::file);
        renderer_.draw(camera, options, canvas_.framebuffer());
        drawing.runs = renderer_.read_samples().runs;
        drawing.pixels = canvas_.read();
        for (const lineatlas::Run& run : drawing.runs) EXPECT_LE(run.start_arc, run.end_arc);
        return drawing;
    }
    Drawing draw(const Scene& scene, const StrokeFilter& filter) {
        return draw(scene, FrameOptions{.style = {.filter = filter}});
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{side, side}};
    Renderer renderer_{{.compute = GetParam().compute}};
    float chain_angle_ = 3.1F;
};

/// Scenes once as they are and once where hidden segments are culled.
template <class Make, class Check>
void culled_or_not(Make&& make, Check&& check) {
    for (const bool culled : {false, true}) {
        SCOPED_TRACE(culled ? "culled" : "not culled");
        Scene scene = make();
        if (culled) scene.crowd();
        check(scene);
    }
}

/// Hidden from 150.3 to 250.6 of x.
Scene behind_a_box() {
    Scene scene;
    scene.line({{60.2F, 200.4F, 0}, {340.7F, 200.4F, 0}});
    scene.box({150.3F, 100}, {250.6F, 300});
    return scene;
}

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
            for (const lineatlas::Run& run : drawing.runs) { // what it says of its stroke
                bool found = false;
                for (const Polyline& line : scene.lines) {
                    for (const Stretch& s : drawing.of(line)) {
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

/// A circle as a loop of `count` segments.
Polyline circle(int count, float radius) {
    Polyline points;
    for (int i = 0; i < count; ++i) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / count;
        points.emplace_back(200.3F + radius * std::cos(angle), 200.1F + radius * std::sin(angle),
                            0);
    }
    points.push_back(points.front());
    return points;
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
        const std::vector<Stretch> strokes = draw(scene, {.overshoot = 12}).of(loop);
        ASSERT_EQ(strokes.size(), 1U);
        double from = (at + 40) / 360.0 * length - 12;
        if (from >= length) from -= length;
        // Either may be counted from the loop's other end.
        const double off = std::remainder(strokes[0].from - from, length);
        EXPECT_NEAR(off, 0, 1);
        EXPECT_NEAR(strokes[0].to - strokes[0].from, length * 320 / 360 + 24, 2);

        // With gaps of 4 pixels on either side of the sector's edges.
        FrameOptions options{.lines = mask_of(LineKind::file) | mask_of(LineKind::boundary)};
        options.style.filter = {.overshoot = 12, .halo = 3};
        double drawn = 0;
        for (const Stretch& s : draw(scene, options).of(loop)) drawn += s.to - s.from;
        EXPECT_NEAR(drawn, length * 320 / 360 + 24 - 16, 2);
    }
}

TEST_P(Strokes, OvershootStopsInTheMiddleOfWhatIsHidden) {
    Scene scene = behind_a_box();
    const Drawing drawing = draw(scene, {.overshoot = 60}); // more than half of what is hidden
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
        const std::vector<Stretch> a = still.of(line);
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
            Scene scene; // its last segment is hidden, and a wire crosses before the end
            scene.line({{60, 200.5F, 0}, {196, 200.5F, 0}, {199, 200.5F, 0}});
            scene.box({195.5F, 150}, {300, 250});
            scene.line({{197, 100, 100}, {197, 300, 100}});
            return scene;
        },
        [&](const Scene& scene) {
            const Drawing drawing = draw(scene, {.overshoot = 12, .halo = 3});
            expect_strokes(drawing.of(scene.lines[0]), {{-12, 133}, {141, 147.5}});
            for (int x = 203; x < 206; ++x) EXPECT_GT(drawing.darkness(x, 200), 0.98) << x;
        });
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
        expect_strokes(hole({.fill = 6}), {{0, 260}});
        expect_strokes(hole({.fill = 4}), {{0, at}, {at + 5, 260}});
        expect_strokes(run({.drop = 6}), {{0, at - 40}, {at + 45, 260}});
        expect_strokes(run({.drop = 4}), {{0, at - 40}, {at, at + 5}, {at + 45, 260}});
        // In this order: what is filled is not short.
        expect_strokes(hole({.fill = 6, .drop = 120}), {{0, 260}});
    }
}

TEST_P(Strokes, AFilledHoleIsInked) {
    const Scene scene = hole_and_run(0);
    EXPECT_NEAR(draw(scene, {.fill = 6}).row(300, 100, 320), 220 * 0.9, 25);
    const double filled = draw(scene, {.fill = 6}).row(300, 175, 190);
    const double whole = draw(scene, {.fill = 6}).row(300, 215, 230);
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
    const auto filled = both({.fill = 50});
    expect_strokes(filled[0], {{0, 190}});
    expect_strokes(filled[1], {{10, 220}});
    const auto grown = both({.overshoot = 12});
    expect_strokes(grown[0], {{-12, 190 + 12}});
    expect_strokes(grown[1], {{10 - 12, 220 + 12}});
    scene.box({83, 60}, {275, 90}); // leaves 3 pixels of the first one
    const auto dropped = both({.drop = 6, .overshoot = 12});
    expect_strokes(dropped[0], {});
    expect_strokes(dropped[1], {{10 - 12, 220 + 12}});
}

TEST_P(Strokes, CapsEndWhereTheyShould) {
    const auto pen = [&](Cap cap, Cap path_cap, float drop = 0.01F) {
        FrameOptions options;
        options.style.filter.drop = drop;
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
    // Where no effect needs whole strokes, visible runs fade out.
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

TEST_P(Strokes, HiddenLinesAreDrawnWithTheirPen) {
    FrameOptions options;
    options.style.hidden = true;
    options.style.pen = {.width = 4, .color = {1, 0, 0}};
    options.style.hidden_pen = {.mark = "solid", .width = 4, .color = {0, 0, 1}};
    Scene scene = behind_a_box();
    scene.line({{200.2F, 60, 100}, {200.2F, 340, 100}}); // crosses before what is hidden
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
        for (const StrokeShader shader : {StrokeShader::geometry, StrokeShader::vertex}) {
            options.stroke_shader = shader;
            options.style.focus.opacity = 0; // lines may be left out
            const Drawing without = draw(scene, options);
            options.style.focus.opacity = 1e-9F; // all are drawn, though they cannot be seen
            const Drawing with = draw(scene, options);
            EXPECT_TRUE(equal(without.pixels, with.pixels));
            EXPECT_GT(without.row(200, 0, side), 20);
        }
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
    for (const StrokeShader shader : {StrokeShader::geometry, StrokeShader::vertex}) {
        for (const Join join : {Join::mitre, Join::round, Join::bevel}) {
            for (const Cap cap : {Cap::butt, Cap::round}) {
                SCOPED_TRACE(std::to_string(static_cast<int>(shader)) + " " +
                             std::to_string(static_cast<int>(join)) + " " +
                             std::to_string(static_cast<int>(cap)));
                FrameOptions options{.stroke_shader = shader};
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
}

INSTANTIATE_TEST_SUITE_P(
    All, Strokes,
    testing::Values(
        Setting{"OpenclRasterWrap", "opencl", AtlasForm::raster, AtlasLayoutChoice::wrap},
        Setting{"OpenclRasterGutter", "opencl", AtlasForm::raster, AtlasLayoutChoice::gutter},
        Setting{"OpenclComputeWrap", "opencl", AtlasForm::compute, AtlasLayoutChoice::wrap},
        Setting{"OpenclComputeGutter", "opencl", AtlasForm::compute, AtlasLayoutChoice::gutter},
        Setting{"ReferenceRasterWrap", "reference", AtlasForm::raster, AtlasLayoutChoice::wrap},
        Setting{"ReferenceComputeGutter", "reference", AtlasForm::compute,
                AtlasLayoutChoice::gutter}),
    [](const auto& info) { return info.param.name; });

} // namespace
} // namespace lineatlas::test
