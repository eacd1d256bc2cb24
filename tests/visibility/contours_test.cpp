// Silhouettes of smooth surfaces with known answers: their number, whether they close, their
// lengths and their visible parts.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "compare.hpp"
#include "compute/cpp/cpp_device.hpp"
#include "compute/stages/silhouette_chains.hpp"
#include "devices.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"
#include "test_meshes.hpp"
#include "vector/paths.hpp"
#include "visibility/line_tables.hpp"

#include <gtest/gtest.h>

namespace lineatlas::test {
namespace {

constexpr double pi = std::numbers::pi;
const LineOptions smooth{.crease = std::numbers::pi_v<float>, .silhouettes = Silhouettes::smooth};

/// A grid of places(i, j). Either direction may be a ring.
template <class Place>
Mesh surface(std::uint32_t rows, std::uint32_t columns, bool row_ring, bool column_ring,
             const Place& place) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < rows; ++i)
        for (std::uint32_t j = 0; j < columns; ++j) mesh.positions.push_back(place(i, j));
    for (std::uint32_t i = 0; i + (row_ring ? 0 : 1) < rows; ++i) {
        for (std::uint32_t j = 0; j + (column_ring ? 0 : 1) < columns; ++j) {
            const std::uint32_t low = i * columns, high = (i + 1) % rows * columns;
            const std::uint32_t next = (j + 1) % columns;
            mesh.triangles.emplace_back(low + j, high + j, low + next);
            mesh.triangles.emplace_back(low + next, high + j, high + next);
        }
    }
    return mesh;
}

float turn(std::uint32_t i, std::uint32_t count) {
    return 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(count);
}

constexpr float large = 2, small = 0.6F; // radii of the torus

Mesh torus() {
    return surface(48, 96, true, true, [](std::uint32_t i, std::uint32_t j) {
        const float across = turn(i, 48), around = turn(j, 96);
        const float radius = large + small * std::cos(across);
        return glm::vec3{radius * std::cos(around), small * std::sin(across),
                         radius * std::sin(around)};
    });
}

/// A capsule of radius 1 about y, from -2 to 2 with its caps.
Mesh capsule() {
    return surface(50, 96, false, true, [](std::uint32_t i, std::uint32_t j) {
        const std::uint32_t step = i < 25 ? i : i - 1;
        const float angle = turn(step, 96) - 0.5F * std::numbers::pi_v<float>;
        const bool pole = i == 0 || i == 49;
        const float radius = pole ? 0 : std::cos(angle), around = turn(j, 96);
        return glm::vec3{radius * std::cos(around), std::sin(angle) + (i < 25 ? -1.0F : 1.0F),
                         radius * std::sin(around)};
    });
}

/// A cone about y, of radius 1 at its foot and of height 1; open below.
Mesh cone() {
    return surface(33, 96, false, true, [](std::uint32_t i, std::uint32_t j) {
        const float height = static_cast<float>(i) / 32, around = turn(j, 96);
        return glm::vec3{(1 - height) * std::cos(around), height, (1 - height) * std::sin(around)};
    });
}

float saddle_at(std::uint32_t i) {
    return static_cast<float>(i) / 32 - 1;
}

/// The surface z = x² - y² between -1 and 1.
Mesh saddle() {
    return surface(65, 65, false, false, [](std::uint32_t i, std::uint32_t j) {
        const float x = saddle_at(j), y = saddle_at(i);
        return glm::vec3{x, y, x * x - y * y};
    });
}

struct Chain {
    bool closed;
    double length; ///< in space
    double buried; ///< the part of `length` that is within the body's own region
};

