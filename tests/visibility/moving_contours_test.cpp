// Silhouettes of smooth surfaces that move. A ball moved by any matrix is an ellipsoid, and the
// outline of an ellipsoid is a known ellipse.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "glpasses/headless_context.hpp"
#include "lineatlas/assembly.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

namespace lineatlas::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double unit = 100; ///< pixels
const LineOptions smooth{.crease = std::numbers::pi_v<float>,
                         .separate_objects = true,
                         .silhouettes = Silhouettes::smooth};

Camera parallel_view(glm::vec3 to_eye) {
    Camera camera;
    camera.size = {400, 400};
    camera.view = glm::lookAt(10.0F * glm::normalize(to_eye), glm::vec3{0}, glm::vec3{0, 1, 0});
    camera.projection = glm::ortho(-2.0F, 2.0F, -2.0F, 2.0F, 1.0F, 20.0F);
    return camera;
}

const std::array views{glm::vec3{0, 0, 1}, glm::vec3{0.3F, 0.2F, 1}, glm::vec3{-0.2F, 0.5F, 1}};

glm::mat4 turned(float angle, glm::vec3 about) {
    return glm::rotate(glm::mat4{1}, angle, glm::normalize(about));
}
glm::mat4 scaled(glm::vec3 by) {
    return glm::scale(glm::mat4{1}, by);
}

/// Places apart from the other ball: turned, mirrored, stretched, skewed, and all of these smaller.
std::vector<glm::mat4> places() {
    const glm::mat4 at = glm::translate(glm::mat4{1}, {0.8F, -0.3F, 0});
    const glm::mat4 turn = turned(1.1F, {1, 2, 3}), other = turned(0.7F, {-2, 1, 1});
    return {at * turn, at * turn * scaled({-1, 1, 1}),
            at * turn * scaled({0.9F, 0.3F, 0.6F}) * other,
            at * turn * scaled({0.9F, -0.3F, 0.6F}) * other,
            at * turn * scaled({-0.1F, -0.2F, -0.3F}) * other};
}

/// Two balls as two objects: one of radius 0.3 that stays, and one of radius 1 about the origin.
Mesh two_balls() {
    Mesh mesh = sphere(4), small = sphere(3);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.triangle_object.assign(mesh.triangles.size(), 1);
    for (const glm::vec3 p : small.positions)
        mesh.positions.push_back(0.3F * p + glm::vec3{-1.4F, 0, 0});
    for (const glm::uvec3& t : small.triangles) mesh.triangles.push_back(t + first);
    mesh.triangle_object.resize(mesh.triangles.size(), 0);
    return mesh;
}

/// The ellipse on the screen that a ball of radius 1 becomes.
class Ellipse {
  public:
    Ellipse(const glm::mat4& world_from_ball, const Camera& camera) {
        const glm::dmat4 m = glm::dmat4{camera.view} * glm::dmat4{world_from_ball};
        centre_ = glm::dvec2{m[3]} * unit + 200.0;
        for (int k = 0; k < 3; ++k) {
            const glm::dvec2 way = glm::dvec2{m[k]} * unit;
            spread_ += glm::outerProduct(way, way);
        }
    }

    /// The distance of a point from the middle, as a share of the way to the ellipse.
    double share(glm::dvec2 at) const {
        const glm::dvec2 way = at - centre_;
        return std::sqrt(glm::dot(way, glm::inverse(spread_) * way));
    }

    double length() const {
        const double mean = (spread_[0][0] + spread_[1][1]) / 2;
        const double root = std::sqrt(std::max(mean * mean - glm::determinant(spread_), 0.0));
        const double a = std::sqrt(mean + root), b = std::sqrt(mean - root);
        constexpr int steps = 1000;
        double sum = 0;
        for (int i = 0; i < steps; ++i) {
            const double t = 2 * pi * (i + 0.5) / steps;
            sum += std::hypot(a * std::sin(t), b * std::cos(t)) * 2 * pi / steps;
        }
        return sum;
    }

  private:
    glm::dvec2 centre_{0};
    glm::dmat2 spread_{0};
};

/// The largest errors of a method.
struct Tolerance {
    double share, length;
};
constexpr Tolerance exactly{0.01, 0.01}, by_samples{0.06, 0.04};

