// Fills as paths: which area of the picture each part has, in which colour; known answers, and a
// scene against a depth buffer and against the outlines of all its triangles.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "fills/face_looks.hpp"
#include "fills/seen_triangles.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/fills.hpp"
#include "lineatlas/progress.hpp"
#include "lineatlas/scenes.hpp"
#include "scene_cameras.hpp"
#include "test_meshes.hpp"

namespace lineatlas::test {
namespace {

Fill fill_of(FillMode mode) {
    Fill fill;
    fill.mode = mode;
    return fill;
}

const Fill flat = fill_of(FillMode::flat);

/// Looks along -z at a square of 10 units, 20 pixels to a unit.
Camera plan() {
    return make_camera(
        {.eye = {0, 0, 10}, .fov_y = 2 * std::atan(0.5F), .projection = Projection::orthographic},
        {200, 200}, {{-5, -5, -5}, {5, 5, 5}});
}

/// Adds a rectangle at a height as a part of its own.
void add_plate(Mesh& mesh, const std::string& object, glm::vec2 low, glm::vec2 high, float z) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(),
                          {{low, z}, {high.x, low.y, z}, {high, z}, {low.x, high.y, z}});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
    const auto group = static_cast<std::uint32_t>(mesh.groups.size());
    mesh.triangle_group.insert(mesh.triangle_group.end(), {group, group});
    mesh.groups.push_back({.object = object, .material = {}});
}

/// Calls it with the ends of each straight border.
template <class Each>
void for_each_border(const VectorFill& fill, const Each& each) {
    for (const std::vector<glm::dvec2>& ring : fill.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) each(ring[i], ring[(i + 1) % ring.size()]);
}

double area_of(const VectorFill& fill) {
    double twice = 0;
    for_each_border(fill, [&](glm::dvec2 a, glm::dvec2 b) { twice += a.x * b.y - a.y * b.x; });
    return twice / 2;
}

std::map<std::string, double> areas_by_object(const std::vector<VectorFill>& fills) {
    std::map<std::string, double> areas;
    for (const VectorFill& fill : fills) areas[fill.object] += area_of(fill);
    return areas;
}

TEST(Fills, APlateBeforeAnother) {
    Mesh mesh;
    add_plate(mesh, "far", {-4, -4}, {4, 4}, 0);
    add_plate(mesh, "near", {-1, -2}, {2, 1}, 1);
    add_plate(mesh, "over the border", {1.5F, -0.5F}, {3, 0.5F}, 2);
    const std::vector<VectorFill> fills = find_fills(extract_lines(mesh), plan(), flat);
    ASSERT_EQ(fills.size(), 3U);
    const std::map<std::string, double> areas = areas_by_object(fills);
    EXPECT_NEAR(areas.at("over the border"), 400 * 1.5, 1e-2);
    EXPECT_NEAR(areas.at("near"), 400 * (9 - 0.5), 1e-2);
    EXPECT_NEAR(areas.at("far"), 400 * (64 - 9 - 1), 1e-2);
    for (const VectorFill& fill : fills) {
        EXPECT_EQ(fill.rings.size(), fill.object == "far" ? 2U : 1U) << fill.object;
        EXPECT_NEAR(glm::distance(fill.color, Fill{}.color), 0, 0.005);
    }
}

TEST(Fills, BordersOfNeighboursAreTheSame) {
    Mesh mesh;
    add_plate(mesh, "left", {-4, -4}, {0.3F, 4}, 0);
    add_plate(mesh, "right", {0.3F, -4}, {4, 4}, 0);
    add_plate(mesh, "across", {-2, -1.1F}, {2, 1.3F}, 1);
    std::map<std::array<double, 4>, int> ways;
    for (const VectorFill& fill : find_fills(extract_lines(mesh), plan(), flat)) {
        for_each_border(fill, [&](glm::dvec2 a, glm::dvec2 b) {
            ++ways[{a.x, a.y, b.x, b.y}];
            --ways[{b.x, b.y, a.x, a.y}];
        });
    }
    // A border of two areas goes both ways. What is left is the outline of all.
    double around = 0;
    for (const auto& [way, count] : ways) {
        EXPECT_LE(std::abs(count), 1);
        if (count > 0) around += std::hypot(way[2] - way[0], way[3] - way[1]);
    }
    EXPECT_NEAR(around, 4 * 8 * 20, 1e-3);
}