/// The chains that kernels make of a line set's silhouettes, longest first.
std::vector<Chain> chains_of(const LineSet& lines, glm::vec4 eye, bool from_outside = true) {
    DeviceStages on{compute::make_cpp_device()};
    const LineTables tables = upload_lines(*on.device, lines);
    const auto triangles = static_cast<std::uint32_t>(lines.triangles.size());
    const LineTables::Chunk& chunk = tables.chunks[0];
    const compute::SegmentTable table{*tables.vertices, *tables.triangles, *chunk.segments,
                                      triangles,        chunk.range.count, chunk.candidates()};
    compute::SilhouetteChains chains{on.stages, compute::SilhouetteChains::Contours::on_surface};
    const compute::SegmentTable found = chains.table_of(
        table, true, {eye, from_outside}, [](const char*, const auto& action) { action(); });
    const auto vertices =
        read_back<glm::vec3>(*on.device, found.vertices, found.vertices.size() / sizeof(glm::vec3));
    std::vector<Chain> result;
    for (const Segment& segment :
         read_back<Segment>(*on.device, found.segments, found.segment_count)) {
        if ((segment.tag & LA_TAG_KIND_MASK) != LA_KIND_SILHOUETTE) continue;
        EXPECT_NE(segment.tag & LA_TAG_CONTOUR, 0U);
        if (segment.from_start == 0) result.push_back({(segment.tag & LA_TAG_CLOSED) != 0, 0, 0});
        const double length =
            glm::distance(glm::dvec3{vertices[segment.p]}, glm::dvec3{vertices[segment.q]});
        result.back().length += length;
        if ((segment.tag & LA_TAG_BURIED) != 0) result.back().buried += length;
    }
    std::ranges::sort(result, std::ranges::greater{}, &Chain::length);
    return result;
}

void expect_loops(const std::vector<Chain>& found, std::vector<double> lengths, double within) {
    std::ranges::sort(lengths, std::ranges::greater{});
    ASSERT_EQ(found.size(), lengths.size());
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        EXPECT_TRUE(found[i].closed);
        EXPECT_NEAR(found[i].length, lengths[i], within * lengths[i]);
    }
}

TEST(Contours, OfASphereAreOneCircle) {
    const LineSet lines = extract_lines(sphere(4), smooth);
    Random random{62};
    for (int view = 0; view < 20; ++view) {
        SCOPED_TRACE(view);
        const glm::vec3 to_eye = random.direction();
        expect_loops(chains_of(lines, {to_eye, 0}), {2 * pi}, 1e-3);
        // From a distance of 3 the outline is a smaller circle.
        expect_loops(chains_of(lines, {3.0F * to_eye, 1}), {2 * pi * std::sqrt(1 - 1.0 / 9)}, 1e-3);
    }
}

/// The contour of the torus in a view along (x, y, 0): the places with tan(across) = -cos(around) x
/// / y, two for each `around`. Buried parts are those where the surface bends away from its normal
/// along the view.
Chain torus_contour(double x, double y, bool far) {
    constexpr int steps = 20000;
    Chain contour{.closed = true, .length = 0, .buried = 0};
    glm::dvec3 before{0};
    for (int i = 0; i <= steps; ++i) {
        const double around = 2 * pi * i / steps;
        const double across = std::atan2(-std::cos(around) * x / y, 1.0) + (far ? pi : 0);
        const double radius = double{large} + double{small} * std::cos(across);
        const glm::dvec3 place{radius * std::cos(around), double{small} * std::sin(across),
                               radius * std::sin(around)};
        const double along_ring = -std::sin(around) * x;
        const double along_tube = -std::sin(across) * std::cos(around) * x + std::cos(across) * y;
        const double bend = std::cos(across) / radius * along_ring * along_ring +
                            along_tube * along_tube / double{small};
        if (i > 0) contour.length += glm::distance(before, place);
        if (i > 0 && bend < 0) contour.buried += glm::distance(before, place);
        before = place;
    }
    return contour;
}

TEST(Contours, OfATorusAreTwoLoops) {
    const LineSet lines = extract_lines(torus(), smooth);
    for (int view = 1; view <= 20; ++view) {
        SCOPED_TRACE(view);
        const double angle = 0.5 * pi * view / 21; // above the plane of the torus
        const double x = std::cos(angle), y = std::sin(angle);
        const glm::vec3 to_eye{x * 0.8, y, x * 0.6}; // and around
        const std::vector<Chain> found = chains_of(lines, {to_eye, 0});
        const std::array known{torus_contour(x, y, false), torus_contour(x, y, true)};
        expect_loops(found, {known[0].length, known[1].length}, 5e-3);
        EXPECT_NEAR(found[0].buried + found[1].buried, known[0].buried + known[1].buried, 0.2);
    }
}