/// The intervals of one object.
std::vector<Interval> of_object(const LineSet& lines, std::size_t object,
                                const std::vector<Interval>& all) {
    std::vector<Interval> own;
    for (const Interval& one : all) {
        const std::uint32_t vertex = lines.segments[one.segment].p;
        if (vertex - lines.objects[object].first_vertex < lines.objects[object].vertex_count)
            own.push_back(one);
    }
    return own;
}

void expect_ellipse(const std::vector<Interval>& found, const Ellipse& expected,
                    const Tolerance& tolerance) {
    double length = 0;
    for (const Interval& one : found) {
        const glm::dvec2 start{one.start[0], one.start[1]}, end{one.end[0], one.end[1]};
        ASSERT_NEAR(expected.share(start), 1, tolerance.share);
        length += glm::distance(start, end);
    }
    EXPECT_NEAR(length, expected.length(), tolerance.length * expected.length());
}

void expect_loops(const LineSet& lines, const Camera& camera, const std::vector<Interval>& found,
                  std::size_t count) {
    const VectorDrawing drawing = make_vector_drawing(lines, camera, found, Style{});
    EXPECT_EQ(drawing.paths.size(), count);
    for (const VectorPath& path : drawing.paths) EXPECT_TRUE(path.closed);
}

/// A renderer and its picture.
class Shown {
  public:
    explicit Shown(const char* device) : renderer{{.compute = device}} {}

    std::vector<Interval> by(Method method, const Camera& camera) {
        FrameOptions options{.method = method, .draw = false};
        options.intervals = KeptIntervals::visible;
        renderer.draw(camera, options, 0);
        return renderer.read_intervals();
    }

    Renderer renderer;
};

class MovingContours : public testing::TestWithParam<const char*> {
  protected:
    gl::HeadlessContext context_;
    Shown shown_{GetParam()};
};

TEST_P(MovingContours, OfABallAreTheEllipseThatItBecomes) {
    const LineSet lines = extract_lines(two_balls(), smooth);
    ASSERT_EQ(lines.objects.size(), 2U);
    shown_.renderer.set_lines(lines);
    for (const glm::mat4& place : places()) {
        const std::array transforms{glm::mat4{1}, place};
        shown_.renderer.set_transforms(transforms);
        LineSet moved = lines;
        move_objects(moved, transforms);
        LineVisibility visibility{moved, {.compute = GetParam()}};
        for (const glm::vec3 view : views) {
            SCOPED_TRACE(testing::Message() << place[0].x << ' ' << view.y);
            const Camera camera = parallel_view(view);
            const std::vector<Interval> found = shown_.by(Method::exact, camera);
            expect_ellipse(of_object(lines, 1, found), {place, camera}, exactly);
            const glm::mat4 small =
                glm::translate(glm::mat4{1}, {-1.4F, 0, 0}) * scaled(glm::vec3{0.3F});
            expect_ellipse(of_object(lines, 0, found), {small, camera}, exactly);
            expect_loops(moved, camera, found, 2);
            const std::vector<Interval> host = visibility.find(camera);
            expect_ellipse(of_object(lines, 1, host), {place, camera}, exactly);
            expect_loops(moved, camera, host, 2);
            expect_ellipse(of_object(lines, 1, shown_.by(Method::atlas, camera)), {place, camera},
                           by_samples);
        }
    }
}

/// The renderer draws moved objects like objects that were made at their new places.
TEST_P(MovingContours, AreThoseOfLinesThatStandThere) {
    const LineSet lines = extract_lines(two_balls(), smooth);
    shown_.renderer.set_lines(lines);
    Shown still{GetParam()};
    for (const glm::mat4& place : places()) {
        const std::array transforms{glm::mat4{1}, place};
        shown_.renderer.set_transforms(transforms);
        LineSet moved = lines;
        move_objects(moved, transforms);
        still.renderer.set_lines(moved);
        const Camera camera = parallel_view(views[1]);
        const std::vector<Interval> a = shown_.by(Method::exact, camera),
                                    b = still.by(Method::exact, camera);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            ASSERT_EQ(a[i].segment, b[i].segment);
            for (int axis = 0; axis < 2; ++axis)
                ASSERT_NEAR(a[i].start[axis], b[i].start[axis], 1e-2F);
        }
    }
    // Back at its first place the object is drawn as before, bit by bit.
    const std::array home{glm::mat4{1}, glm::mat4{1}};
    shown_.renderer.set_transforms(home);
    still.renderer.set_lines(lines);
    const Camera camera = parallel_view(views[2]);
    const std::vector<Interval> a = shown_.by(Method::exact, camera),
                                b = still.by(Method::exact, camera);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].segment, b[i].segment);
        EXPECT_EQ(a[i].start[0], b[i].start[0]);
        EXPECT_EQ(a[i].start[1], b[i].start[1]);
    }
}

