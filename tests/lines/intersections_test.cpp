#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "lineatlas/lines.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

/// Both meshes as parts of one mesh.
Mesh together(const Mesh& a, const Mesh& b) {
    Mesh mesh = a;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), b.positions.begin(), b.positions.end());
    for (const glm::uvec3& t : b.triangles) mesh.triangles.push_back(t + first);
    return mesh;
}

Mesh moved_by(const Mesh& mesh, glm::vec3 by, glm::vec3 size = glm::vec3{1}) {
    return test::moved(mesh, glm::scale(glm::translate(glm::mat4{1}, by), size));
}

struct Crossings {
    LineSet lines;
    std::vector<Segment> segments;
    double length = 0;
    std::set<std::uint32_t> paths;

    explicit Crossings(const Mesh& mesh, const LineOptions& options = {})
        : lines(extract_lines(mesh, options)) {
        for (const Segment& s : lines.segments) {
            if ((s.tag & LA_TAG_KIND_MASK) != LA_KIND_INTERSECTION) continue;
            segments.push_back(s);
            paths.insert(s.path);
            length += static_cast<double>(glm::distance(lines.vertices[s.p], lines.vertices[s.q]));
            expect_in_both_faces(s);
        }
        EXPECT_EQ(segments.size(), lines.kind_counts[LA_KIND_INTERSECTION]);
    }

    bool all_closed() const {
        return std::ranges::all_of(segments,
                                   [](const Segment& s) { return (s.tag & LA_TAG_CLOSED) != 0; });
    }

  private:
    void expect_in_both_faces(const Segment& s) const {
        ASSERT_LT(s.face_a, lines.triangles.size());
        ASSERT_LT(s.face_b, lines.triangles.size());
        for (const std::uint32_t face : {s.face_a, s.face_b}) {
            const glm::uvec3 t = lines.triangles[face];
            const glm::vec3 a = lines.vertices[t.x];
            const glm::vec3 n =
                glm::normalize(glm::cross(lines.vertices[t.y] - a, lines.vertices[t.z] - a));
            for (const std::uint32_t end : {s.p, s.q})
                EXPECT_LT(std::abs(glm::dot(n, lines.vertices[end] - a)), 2e-6F);
        }
    }
};

TEST(Intersections, OfTwoCubesAreAClosedLineWithCorners) {
    // A corner of one cube is in a corner of the other. The crossing is six straight pieces around
    // a cube of 1.
    const Crossings found{together(test::cube(), moved_by(test::cube(), {1, 1, 1}))};
    EXPECT_NEAR(found.length, 6, 1e-5);
    std::map<std::uint32_t, int> ends;
    for (const Segment& s : found.segments) {
        ++ends[s.p];
        ++ends[s.q];
    }
    for (const auto& [vertex, count] : ends) EXPECT_EQ(count, 2) << "a gap at " << vertex;
    EXPECT_EQ(found.paths.size(), 6U) << "corners of 90 degrees: no path goes on";
}

TEST(Intersections, OfACylinderThroughAPlateAreTwoRings) {
    const Mesh plate = moved_by(test::cube(), {0, 0, 0}, {3, 0.25F, 3});
    const Crossings found{together(plate, test::cylinder(48, true))};
    const double ring = 2 * 48 * std::sin(std::numbers::pi / 48);
    EXPECT_NEAR(found.length, 2 * ring, 1e-4);
    EXPECT_EQ(found.paths.size(), 2U);
    EXPECT_TRUE(found.all_closed());
}

TEST(Intersections, RunAlongEdgesThatLieInTheOtherFace) {
    // The middle of a fold lies in a floor, so neither half alone passes through the floor.
    Mesh floor;
    floor.positions = {{-3, 0, -3}, {3, 0, -3}, {3, 0, 3.5F}, {-3, 0, 3.5F}};
    floor.triangles = {{0, 1, 2}, {0, 2, 3}};
    const auto fold = [](float height, float below) {
        Mesh mesh;
        mesh.positions = {{-1, height, 0}, {1, -height, 0}, {1, 1, 0.1F},
                          {-1, 1, 0.1F},   {1, below, 0},   {-1, below, 0}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {0, 5, 4}};
        return mesh;
    };
    EXPECT_NEAR(Crossings{together(floor, fold(0, -1))}.length, 2, 1e-5);
    EXPECT_NEAR(Crossings{together(fold(0, -1), floor)}.length, 2, 1e-5);
    EXPECT_EQ(Crossings{together(floor, fold(0, 1))}.segments.size(), 0U) << "it stands on it";
    // The fold is off by as much as the file's precision allows.
    Mesh rounded = together(floor, fold(0.0001F, -1));
    rounded.precision = 0.0001F;
    EXPECT_EQ(extract_lines(rounded, {}).kind_counts[LA_KIND_INTERSECTION], 2U);
}