TEST(Contours, AreBuriedInSolidsAlone) {
    const glm::vec4 eye{0.8F, 0.3F, 0.6F, 0};
    const auto buried = [&](const Mesh& mesh, bool from_outside = true) {
        double sum = 0;
        for (const Chain& chain : chains_of(extract_lines(mesh, smooth), eye, from_outside))
            sum += chain.buried;
        return sum;
    };
    EXPECT_GT(buried(torus()), 3);
    EXPECT_EQ(buried(torus(), false), 0);
    EXPECT_EQ(buried(capsule()), 0);
    Mesh open = torus();
    open.triangles.pop_back();
    EXPECT_EQ(buried(open), 0);
    Mesh inside_out = torus();
    for (glm::uvec3& t : inside_out.triangles) std::swap(t.y, t.z);
    EXPECT_EQ(buried(inside_out), buried(torus())) << "it is turned";
    Mesh disagreeing = torus();
    std::swap(disagreeing.triangles[0].y, disagreeing.triangles[0].z);
    EXPECT_EQ(buried(disagreeing), 0);
}

TEST(Contours, OfACapsuleAreOneStadium) {
    Random random{63};
    const LineSet lines = extract_lines(capsule(), smooth);
    expect_loops(chains_of(lines, {0.7F, 0, 0.4F, 0}), {2 * pi + 4}, 2e-3);
    for (int view = 0; view < 20; ++view) {
        SCOPED_TRACE(view);
        const std::vector<Chain> found = chains_of(lines, {random.direction(), 0});
        ASSERT_EQ(found.size(), 1U);
        EXPECT_TRUE(found[0].closed);
    }
}

TEST(Contours, OfAConeGoUpAndDown) {
    const LineSet lines = extract_lines(cone(), smooth);
    for (int view = 0; view < 20; ++view) {
        SCOPED_TRACE(view);
        const float around = turn(view, 20) + 0.01F;
        const std::vector<Chain> found =
            chains_of(lines, {std::cos(around), 0.02F, std::sin(around), 0});
        ASSERT_EQ(found.size(), 1U); // the silhouette passes over the tip
        EXPECT_FALSE(found[0].closed);
        EXPECT_NEAR(found[0].length, 2 * std::sqrt(2.0), 0.03);
    }
}

TEST(Contours, OfAWallSeenEdgeOnStandAtItsNearEnd) {
    Mesh body = capsule();
    for (const glm::uvec3& t : body.triangles) {
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 p = body.positions[t[k]];
            glm::vec3 normal = glm::normalize(p - glm::vec3{0, std::clamp(p.y, -1.0F, 1.0F), 0});
            normal.y += t[k] % 2 == 0 ? 1e-6F : -1e-6F; // like rounding
            body.corner_normals.push_back(normal);
        }
    }
    const LineSet lines = extract_lines(body, smooth);
    for (const float way : {1.0F, -1.0F}) {
        const std::vector<Chain> found = chains_of(lines, {0, way, 0, 0});
        ASSERT_EQ(found.size(), 1U);
        EXPECT_TRUE(found[0].closed);
        EXPECT_NEAR(found[0].length, 2 * pi, 0.001 * 2 * pi);
    }
}

TEST(Contours, OfASaddleAreALineFromBorderToBorder) {
    const LineSet lines = extract_lines(saddle(), smooth);
    Random random{64};
    for (int view = 0; view < 20; ++view) {
        SCOPED_TRACE(view);
        // The silhouette is at 2 x vx = 2 y vy + vz with |x| and |y| below 1. In these views y goes
        // from -1 to 1.
        const float tilt = random.between(-0.3F, 0.3F), rise = random.between(-0.4F, 0.4F);
        const glm::vec3 to_eye{1, tilt, rise};
        double length = 0;
        glm::dvec3 before{0};
        constexpr int steps = 10000;
        for (int i = 0; i <= steps; ++i) {
            const double y = 2.0 * i / steps - 1, x = y * double{tilt} + 0.5 * double{rise};
            const glm::dvec3 place{x, y, x * x - y * y};
            if (i > 0) length += glm::distance(before, place);
            before = place;
        }
        const std::vector<Chain> found = chains_of(lines, {to_eye, 0});
        ASSERT_EQ(found.size(), 1U);
        EXPECT_FALSE(found[0].closed);
        EXPECT_NEAR(found[0].length, length, 0.01 * length);
    }
}