TEST(Fills, IntersectingPartsShareABorder) {
    Mesh mesh = cube();
    mesh.triangle_group.assign(mesh.triangles.size(), 0);
    mesh.groups = {{.object = "cube", .material = {}}};
    add_plate(mesh, "plate", {-3, -3}, {3, 3}, 0);
    Camera camera = make_camera({.eye = {10, 0, 10}, .projection = Projection::orthographic},
                                {200, 200}, {{-5, -5, -5}, {5, 5, 5}});
    const std::map<std::string, double> areas =
        areas_by_object(find_fills(extract_lines(mesh), camera, flat));
    // Seen at 45 degrees: the plate 6 by 6 / sqrt 2, of the cube the half above it, which is 2 by
    // (2 + 1) / sqrt 2.
    EXPECT_NEAR(areas.at("cube") / (areas.at("cube") + areas.at("plate")), 6.0 / 36, 1e-5);
}

TEST(Fills, LightMakesAreasOfTheirOwn) {
    const LineSet lines = extract_lines(cube());
    const Camera camera = make_camera({.eye = {5, 4, 6}}, {400, 300}, lines.bounds);
    EXPECT_EQ(find_fills(lines, camera, flat).size(), 1U);
    const std::vector<VectorFill> lit = find_fills(lines, camera, fill_of(FillMode::lambert));
    ASSERT_EQ(lit.size(), 3U);
    std::set<float> tones;
    for (const VectorFill& fill : lit) {
        EXPECT_EQ(fill.rings.front().size(), 4U);
        tones.insert(fill.color.x);
    }
    EXPECT_EQ(tones.size(), 3U);
    EXPECT_TRUE(find_fills(lines, camera, {}).empty());
}

/// With tiles of 16 pixels these triangles would be more than 2^32 times in the lists of tiles.
TEST(Fills, TheLargestPictureHasItsNearestTriangles) {
    LineSet lines;
    constexpr std::uint32_t count = 257;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float z = 0.01F * static_cast<float>(i);
        lines.vertices.insert(lines.vertices.end(), {{-20, -20, z}, {20, -20, z}, {0, 40, z}});
        lines.triangles.push_back(3 * i + glm::uvec3{0, 1, 2});
    }
    Camera camera = plan();
    camera.size = glm::ivec2{65536};
    const std::vector<glm::dvec2> points{{1, 1}, {32000, 17}, {65535.5, 65535.5}};
    EXPECT_EQ(seen_triangles(lines, camera, points), std::vector(points.size(), count - 1));
}

TEST(Fills, FromWithinARoomAllOfThePictureIsFilled) {
    const LineSet lines = extract_lines(cube());
    const Camera camera = make_camera(
        {.eye = {0.1F, 0.2F, 0.3F}, .target = {0.9F, 0.1F, -0.4F}, .near = 0.01F, .far = 10},
        {160, 120}, lines.bounds);
    double sum = 0;
    for (const VectorFill& fill : find_fills(lines, camera, fill_of(FillMode::lambert)))
        sum += area_of(fill);
    EXPECT_NEAR(sum, 160 * 120, 1e-6);
}

/// Also before and behind the stages of visibility.
TEST(Fills, StopAtEveryCallOfProgress) {
    const LineSet lines = extract_lines(cube());
    std::vector<float> shares;
    find_fills(lines, plan(), flat, {}, [&](float done) {
        shares.push_back(done);
        return true;
    });
    ASSERT_GT(shares.size(), 3U);
    EXPECT_EQ(shares.front(), 0);
    EXPECT_EQ(shares.back(), 1);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    for (const float last : shares) {
        const auto stop = [&](float done) { return done < last; };
        EXPECT_THROW(find_fills(lines, plan(), flat, {}, stop), Cancelled) << last;
    }
    std::string told;
    try {
        find_fills(lines, plan(), flat, {}, [](float) { return false; });
    } catch (const Cancelled& cancelled) {
        told = cancelled.what();
    }
    EXPECT_EQ(told, "finding fills was cancelled");
}

TEST(Fills, AFillThatNoStyleHasIsRefused) {
    Fill fill = fill_of(FillMode::toon);
    fill.toon_steps = 1;
    EXPECT_THROW(find_fills(extract_lines(cube()), plan(), fill), UsageError);
}