TEST(Intersections, OfTwoSpheresAreACircle) {
    // Spheres of radius 1 with centres 1 apart cross in a circle of radius sqrt(3) / 2. With facets
    // it is slightly smaller.
    const Crossings found{
        together(test::sphere(5), moved_by(test::sphere(5), {1, 0.003F, 0.001F}))};
    EXPECT_EQ(found.paths.size(), 1U);
    EXPECT_TRUE(found.all_closed());
    EXPECT_NEAR(found.length, std::numbers::pi * std::sqrt(3.0), 0.02);
}

TEST(Intersections, AreNoneWherePartsOnlyTouch) {
    const Mesh cube = test::cube();
    for (const glm::vec3 by :
         {glm::vec3{2, 0, 0}, glm::vec3{2, 0.5F, 0.3F}, glm::vec3{2, 2, 0.1F}, glm::vec3{2, 2, 2},
          glm::vec3{3, 0, 0}, glm::vec3{1.999999F, 0.5F, 0}})
        EXPECT_EQ(Crossings{together(cube, moved_by(cube, by))}.segments.size(), 0U)
            << by.x << "," << by.y << "," << by.z;
    // A cube of the same size and place, turned over, has faces in the same planes.
    Mesh inside = cube;
    for (glm::uvec3& t : inside.triangles) std::swap(t.y, t.z);
    EXPECT_EQ(Crossings{together(moved_by(cube, {}, {1, 1, 0.5F}), inside)}.segments.size(), 0U);
}

/// Two sheets cross at an angle. Below two degrees they count as one plane.
TEST(Intersections, AreNoneOfFacesInOnePlane) {
    const Mesh sheet = moved_by(test::open_strip(4), {-2, -0.5F, 0});
    for (const float degrees : {1.0F, 1.9F, 2.1F, 20.0F}) {
        const Mesh turned = test::moved(
            sheet, glm::rotate(glm::mat4{1}, glm::radians(degrees), glm::vec3{1, 0.2F, 0}));
        EXPECT_EQ(Crossings{together(sheet, turned)}.segments.empty(), degrees < 2) << degrees;
    }
}

TEST(Intersections, OfRoundPartsThatFitAreNone) {
    // A pin in a hole of the same radius. Their facets don't match.
    const Mesh pin = test::cylinder(48, false);
    Mesh hole = test::moved(pin, glm::rotate(glm::mat4{1}, 0.05F, glm::vec3{0, 1, 0}));
    for (glm::uvec3& t : hole.triangles) std::swap(t.y, t.z);
    const Mesh far = moved_by(test::cube(), {40, 0, 0});
    EXPECT_EQ(Crossings{together(together(pin, hole), far)}.segments.size(), 0U);
}

TEST(Intersections, AreNoneBesideLinesThatAreSeenThere) {
    // A carpet. Its upper edges are near the places where its sides pass through the floor.
    const Mesh floor = moved_by(test::cube(), {0, -1, 0}, {10, 1, 10});
    for (const float height : {0.01F, 0.1F}) {
        const Mesh carpet = moved_by(test::cube(), {0, height - 0.2F, 0}, {3, 0.2F, 2});
        const Crossings found{together(floor, carpet)};
        EXPECT_NEAR(found.length, height < 0.02F ? 0 : 20, 1e-4) << height;
    }
    // A wall whose foot is as near, but under the floor. The line of the foot is hidden.
    const Mesh wall = moved_by(test::cube(), {0, 0.99F, 0}, {3, 1, 2});
    EXPECT_NEAR(Crossings{together(floor, wall)}.length, 20, 1e-4);
}

TEST(Intersections, OfOnePartWithItselfAreNone) {
    test::Random random{96};
    const Mesh crumpled = test::with_random_radii(test::sphere(4), random, 0.2F);
    EXPECT_EQ(Crossings{crumpled}.segments.size(), 0U);
}

TEST(Intersections, AreThereIfWanted) {
    const Mesh mesh = together(test::cube(), moved_by(test::cube(), {1, 1, 1}));
    const LineKindMask others = all_line_kinds & ~mask_of(LineKind::intersection);
    EXPECT_TRUE(Crossings(mesh, {.lines = others}).segments.empty());
    EXPECT_FALSE(Crossings(mesh, {.lines = mask_of(LineKind::intersection)}).segments.empty());
}

TEST(Intersections, AreWithinObjectsThatMove) {
    Mesh mesh = together(test::cube(), moved_by(test::cube(), {1, 1, 1}));
    mesh.triangle_object.assign(24, 0);
    const Crossings within{mesh, {.separate_objects = true}};
    EXPECT_NEAR(within.length, 6, 1e-5);
    std::fill(mesh.triangle_object.begin() + 12, mesh.triangle_object.end(), 1U);
    EXPECT_TRUE(Crossings(mesh, {.separate_objects = true}).segments.empty());
}