constexpr glm::ivec2 size{400, 400};

/// A picture in which a unit is 100 pixels long.
Camera parallel_view(glm::vec3 to_eye) {
    Camera camera;
    camera.size = size;
    camera.view = glm::lookAt(10.0F * to_eye, glm::vec3{0}, glm::vec3{0, 1, 0});
    camera.projection = glm::ortho(-2.0F, 2.0F, -2.0F, 2.0F, 1.0F, 20.0F);
    return camera;
}

double length_of(const std::vector<Interval>& intervals, bool visible) {
    double length = 0;
    for (const Interval& one : intervals) {
        if (((one.flags & LA_INTERVAL_VISIBLE) != 0) != visible) continue;
        length += std::hypot(double{one.end[0] - one.start[0]}, double{one.end[1] - one.start[1]});
    }
    return length;
}

TEST(Contours, OfASphereAreSeenWhole) {
    Random random{65};
    for (const int level : {2, 3, 4}) {
        const LineSet lines = extract_lines(sphere(level), smooth);
        for (int view = 0; view < 10; ++view) {
            SCOPED_TRACE(level * 100 + view);
            const Camera camera = parallel_view(random.direction());
            const std::vector<Interval> found =
                LineVisibility{lines}.find(camera, {.hidden = true});
            EXPECT_NEAR(length_of(found, true), 2 * pi * 100, level == 2 ? 10 : 3);
            EXPECT_LT(length_of(found, false), 0.5);
            const VectorDrawing drawing = make_vector_drawing(lines, camera, found, Style{});
            ASSERT_EQ(drawing.paths.size(), 1U);
            EXPECT_TRUE(drawing.paths[0].closed);
        }
    }
}

/// In a view from slightly above the plane of a torus, the near side hides a part of the far loop.
TEST(Contours, OfATorusAreHiddenInParts) {
    const LineSet lines = extract_lines(torus(), smooth);
    const Camera camera = parallel_view(glm::normalize(glm::vec3{0.9F, 0.35F, 0.2F}));
    const LineSet edges = extract_lines(torus(), {.crease = smooth.crease});
    const double along_edges = length_of(LineVisibility{edges}.find(camera), true);
    const double seen = length_of(LineVisibility{lines}.find(camera), true);
    EXPECT_LT(seen, along_edges); // edges zigzag
    EXPECT_GT(seen, 0.85 * along_edges);
    EXPECT_GT(length_of(LineVisibility{lines}.find(camera, {.hidden = true}), false), 50);
}

/// A body about y. outline: its places (radius, height) from bottom to top. Each place is a crease,
/// with normals of cones between them.
Mesh turned_body(const std::vector<glm::vec2>& outline, std::uint32_t sides) {
    Mesh mesh;
    const auto about = [&](glm::vec2 place, std::uint32_t column) {
        const float around = turn(column % sides, sides);
        return glm::vec3{place.x * std::cos(around), place.y, place.x * std::sin(around)};
    };
    for (const glm::vec2 place : outline)
        for (std::uint32_t j = 0; j < sides; ++j) mesh.positions.push_back(about(place, j));
    for (std::uint32_t i = 0; i + 1 < outline.size(); ++i) {
        const glm::vec2 way = outline[i + 1] - outline[i];
        const glm::vec2 out = glm::normalize(glm::vec2{way.y, -way.x});
        const auto add = [&](std::array<glm::uvec2, 3> corners) {
            const auto position = [&](int k) {
                return corners[k].x * sides + corners[k].y % sides;
            };
            mesh.triangles.emplace_back(position(0), position(1), position(2));
            for (const glm::uvec2 corner : corners)
                mesh.corner_normals.push_back(about(out, corner.y));
        };
        for (std::uint32_t j = 0; j < sides; ++j) {
            add({{{i, j}, {i + 1, j}, {i, j + 1}}});
            add({{{i, j + 1}, {i + 1, j}, {i + 1, j + 1}}});
        }
    }
    return mesh;
}