/// A triangle on the screen: x and y in pixels, y down, and depth.
using ScreenTriangle = std::array<glm::dvec3, 3>;

/// By a camera that has nothing behind its eye.
std::vector<ScreenTriangle> project(const LineSet& lines, const Camera& camera) {
    const glm::dmat4 clip = glm::dmat4{camera.projection} * glm::dmat4{camera.view};
    const glm::dvec2 size{camera.size};
    std::vector<ScreenTriangle> triangles;
    for (const glm::uvec3 t : lines.triangles) {
        ScreenTriangle& triangle = triangles.emplace_back();
        for (int k = 0; k < 3; ++k) {
            const glm::dvec4 at = clip * glm::dvec4{glm::dvec3{lines.vertices[t[k]]}, 1};
            EXPECT_GT(at.w, 0);
            triangle[static_cast<std::size_t>(k)] = {(at.x / at.w + 1) * 0.5 * size.x,
                                                     (1 - at.y / at.w) * 0.5 * size.y, at.z / at.w};
        }
    }
    return triangles;
}

struct House {
    explicit House(glm::ivec2 size)
        : lines(scene_lines("house")),
          camera(make_camera(make_scene("house").view(0.3F), size, lines.bounds)),
          triangles(project(lines, camera)) {}

    const LineSet& lines;
    Camera camera;
    std::vector<ScreenTriangle> triangles;
};

/// A part of a horizontal line.
struct Reach {
    double from, to;
};

double length_of(const std::vector<Reach>& reaches) {
    double length = 0;
    for (const Reach& reach : reaches) length += reach.to - reach.from;
    return length;
}

std::vector<Reach> united(std::vector<Reach> reaches) {
    std::ranges::sort(reaches, {}, &Reach::from);
    std::vector<Reach> result;
    for (const Reach& reach : reaches) {
        if (result.empty() || reach.from > result.back().to)
            result.push_back(reach);
        else
            result.back().to = std::max(result.back().to, reach.to);
    }
    return result;
}

/// Where the line from one point to another is at a height between them.
double x_at(glm::dvec2 a, glm::dvec2 b, double y) {
    return a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
}

/// What a fill covers at a height, by the even-odd rule.
void add_reaches(const VectorFill& fill, double y, std::vector<Reach>& reaches) {
    std::vector<double> crossings;
    for_each_border(fill, [&](glm::dvec2 a, glm::dvec2 b) {
        if ((a.y < y) != (b.y < y)) crossings.push_back(x_at(a, b, y));
    });
    std::ranges::sort(crossings);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        reaches.push_back({crossings[i], crossings[i + 1]});
}

void add_reach(const ScreenTriangle& triangle, double y, double width,
               std::vector<Reach>& reaches) {
    Reach reach{width, 0};
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 a{triangle[k]}, b{triangle[(k + 1) % 3]};
        if ((a.y < y) == (b.y < y)) continue;
        reach.from = std::min(reach.from, std::max(x_at(a, b, y), 0.0));
        reach.to = std::max(reach.to, std::min(x_at(a, b, y), width));
    }
    if (reach.from < reach.to) reaches.push_back(reach);
}

/// Lengths along horizontal lines: what triangles cover and fills do not, what fills cover twice,
/// what fills cover beyond all triangles, and what triangles cover.
struct Flaws {
    double gaps = 0, overlaps = 0, beyond = 0, all = 0;
};

Flaws flaws_of(const std::vector<VectorFill>& fills, const House& house, int lines) {
    const glm::dvec2 size{house.camera.size};
    Flaws flaws;
    for (int i = 0; i < lines; ++i) {
        const double y = (i + 0.618033988) * size.y / lines;
        std::vector<Reach> covered, filled;
        for (const ScreenTriangle& triangle : house.triangles)
            add_reach(triangle, y, size.x, covered);
        for (const VectorFill& fill : fills) add_reaches(fill, y, filled);
        const double once = length_of(united(filled)), wanted = length_of(united(covered));
        covered.insert(covered.end(), filled.begin(), filled.end());
        const double both = length_of(united(covered));
        flaws.gaps += both - once;
        flaws.overlaps += length_of(filled) - once;
        flaws.beyond += both - wanted;
        flaws.all += wanted;
    }
    return flaws;
}