/// The picture of a mirrored body is the mirror image of the picture, also where silhouettes end at
/// creases. Behind the body both faces of a crease look away.
TEST_P(MovingContours, EndAtTheSameCreasesInAMirror) {
    const LineSet lines = extract_lines(
        cylinder(14, true), {.separate_objects = true, .silhouettes = Silhouettes::smooth});
    ASSERT_FALSE(lines.contours.empty());
    const glm::mat4 mirror = scaled({-1, 1, 1});
    Shown mirrored{GetParam()};
    shown_.renderer.set_lines(lines);
    mirrored.renderer.set_lines(lines);
    mirrored.renderer.set_transforms(std::array{mirror});
    Random random{71};
    for (int view = 0; view < 20; ++view) {
        SCOPED_TRACE(view);
        const glm::vec3 to_eye = random.direction();
        const std::vector<Interval> wanted = shown_.by(Method::exact, parallel_view(to_eye)),
                                    found = mirrored.by(
                                        Method::exact,
                                        parallel_view(glm::vec3{mirror * glm::vec4{to_eye, 0}}));
        ASSERT_EQ(found.size(), wanted.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            ASSERT_EQ(found[i].segment, wanted[i].segment);
            // The front lies to the left of one silhouette and to the right of its mirror image.
            const auto as_wanted = [&](const float* start, const float* end) {
                return std::abs(400 - start[0] - wanted[i].start[0]) < 0.02F &&
                       std::abs(start[1] - wanted[i].start[1]) < 0.02F &&
                       std::abs(400 - end[0] - wanted[i].end[0]) < 0.02F &&
                       std::abs(end[1] - wanted[i].end[1]) < 0.02F;
            };
            EXPECT_TRUE(as_wanted(found[i].start, found[i].end) ||
                        as_wanted(found[i].end, found[i].start));
        }
    }
}

TEST_P(MovingContours, OfAHiddenObjectAreGone) {
    const LineSet lines = extract_lines(two_balls(), smooth);
    shown_.renderer.set_lines(lines);
    const Camera camera = parallel_view(views[0]);
    shown_.renderer.set_hidden(std::array{1U});
    const std::vector<Interval> found = shown_.by(Method::exact, camera);
    EXPECT_TRUE(of_object(lines, 1, found).empty());
    expect_loops(lines, camera, found, 1);
    shown_.renderer.set_hidden({});
    expect_loops(lines, camera, shown_.by(Method::exact, camera), 2);
}

TEST_P(MovingContours, OfAnotherShapeGoByItsTriangles) {
    Mesh ball = sphere(4);
    // The normals of the file are wrong now.
    for (const glm::uvec3& t : ball.triangles)
        for (int k = 0; k < 3; ++k)
            ball.corner_normals.push_back(glm::normalize(ball.positions[t[k]]));
    const LineSet lines = extract_lines(ball, smooth);
    shown_.renderer.set_lines(lines);
    for (const glm::mat4& shape : {places()[2], places()[4]}) {
        std::vector<glm::vec3> positions;
        for (const glm::vec3 p : ball.positions) positions.emplace_back(shape * glm::vec4{p, 1});
        // A mirror image turns a mesh inside out.
        if (glm::determinant(glm::mat3{shape}) < 0)
            for (std::size_t i = 0; i < positions.size(); ++i)
                positions[i] =
                    glm::vec3{shape * scaled({1, 1, -1}) * glm::vec4{ball.positions[i], 1}};
        LineSet bent = lines;
        move_vertices(bent, positions);
        const auto half = static_cast<std::uint32_t>(bent.vertices.size() / 2);
        shown_.renderer.set_transforms(std::array{glm::mat4{1}});
        shown_.renderer.set_positions(0, std::span{bent.vertices}.first(half));
        shown_.renderer.set_positions(half, std::span{bent.vertices}.subspan(half));
        const Camera camera = parallel_view(views[1]);
        const Ellipse expected{shape, camera};
        expect_ellipse(shown_.by(Method::exact, camera), expected, exactly);
        expect_ellipse(shown_.by(Method::atlas, camera), expected, by_samples);
        const std::vector<Interval> host =
            LineVisibility{bent, {.compute = GetParam()}}.find(camera);
        expect_ellipse(host, expected, exactly);
        expect_loops(bent, camera, host, 1);
        // The bent body is moved, too.
        const glm::mat4 turn = turned(2, {3, 1, -1});
        shown_.renderer.set_transforms(std::array{turn});
        expect_ellipse(shown_.by(Method::exact, camera), {turn * shape, camera}, exactly);
        // The same on another device.
        shown_.renderer.set_positions(0, bent.vertices);
        shown_.renderer.set_device({.compute = "cpp"});
        expect_ellipse(shown_.by(Method::exact, camera), {turn * shape, camera}, exactly);
    }
}