VectorDrawing draw_exactly(const LineSet& lines, const Camera& camera) {
    return make_vector_drawing(lines, camera, LineVisibility{lines}.find(camera, {.hidden = true}),
                               Style{});
}

double to_other_lines(const VectorDrawing& drawing, const VectorPath& own, glm::dvec2 end) {
    double nearest = 1e9;
    for (const VectorPath& path : drawing.paths) {
        if (&path == &own || !path.visible) continue;
        for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
            const glm::dvec2 a = path.points[k].at, way = path.points[k + 1].at - a;
            const double along = std::clamp(glm::dot(end - a, way) / glm::dot(way, way), 0.0, 1.0);
            nearest = std::min(nearest, glm::distance(end, a + way * along));
        }
    }
    return nearest;
}

/// Where a sheet dips, the eye sees its back. Its silhouette is the floor of the valley.
TEST(Contours, OfASheetAreSeenFromItsBackToo) {
    for (const bool turned : {false, true}) {
        Mesh sheet = surface(65, 65, false, false, [](std::uint32_t i, std::uint32_t j) {
            const float x = saddle_at(j), z = saddle_at(i);
            return glm::vec3{x, 0.5F * z * z, z};
        });
        if (turned)
            for (glm::uvec3& t : sheet.triangles) std::swap(t.y, t.z);
        const VectorDrawing drawing =
            draw_exactly(extract_lines(sheet, smooth), parallel_view({0, 0, 1}));
        double length = 0;
        for (const VectorPath& path : drawing.paths)
            if (path.kind == LineKind::silhouette && path.visible) length += length_of(path);
        EXPECT_NEAR(length, 200, 1) << turned; // from side to side
    }
}

/// On a convex body a silhouette ends only at a crease that continues it, or where the two run
/// within a quarter of a pixel of each other and one is left out.
TEST(Contours, MeetTheCreasesThatGoOn) {
    const LineSet lines =
        extract_lines(turned_body({{0, -1.2F}, {0.7F, -1.2F}, {1.4F, 0}, {1.1F, 1}, {0, 1}}, 32),
                      {.crease = 0.35F, .silhouettes = Silhouettes::automatic});
    ASSERT_FALSE(lines.contours.empty());
    Random random{67};
    int ends = 0;
    for (int view = 0; view < 30; ++view) {
        SCOPED_TRACE(view);
        const VectorDrawing drawing = draw_exactly(lines, parallel_view(random.direction()));
        for (const VectorPath& path : drawing.paths) {
            if (path.kind != LineKind::silhouette || !path.visible || path.closed) continue;
            for (const VectorPoint& end : {path.points.front(), path.points.back()}) {
                EXPECT_LT(to_other_lines(drawing, path, end.at), 0.27);
                ++ends;
            }
        }
    }
    EXPECT_GT(ends, 60);
}

/// The wall of a bore is hollow, so that no eye outside sees it turn away.
TEST(Contours, OfABoreAreHidden) {
    const LineSet lines = extract_lines(
        turned_body({{1, -0.5F}, {1.8F, -0.5F}, {1.8F, 0.5F}, {1, 0.5F}, {1, -0.5F}}, 40),
        {.crease = 0.35F, .silhouettes = Silhouettes::automatic});
    double of_bore = 0, outside = 0;
    for (int view = 1; view < 12; ++view) {
        const double angle = 0.5 * pi * view / 12;
        const glm::vec3 to_eye{std::cos(angle) * 0.8, std::sin(angle), std::cos(angle) * 0.6};
        const VectorDrawing drawing = draw_exactly(lines, parallel_view(to_eye));
        for (const VectorPath& path : drawing.paths) {
            if (path.kind != LineKind::silhouette || !path.visible) continue;
            for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
                const glm::dvec3 at = path.points[k].world, to = path.points[k + 1].world;
                const double radius = std::hypot(at.x + to.x, at.z + to.z) / 2;
                (radius < 1.4 ? of_bore : outside) +=
                    glm::distance(path.points[k].at, path.points[k + 1].at);
            }
        }
    }
    EXPECT_LT(of_bore, 0.5);
    EXPECT_GT(outside, 1000);
}