/// The number of segments of intersections of each object. No segment may belong to two objects.
std::vector<int> of_objects(const Mesh& mesh) {
    const Crossings found{mesh, {.separate_objects = true}};
    const std::vector<LineObject>& objects = found.lines.objects;
    std::vector<int> counts(objects.size(), 0);
    for (const Segment& s : found.segments) {
        const auto is_in = [&](const LineObject& one, std::uint32_t vertex) {
            return vertex >= one.first_vertex && vertex < one.first_vertex + one.vertex_count;
        };
        for (std::size_t i = 0; i < objects.size(); ++i) {
            EXPECT_EQ(is_in(objects[i], s.p), is_in(objects[i], s.q)) << "from object to object";
            counts[i] += is_in(objects[i], s.p) ? 1 : 0;
        }
    }
    return counts;
}

/// A bar through a cube.
Mesh skewered() {
    return together(test::cube(), moved_by(test::cube(), {-0.1F, 0.1F, 0}, {0.4F, 3, 0.3F}));
}

TEST(Intersections, OfCopiesInOnePlaceAreOfEach) {
    for (const float apart : {0.0F, 1e-6F, 1e-3F, 10.0F}) {
        Mesh mesh;
        for (std::uint32_t copy = 0; copy < 5; ++copy) {
            mesh = together(mesh, moved_by(skewered(), {apart * static_cast<float>(copy), 0, 0}));
            mesh.triangle_object.resize(mesh.triangles.size(), copy);
        }
        const std::vector<int> counts = of_objects(mesh);
        ASSERT_EQ(counts.size(), 5U);
        EXPECT_GT(counts[0], 0);
        EXPECT_EQ(std::ranges::count(counts, counts[0]), 5) << apart;
    }
}

TEST(Intersections, StayWhereAnotherObjectHasEdges) {
    // A box over the end of the bar that sticks out of the cube.
    const Mesh end = moved_by(test::cube(), {-0.1F, 2, 0}, {0.4F, 1, 0.3F});
    std::vector<int> counts;
    for (const float away : {0.0F, 5.0F}) {
        Mesh mesh = skewered();
        mesh.triangle_object.assign(mesh.triangles.size(), 0);
        mesh = together(mesh, moved_by(end, {away, 0, 0}));
        mesh.triangle_object.resize(mesh.triangles.size(), 1);
        counts.push_back(of_objects(mesh).front());
    }
    EXPECT_EQ(counts[0], counts[1]);
}

/// Most crossings of many parts in one place lie deep in other parts. So the number of lines grows
/// with the surface of all parts together, not with the number of pairs.
TEST(Intersections, DoNotGrowWithTheSquareOfParts) {
    test::Random random{99};
    Mesh mesh;
    std::array<std::size_t, 2> counts{};
    for (int i = 0; i < 160; ++i) {
        mesh = together(mesh, moved_by(test::sphere(2), random.point(1), glm::vec3{0.9F}));
        if (i + 1 == 40) counts[0] = Crossings{mesh}.segments.size();
    }
    counts[1] = Crossings{mesh}.segments.size();
    EXPECT_GT(counts[0], 500U);
    EXPECT_LT(counts[1], 3 * counts[0]);
}

/// Added vertices come after those of their object, and name their places.
TEST(Intersections, AddVerticesToTheirObjects) {
    Mesh mesh = together(test::cube(), moved_by(test::cube(), {1, 1, 1}));
    const Mesh further = moved_by(mesh, {10, 0, 0});
    mesh = together(mesh, further);
    mesh.triangle_object.assign(24, 0);
    mesh.triangle_object.resize(48, 1);
    const Crossings found{mesh, {.separate_objects = true}};
    const LineSet& lines = found.lines;
    EXPECT_NEAR(found.length, 12, 1e-4);
    ASSERT_EQ(lines.objects.size(), 2U);
    EXPECT_EQ(lines.objects[0].vertex_count, lines.objects[1].vertex_count);
    EXPECT_EQ(lines.objects[0].vertex_count + lines.objects[1].vertex_count, lines.vertices.size());
    EXPECT_EQ(lines.vertex_sources.size(), lines.vertices.size());
    for (std::uint32_t v = 0; v < lines.vertices.size(); ++v)
        EXPECT_EQ(lines.vertices[v].x > 5, v >= lines.objects[1].first_vertex);
    EXPECT_EQ(lines.cut_vertices.size(), lines.vertices.size() - 32);
    for (const CutVertex& cut : lines.cut_vertices) {
        const glm::vec3 from = lines.vertices[cut.from], to = lines.vertices[cut.to];
        EXPECT_LT(glm::distance(glm::mix(from, to, cut.share), lines.vertices[cut.vertex]), 1e-5F);
    }
}

TEST(Intersections, AreTheSameInAnyPlaceAndSize) {
    test::Random random{97};
    const Mesh mesh = together(test::cube(), moved_by(test::cube(), {0.9F, 1.1F, 1.2F}));
    const double expected = Crossings{mesh}.length;
    for (int round = 0; round < 20; ++round)
        EXPECT_NEAR(Crossings{test::moved(mesh, random.placement(1))}.length, expected, 1e-4);
}

} // namespace
} // namespace lineatlas