TEST(Fills, TheHouseIsFilledWithoutGapsAndOverlaps) {
    const House house{{600, 450}};
    for (const FillMode mode : {FillMode::flat, FillMode::lambert, FillMode::toon}) {
        const std::vector<VectorFill> fills = find_fills(house.lines, house.camera, fill_of(mode));
        const Flaws flaws = flaws_of(fills, house, 1000);
        EXPECT_LT(flaws.gaps + flaws.overlaps, 1e-6 * flaws.all)
            << static_cast<int>(mode) << " " << flaws.gaps / flaws.all << " "
            << flaws.overlaps / flaws.all;
        EXPECT_LT(flaws.beyond, 1e-6 * flaws.all) << flaws.beyond / flaws.all;
    }
}

/// The nearest triangle at the middle of each pixel, or -1.
std::vector<std::int64_t> depth_buffer(const std::vector<ScreenTriangle>& triangles,
                                       glm::ivec2 size) {
    const auto pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    std::vector<std::int64_t> seen(pixels, -1);
    std::vector<double> nearest(pixels, std::numeric_limits<double>::infinity());
    const auto twice = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto& [a, b, c] = triangles[i];
        const double all = twice(a, b, c);
        const glm::dvec3 least = glm::min(glm::min(a, b), c), most = glm::max(glm::max(a, b), c);
        const glm::ivec2 low{glm::max(glm::dvec2{least}, 0.0)};
        const glm::ivec2 high{glm::min(glm::dvec2{most}, glm::dvec2{size - 1})};
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                const glm::dvec2 at{x + 0.5, y + 0.5};
                const double u = twice(b, c, at) / all, v = twice(c, a, at) / all;
                if (!(u >= 0 && v >= 0 && u + v <= 1)) continue;
                const double depth = u * a.z + v * b.z + (1 - u - v) * c.z;
                const auto pixel = static_cast<std::size_t>(y * size.x + x);
                if (!(depth < nearest[pixel])) continue;
                nearest[pixel] = depth;
                seen[pixel] = static_cast<std::int64_t>(i);
            }
        }
    }
    return seen;
}

TEST(Fills, PartsOfTheHouseHaveTheAreasOfAPicture) {
    const House house{{2400, 1800}};
    for (const FillMode mode : {FillMode::flat, FillMode::toon}) {
        const FaceLooks looks = face_looks(house.lines, house.camera, fill_of(mode));
        using Key = std::array<unsigned, 3>;
        std::map<std::string, double> by_part, pixels_by_part;
        std::map<Key, double> by_color, pixels_by_color;
        for (const std::int64_t i : depth_buffer(house.triangles, house.camera.size)) {
            if (i < 0) continue;
            const Look& look = looks.looks[looks.of_triangle[static_cast<std::size_t>(i)]];
            ++pixels_by_part[look.object];
            ++pixels_by_color[{look.color.x, look.color.y, look.color.z}];
        }
        for (const VectorFill& fill : find_fills(house.lines, house.camera, fill_of(mode))) {
            const glm::uvec3 color{fill.color * 255.0F + 0.5F};
            by_part[fill.object] += area_of(fill);
            by_color[{color.x, color.y, color.z}] += area_of(fill);
        }
        ASSERT_GT(pixels_by_part.size(), 5U);
        for (const auto& [part, area] : pixels_by_part)
            EXPECT_NEAR(by_part[part], area, 0.005 * area) << part;
        // Each pixel on a border is right or wrong by chance: of small areas that is more.
        for (const auto& [color, area] : pixels_by_color)
            EXPECT_NEAR(by_color[color], area, 0.005 * area + 100);
    }
}

TEST(Fills, TheSameOnEveryDevice) {
    const House house{{300, 200}};
    const std::vector<VectorFill> own =
        find_fills(house.lines, house.camera, flat, {.compute = "cpp"});
    const std::vector<VectorFill> other =
        find_fills(house.lines, house.camera, flat, {.compute = "opencl"});
    ASSERT_EQ(own.size(), other.size());
    for (std::size_t i = 0; i < own.size(); ++i) EXPECT_EQ(own[i].rings, other[i].rings);
}

} // namespace
} // namespace lineatlas::test