/// The outline of a rough ball, too, has no gap of more than two pixels.
TEST(Contours, OfARoughBallAreSeenAllAround) {
    Mesh ball = sphere(5);
    Random random{68};
    for (glm::vec3& position : ball.positions) position *= random.between(0.997F, 1.003F);
    const LineSet lines = extract_lines(ball, smooth);
    for (int view = 0; view < 3; ++view) {
        const Camera camera = parallel_view(random.direction());
        constexpr int directions = 600; // one per pixel of the outline
        std::array<bool, directions> seen{};
        for (const Interval& one : LineVisibility{lines}.find(camera)) {
            for (int k = 0; k <= 8; ++k) {
                const float along = static_cast<float>(k) / 8;
                const glm::dvec2 at{std::lerp(one.start[0], one.end[0], along) - 200,
                                    std::lerp(one.start[1], one.end[1], along) - 200};
                if (glm::length(at) < 97) continue;
                const double share = std::atan2(at.y, at.x) / (2 * pi) + 0.5;
                seen[static_cast<std::size_t>(share * (directions - 1e-6))] = true;
            }
        }
        int longest = 0, bare = 0;
        for (int i = 0; i < 2 * directions; ++i) {
            bare = seen[static_cast<std::size_t>(i % directions)] ? 0 : bare + 1;
            longest = std::max(longest, bare);
        }
        EXPECT_LE(longest, 3) << view;
    }
}

/// Paths name the places on triangles over which a contour runs.
TEST(Contours, NameTrianglesAndPlacesOverThem) {
    const Mesh body = sphere(4);
    const LineSet lines = extract_lines(body, smooth);
    const VectorDrawing drawing = draw_exactly(lines, parallel_view({0, 0, 1}));
    ASSERT_EQ(drawing.paths.size(), 1U);
    const VectorPath& path = drawing.paths[0];
    for (std::size_t i = 0; i < path.pieces.size(); ++i) {
        const VectorPiece& piece = path.pieces[i];
        ASSERT_LT(piece.source.triangle, body.triangles.size());
        const glm::uvec3 corners = body.triangles[piece.source.triangle];
        for (const glm::vec3 over : {piece.over_start, piece.over_end}) {
            EXPECT_NEAR(over.x + over.y + over.z, 1, 1e-5);
            // A contour crosses a triangle from side to side.
            EXPECT_LT(std::min({over.x, over.y, over.z}), 0.02F);
            const glm::vec3 place = over.x * body.positions[corners.x] +
                                    over.y * body.positions[corners.y] +
                                    over.z * body.positions[corners.z];
            EXPECT_NEAR(place.z, 0, 0.01F); // the contour of a ball seen along z
        }
    }
}

TEST(Contours, AreDrawnByTheAtlasToo) {
    const gl::HeadlessContext context;
    Renderer renderer;
    renderer.set_lines(extract_lines(sphere(4), smooth));
    FrameOptions options;
    options.intervals = KeptIntervals::all;
    options.draw = false;
    Random random{66};
    for (int view = 0; view < 5; ++view) {
        const Camera camera = parallel_view(random.direction());
        for (const Method method : {Method::atlas, Method::exact}) {
            options.method = method;
            renderer.draw(camera, options, 0);
            EXPECT_NEAR(length_of(renderer.read_intervals(), true), 2 * pi * 100, 8);
            EXPECT_LT(length_of(renderer.read_intervals(), false), 4);
        }
        // Other methods draw edges.
        options.method = Method::atlas;
    }
}

/// A ball of radius 1 whose vertices are off by up to `noise` edges.
Mesh rough_sphere(float noise) {
    Mesh mesh = sphere(5);
    const glm::uvec3 t = mesh.triangles[0];
    const float edge = glm::distance(mesh.positions[t.x], mesh.positions[t.y]);
    Random random{70};
    for (glm::vec3& position : mesh.positions)
        for (int axis = 0; axis < 3; ++axis) position[axis] += random.between(-noise, noise) * edge;
    return mesh;
}