TEST_P(MovingContours, OfPartsComeAndGo) {
    const auto ball = [](const glm::mat4& place) {
        Mesh mesh = sphere(4);
        for (glm::vec3& p : mesh.positions) p = glm::vec3{place * glm::vec4{p, 1}};
        return extract_lines(mesh, smooth);
    };
    const auto at = [](float x, float radius) {
        return glm::translate(glm::mat4{1}, {x, 0, 0}) * scaled(glm::vec3{radius});
    };
    const Camera camera = parallel_view({0, 0.1F, 1});
    Assembly scene;
    const auto check = [&](std::span<const std::uint32_t> objects,
                           std::span<const glm::mat4> stand) {
        const std::vector<Interval> found = shown_.by(Method::exact, camera);
        expect_loops(scene.lines(), camera, found, objects.size());
        for (std::size_t i = 0; i < objects.size(); ++i)
            expect_ellipse(of_object(scene.lines(), objects[i], found), {stand[i], camera},
                           exactly);
    };
    const std::uint32_t plain = scene.add(extract_lines(cube())).front(); // which has no contours
    shown_.renderer.set_lines(scene);
    scene.remove(plain);
    const std::uint32_t a = scene.add(ball(at(-1.2F, 0.4F))).front();
    shown_.renderer.set_lines(scene);
    check(std::array{a}, std::array{at(-1.2F, 0.4F)});
    const std::uint32_t b = scene.add(ball(at(0, 0.6F))).front();
    const std::uint32_t c = scene.add(ball(at(1.3F, 0.5F))).front();
    shown_.renderer.set_lines(scene);
    check(std::array{a, b, c}, std::array{at(-1.2F, 0.4F), at(0, 0.6F), at(1.3F, 0.5F)});
    scene.remove(b);
    shown_.renderer.set_lines(scene);
    check(std::array{a, c}, std::array{at(-1.2F, 0.4F), at(1.3F, 0.5F)});
    const std::uint32_t d = scene.add(ball(at(0, 0.3F))).front();
    EXPECT_EQ(d, b);
    shown_.renderer.set_lines(scene);
    check(std::array{a, c, d}, std::array{at(-1.2F, 0.4F), at(1.3F, 0.5F), at(0, 0.3F)});
    // The objects are moved, and then get another shape.
    std::vector<glm::mat4> transforms(scene.lines().objects.size(), glm::mat4{1});
    transforms[d] = turned(0.4F, {1, 1, 0}) * scaled({1.5F, -1, 0.8F});
    shown_.renderer.set_transforms(transforms);
    const std::vector<Interval> found = shown_.by(Method::exact, camera);
    expect_ellipse(of_object(scene.lines(), d, found), {transforms[d] * at(0, 0.3F), camera},
                   exactly);
    // A single line set of all objects gives the same.
    const std::vector<Interval> host =
        LineVisibility{scene.lines(), {.compute = GetParam()}}.find(camera);
    expect_loops(scene.lines(), camera, host, 3);
    expect_ellipse(of_object(scene.lines(), d, host), {at(0, 0.3F), camera}, exactly);
}

INSTANTIATE_TEST_SUITE_P(By, MovingContours, testing::Values("cpp", "opencl"),
                         [](const auto& info) { return std::string{info.param}; });

} // namespace
} // namespace lineatlas::test