/// The drawing of the kernels' silhouettes, hidden ones left out, as tool and API make it.
VectorDrawing seen_of(const LineSet& lines, const Camera& camera) {
    return make_vector_drawing(lines, camera, LineVisibility{lines}.find(camera), Style{});
}

/// The number of rays, of 360 from the middle of the picture, that meet no line within `reach` of
/// the circle. radius, reach: pixels.
int gaps_beside(const VectorDrawing& drawing, double radius, double reach) {
    std::array<bool, 360> met{};
    for (const VectorPath& path : drawing.paths) {
        for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
            const glm::dvec2 from = path.points[k].at, way = path.points[k + 1].at - from;
            const int steps = static_cast<int>(glm::length(way)) + 1;
            for (int i = 0; i <= steps; ++i) {
                const glm::dvec2 at = from + way * (double(i) / steps) - 0.5 * glm::dvec2{size};
                if (std::abs(glm::length(at) - radius) > reach) continue;
                const double degrees = std::atan2(at.y, at.x) * 180 / pi + 360;
                met.at(static_cast<std::size_t>(degrees) % met.size()) = true;
            }
        }
    }
    return static_cast<int>(std::ranges::count(met, false));
}

TEST(Contours, OfARoughBallHaveNeitherGapsNorCrumbs) {
    Random random{71};
    const LineSet lines = extract_lines(rough_sphere(0.1F), {.lines = mask_of(LineKind::silhouette),
                                                             .silhouettes = Silhouettes::smooth});
    for (int view = 0; view < 5; ++view) {
        SCOPED_TRACE(view);
        const VectorDrawing drawing = seen_of(lines, parallel_view(random.direction()));
        EXPECT_EQ(gaps_beside(drawing, 100, 1.5), 0);
        double length = 0;
        for (const VectorPath& path : drawing.paths) length += length_of(path);
        EXPECT_LT(length, 1.15 * 2 * pi * 100);
        EXPECT_LT(drawing.paths.size(), 20U);
    }
}

/// The eye sees the inside of a bowl. The outline goes from the surface to the border without a
/// gap.
TEST(Contours, OfAnOpenScanMeetItsBorder) {
    Random random{72};
    Mesh bowl = sphere(4);
    std::erase_if(bowl.triangles, [&](glm::uvec3 t) { return bowl.positions[t.x].y > 0.6F; });
    const LineSet lines = extract_lines(bowl, {.silhouettes = Silhouettes::smooth});
    ASSERT_FALSE(lines.contours.empty());
    for (int view = 0; view < 10; ++view) {
        SCOPED_TRACE(view);
        const glm::vec3 way = random.direction();
        const Camera camera = parallel_view(way);
        const Camera whole = parallel_view(way);
        const VectorDrawing drawing = seen_of(lines, camera);
        const VectorDrawing along =
            seen_of(extract_lines(bowl, {.silhouettes = Silhouettes::mesh}), whole);
        EXPECT_EQ(gaps_beside(drawing, 100, 4), gaps_beside(along, 100, 4));
    }
}

TEST(Contours, StandForEdgesOfWhatIsSmooth) {
    const Mesh body = sphere(3);
    const LineSet edges = extract_lines(body, {.silhouettes = Silhouettes::mesh}),
                  contours = extract_lines(body);
    EXPECT_TRUE(edges.contours.empty());
    EXPECT_EQ(contours.contours.faces.size(), body.triangles.size());
    EXPECT_EQ(contours.contours.replaced, edges.segments.size());
    EXPECT_EQ(contours.segments.size(), edges.segments.size() + body.triangles.size());
    // A coarse body and a body of flat faces are not sculpted.
    const auto has_none = [](const Mesh& mesh) {
        return extract_lines(mesh, {.silhouettes = Silhouettes::automatic}).contours.empty();
    };
    EXPECT_TRUE(has_none(sphere(1)));
    EXPECT_TRUE(has_none(sphere(2)));
    EXPECT_FALSE(has_none(sphere(5)));
    EXPECT_TRUE(has_none(rough_sphere(0.1F)));
    // An open body may show its back, and a body that is inside out is turned.
    Mesh open = body;
    open.triangles.pop_back();
    EXPECT_TRUE(has_none(open));
    Mesh inside_out = body;
    for (glm::uvec3& t : inside_out.triangles) std::swap(t.y, t.z);
    EXPECT_FALSE(has_none(inside_out));
    EXPECT_TRUE(extract_lines(cube(), {.silhouettes = Silhouettes::smooth}).contours.empty());
    EXPECT_TRUE(has_none(cylinder(64, true)));
    EXPECT_FALSE(
        extract_lines(cylinder(64, true), {.silhouettes = Silhouettes::smooth}).contours.empty());
    // But a coarse body is smooth by itself if its file knows its surface.
    Mesh exact = sphere(1);
    for (const glm::uvec3& t : exact.triangles)
        for (int k = 0; k < 3; ++k)
            exact.corner_normals.push_back(glm::normalize(exact.positions[t[k]]));
    const auto smooth_faces = [&] {
        return extract_lines(exact, {.silhouettes = Silhouettes::automatic}).contours.faces.size();
    };
    EXPECT_EQ(smooth_faces(), exact.triangles.size());
    for (std::size_t i = 0; i < 3; ++i) exact.corner_normals[i] = glm::vec3{0};
    EXPECT_LT(smooth_faces(), exact.triangles.size());
    // Objects that can move have contours, too.
    EXPECT_EQ(extract_lines(body, {.separate_objects = true, .silhouettes = Silhouettes::smooth})
                  .contours.faces.size(),
              body.triangles.size());
}

TEST(Contours, EmptyRoomOfAnAssemblyLiesBesideNothing) {
    Contours contours;
    contours.corners.resize(4);
    contours.edges = {{0, 1}, {1, 2}, {2, 0}, {1, 3}, {3, 2}};
    contours.faces = {{0, 1, 2}, {1 | LA_CONTOUR_TURNED, 3, 4}, {0, 0, 0}, {0, 0, 0}};
    const auto faces = contour_faces(contours);
    const auto across = [&](std::size_t face) {
        return glm::uvec3{faces[face].across[0], faces[face].across[1], faces[face].across[2]};
    };
    EXPECT_EQ(across(0), glm::uvec3(LA_NO_FACE, 1, LA_NO_FACE));
    EXPECT_EQ(across(1), glm::uvec3(0, LA_NO_FACE, LA_NO_FACE));
    EXPECT_EQ(contour_corners(contours),
              (std::vector<glm::uvec3>{{0, 1, 2}, {2, 1, 3}, {0, 0, 0}, {0, 0, 0}}));
}

/// A rim stays a line although it is a side of triangles that contours cross. Edges along an
/// intersection stay lines, too.
TEST(Contours, TakeNoOtherLinesAway) {
    Mesh mesh = cylinder(64, true);
    const Mesh box = cube();
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& p : box.positions)
        mesh.positions.push_back(0.5F * p + glm::vec3{1, 0, 0});
    for (const glm::uvec3& t : box.triangles) mesh.triangles.push_back(t + first);
    for (int turned = 0; turned < 3; ++turned) {
        const LineSet along_edges = extract_lines(mesh),
                      contours = extract_lines(mesh, {.silhouettes = Silhouettes::smooth});
        ASSERT_GT(along_edges.kind_counts[LA_KIND_INTERSECTION], 0U);
        ASSERT_FALSE(contours.contours.empty());
        EXPECT_EQ(along_edges.kind_counts[LA_KIND_CREASE], 128U + 12);
        for (const std::size_t kind : {LA_KIND_CREASE, LA_KIND_INTERSECTION})
            EXPECT_EQ(contours.kind_counts[kind], along_edges.kind_counts[kind]) << kind;
        for (glm::uvec3& t : mesh.triangles) t = {t.y, t.z, t.x};
    }
}

} // namespace
} // namespace lineatlas::test
