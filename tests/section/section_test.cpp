#include "lineatlas/section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "lineatlas/error.hpp"
#include "lineatlas/lines.hpp"
#include "mesh_volume.hpp"
#include "test_meshes.hpp"

namespace lineatlas {
namespace {

using test::cube;
using test::cylinder;
using test::sphere;
using test::volume;

SectionPlane plane(glm::dvec3 point, glm::dvec3 normal) {
    return {.point = point, .normal = normal};
}

Section cut(const Mesh& mesh, glm::dvec3 point, glm::dvec3 normal, Hatching hatching = {}) {
    return cut_mesh(mesh, std::vector{plane(point, normal)}, hatching);
}

/// Adds another mesh to a mesh.
void add(Mesh& mesh, const Mesh& other) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    for (const glm::uvec3 triangle : other.triangles) mesh.triangles.push_back(triangle + first);
}

Mesh placed(const Mesh& mesh, glm::vec3 at, float size) {
    return test::moved(mesh, glm::scale(glm::translate(glm::mat4{1}, at), glm::vec3{size}));
}

Mesh turned_over(Mesh mesh) {
    for (glm::uvec3& triangle : mesh.triangles) std::swap(triangle.x, triangle.y);
    return mesh;
}

std::vector<std::vector<glm::vec3>> polylines(const Mesh& mesh, PolylineKind kind) {
    std::vector<std::vector<glm::vec3>> found;
    for (std::size_t i = 0; i < mesh.polylines.size(); ++i) {
        if (mesh.polyline_kind[i] != kind) continue;
        found.emplace_back();
        for (const std::uint32_t index : mesh.polylines[i])
            found.back().push_back(mesh.positions[index]);
    }
    return found;
}

/// The area of faces in the plane that look this way.
double face_area(const Mesh& mesh, glm::dvec3 point, glm::dvec3 normal) {
    double area = 0;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a{mesh.positions[t.x]}, b{mesh.positions[t.y]}, c{mesh.positions[t.z]};
        const auto off = [&](glm::dvec3 at) { return std::abs(glm::dot(at - point, normal)); };
        if (std::max({off(a), off(b), off(c)}) > 1e-5) continue;
        area += 0.5 * glm::dot(glm::cross(b - a, c - a), normal);
    }
    return area;
}

std::size_t open_edges(const Mesh& mesh) {
    // With a given angle cracks stay.
    const LineSet lines =
        extract_lines(mesh, {.lines = mask_of(LineKind::boundary), .crease = 0.5F});
    return lines.segments.size();
}

TEST(Sections, HalfACubeIsClosed) {
    const Section half = cut(cube(), {0, 0, 0.25}, {0, 0, 1});
    EXPECT_TRUE(half.notes.empty());
    EXPECT_EQ(open_edges(half.mesh), 0U);
    EXPECT_NEAR(volume(half.mesh), 4 * 1.25, 1e-6);
    EXPECT_NEAR(face_area(half.mesh, {0, 0, 0.25}, {0, 0, 1}), 4, 1e-6);
    const auto outlines = polylines(half.mesh, PolylineKind::section);
    ASSERT_EQ(outlines.size(), 1U);
    EXPECT_EQ(outlines[0].front(), outlines[0].back());
    for (const glm::vec3 point : outlines[0]) {
        EXPECT_EQ(point.z, 0.25F);
        EXPECT_EQ(std::max(std::abs(point.x), std::abs(point.y)), 1);
    }
    // Positions of the cube keep their numbers.
    for (std::size_t i = 0; i < cube().positions.size(); ++i)
        EXPECT_EQ(half.mesh.positions[i], cube().positions[i]);
}

TEST(Sections, LinesAreOfTheirOwnKinds) {
    const LineSet lines = extract_lines(cut(cube(), {0, 0, 0.25}, {0, 0, 1}).mesh);
    const auto count = [&](LineKind kind) {
        return lines.kind_counts[static_cast<std::size_t>(kind)];
    };
    // 4 sides, each in two parts because its diagonal was cut.
    EXPECT_EQ(count(LineKind::section), 8U);
    EXPECT_GT(count(LineKind::hatching), 20U);
    EXPECT_EQ(count(LineKind::crease), 8U);
    EXPECT_EQ(count(LineKind::boundary), 0U);
    for (const Segment& segment : lines.segments) {
        if ((segment.tag & LA_TAG_KIND_MASK) != LA_KIND_SECTION) continue;
        EXPECT_NE(segment.face_a, LA_NO_FACE); // the lines know their faces
        EXPECT_NE(segment.face_b, LA_NO_FACE);
        EXPECT_TRUE(segment.tag & LA_TAG_CLOSED); // a closed path around the corners
    }
}

TEST(Sections, TheSectionOfACylinderIsACircle) {
    const Mesh mesh = cylinder(64, true); // along y
    const Section across = cut(mesh, {0, 0.3, 0}, {0, 1, 0});
    const auto outlines = polylines(across.mesh, PolylineKind::section);
    ASSERT_EQ(outlines.size(), 1U);
    for (const glm::vec3 point : outlines[0]) {
        EXPECT_NEAR(std::hypot(point.x, point.z), 1, 0.0013); // within the chords of the mesh
        EXPECT_EQ(point.y, 0.3F);
    }
    const double whole = 32 * std::sin(std::numbers::pi / 32); // of 64 sides
    EXPECT_NEAR(volume(across.mesh), 1.3 * whole, 1e-5);
    EXPECT_EQ(open_edges(across.mesh), 0U);
}

TEST(Sections, NormalsOfTheSurfaceAreCutToo) {
    Mesh mesh = cylinder(64, false); // along y
    for (const glm::uvec3 t : mesh.triangles) {
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 place = mesh.positions[t[k]];
            mesh.corner_normals.push_back(glm::normalize(glm::vec3{place.x, 0, place.z}));
        }
    }
    const Mesh half = cut(mesh, {0, 0.3, 0}, {0, 1, 0.3}).mesh;
    ASSERT_EQ(half.corner_normals.size(), 3 * half.triangles.size());
    std::size_t round = 0, of_cut = 0;
    for (std::size_t i = 0; i < half.corner_normals.size(); ++i) {
        const glm::vec3 normal = half.corner_normals[i];
        const glm::vec3 place = half.positions[half.triangles[i / 3][static_cast<int>(i % 3)]];
        if (normal == glm::vec3{0}) {
            EXPECT_NEAR(place.y + 0.3F * place.z, 0.3F, 1e-5F);
            ++of_cut;
            continue;
        }
        // Between two corners the normal is that of the chord. It is near that of the circle.
        EXPECT_NEAR(glm::dot(normal, glm::normalize(glm::vec3{place.x, 0, place.z})), 1, 2e-3);
        ++round;
    }
    EXPECT_GT(round, 192U);
    EXPECT_GT(of_cut, 60U);
}

TEST(Sections, CutsInAnyDirectionGiveTwoClosedHalves) {
    test::Random random{11};
    const Mesh mesh = sphere(4);
    const double whole = volume(mesh);
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 normal{random.direction()};
        const glm::dvec3 point{random.point(0.4F)};
        const Section one = cut(mesh, point, normal), other = cut(mesh, point, -normal);
        EXPECT_NEAR(volume(one.mesh) + volume(other.mesh), whole, 1e-4);
        EXPECT_EQ(open_edges(one.mesh), 0U);
        EXPECT_NEAR(face_area(one.mesh, point, normal), face_area(other.mesh, point, -normal),
                    1e-4);
    }
}

TEST(Sections, ThroughCornersAndAlongFaces) {
    // The planes go through four corners of the cube and their edges, or through one corner alone.
    for (const glm::dvec3 normal : {glm::dvec3{1, 1, 0}, {1, 0, -1}, {1, 1, 1}}) {
        const Section half = cut(cube(), {0, 0, 0}, normal);
        EXPECT_EQ(open_edges(half.mesh), 0U);
        EXPECT_NEAR(volume(half.mesh), 4, 1e-5);
    }
    // The plane lies in the cube's upper face, and so does the face that closes the cube.
    const Section along = cut(cube(), {0, 0, 1}, {0, 0, 1});
    EXPECT_EQ(open_edges(along.mesh), 0U);
    EXPECT_NEAR(volume(along.mesh), 8, 1e-6);
    EXPECT_FALSE(polylines(along.mesh, PolylineKind::hatching).empty());
}

/// The number of edges with an odd number of triangles. It is 0 for closed bodies, even if they
/// meet in edges.
std::size_t odd_edges(const Mesh& mesh) {
    using Corner = std::array<float, 3>;
    std::map<std::pair<Corner, Corner>, int> counts;
    for (const glm::uvec3& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            const glm::vec3 p = mesh.positions[t[i]], q = mesh.positions[t[(i + 1) % 3]];
            ++counts[std::minmax(Corner{p.x, p.y, p.z}, Corner{q.x, q.y, q.z})];
        }
    }
    return static_cast<std::size_t>(
        std::ranges::count_if(counts, [](const auto& entry) { return entry.second % 2 == 1; }));
}

/// Blocks of a grid, which are closed together. Their corners, edges and faces lie in planes of the
/// grid.
Mesh blocks(test::Random& random, int size) {
    std::vector<bool> solid;
    for (int i = 0; i < size * size * size; ++i) solid.push_back(random.below(5) != 0);
    const auto is_solid = [&](glm::ivec3 at) {
        if (std::min({at.x, at.y, at.z}) < 0 || std::max({at.x, at.y, at.z}) >= size) return false;
        return bool{solid[static_cast<std::size_t>((at.z * size + at.y) * size + at.x)]};
    };
    Mesh mesh;
    for (int i = 0; i < size * size * size; ++i) {
        const glm::ivec3 at{i % size, i / size % size, i / size / size};
        for (int side = 0; is_solid(at) && side < 6; ++side) {
            const int axis = side / 2;
            glm::ivec3 out{0}, along{0}, across{0};
            out[axis] = side % 2 == 0 ? 1 : -1;
            along[(axis + 1) % 3] = 1;
            across[(axis + 2) % 3] = out[axis];
            if (is_solid(at + out)) continue;
            const glm::vec3 corner{2 * at + 1 + out - along - across};
            const auto first = static_cast<std::uint32_t>(mesh.positions.size());
            for (const glm::vec3 more :
                 {glm::vec3{0}, 2.0F * glm::vec3{along}, 2.0F * glm::vec3{along + across},
                  2.0F * glm::vec3{across}})
                mesh.positions.push_back(corner + more);
            mesh.triangles.emplace_back(first, first + 1, first + 2);
            mesh.triangles.emplace_back(first, first + 2, first + 3);
        }
    }
    return mesh;
}

TEST(Sections, ClosedMeshesStayClosedWhereverThePlaneCuts) {
    test::Random random{29};
    int cuts = 0;
    for (int round = 0; round < 60; ++round) {
        const Mesh mesh = blocks(random, 4);
        const auto corner = [&] {
            return glm::dvec3{
                mesh.positions[random.below(static_cast<std::uint32_t>(mesh.positions.size()))]};
        };
        const glm::dvec3 a = corner(), b = corner(), c = corner();
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        if (normal == glm::dvec3{0}) continue;
        const std::vector both{plane(a, normal), plane(a, -normal)};
        try {
            double left = 0;
            for (const SectionPlane& one : both) {
                const Section half = cut_mesh(mesh, std::vector{one}, {.none = true});
                EXPECT_EQ(half.notes, std::vector<std::string>{}) << "round " << round;
                EXPECT_EQ(odd_edges(half.mesh), 0U) << "round " << round;
                left += volume(half.mesh);
            }
            EXPECT_NEAR(left, volume(mesh), 1e-3) << "round " << round;
            ++cuts;
        } catch (const UsageError&) { // the plane lies along the outside
        }
    }
    EXPECT_GT(cuts, 40);
}

TEST(Sections, CornersThatDifferByRoundingAreJoined) {
    // As from exporters, every triangle has its own corners, which differ slightly from those of
    // its neighbours.
    test::Random random{31};
    Mesh mesh = test::with_own_corners(sphere(3));
    for (glm::vec3& position : mesh.positions) position += 2e-7F * random.point(1);
    ASSERT_GT(open_edges(mesh), 0U);
    for (int i = 0; i < 20; ++i) {
        const Section half = cut(mesh, glm::dvec3{random.point(0.4F)}, random.direction());
        EXPECT_EQ(half.notes, std::vector<std::string>{});
        EXPECT_EQ(open_edges(half.mesh), 0U);
    }
    // Some corners lie on the plane, and others nearly do.
    for (int i = 0; i < 30; ++i) {
        const Section half = cut(mesh, {0, 0, 2e-7 * i}, {0, 0, 1});
        EXPECT_EQ(half.notes, std::vector<std::string>{}) << i;
        EXPECT_EQ(open_edges(half.mesh), 0U) << i;
    }
}

TEST(Sections, ATriangleThatStandsTwiceIsCutOnce) {
    Mesh mesh = cube();
    for (std::size_t i = 0; i < 12; i += 3) mesh.triangles.push_back(mesh.triangles[i]);
    const Section half = cut(mesh, {0, 0.1, 0.25}, {0, 0.2, 1});
    EXPECT_EQ(half.notes, std::vector<std::string>{});
    EXPECT_EQ(polylines(half.mesh, PolylineKind::section).size(), 1U);
}

TEST(Sections, HollowsAndHolesStayEmpty) {
    Mesh shell = placed(cube(), {0, 0, 0}, 1);
    add(shell, turned_over(placed(cube(), {0.2F, 0, 0}, 0.5F))); // a cavity
    add(shell, placed(cube(), {0.2F, 0.1F, 0}, 0.2F));           // and a body in the cavity
    const Section half = cut(shell, {0, 0, 0.05}, {0, 0, 1}, {.spacing = 0.1});
    EXPECT_NEAR(face_area(half.mesh, {0, 0, 0.05}, {0, 0, 1}), 4 - 1 + 0.16, 1e-5);
    EXPECT_EQ(open_edges(half.mesh), 0U);
    EXPECT_EQ(polylines(half.mesh, PolylineKind::section).size(), 3U);
    for (const auto& line : polylines(half.mesh, PolylineKind::hatching)) {
        for (const float share : {0.1F, 0.3F, 0.5F, 0.7F, 0.9F}) {
            const glm::vec3 at = glm::mix(line.front(), line.back(), share) - glm::vec3{0.2F, 0, 0};
            const bool in_hollow = std::max(std::abs(at.x), std::abs(at.y)) < 0.499F;
            const bool in_piece = std::max(std::abs(at.x), std::abs(at.y - 0.1F)) < 0.201F;
            EXPECT_TRUE(!in_hollow || in_piece) << at.x << " " << at.y;
        }
    }
    // The same for a model that is inside out.
    EXPECT_NEAR(
        face_area(cut(turned_over(shell), {0, 0, 0.05}, {0, 0, 1}).mesh, {0, 0, 0.05}, {0, 0, 1}),
        3.16, 1e-5);
}

TEST(Sections, ManyHoles) {
    // A plate with 36 holes. The outlines of its section are one path and 36 paths within that one.
    Mesh plate = placed(cube(), {0, 0, 0}, 10);
    test::Random random{3};
    double holes = 0;
    for (int i = 0; i < 36; ++i) {
        const glm::vec3 at{-8.0F + 3.1F * static_cast<float>(i % 6) + random.between(0, 0.5F),
                           -8.0F + 3.1F * static_cast<float>(i / 6) + random.between(0, 0.5F), 0};
        const float radius = random.between(0.3F, 1.2F);
        const auto sides = 3 + random.below(20);
        Mesh hole = test::moved(cylinder(sides, true),
                                glm::rotate(glm::mat4{1}, 1.5707963F, glm::vec3{1, 0, 0}));
        add(plate, turned_over(placed(hole, at, radius)));
        holes += 0.5 * sides * std::sin(2 * std::numbers::pi / sides) *
                 static_cast<double>(radius * radius);
    }
    const Section half = cut(plate, {0, 0, 0.1}, {0, 0, 1}, {.none = true});
    EXPECT_NEAR(face_area(half.mesh, {0, 0, 0.1}, {0, 0, 1}), 400 - holes, 1e-3);
    EXPECT_EQ(polylines(half.mesh, PolylineKind::section).size(), 37U);
    EXPECT_EQ(open_edges(half.mesh), 0U);
}

TEST(Sections, HatchingIsTurnedFromPartToPart) {
    Mesh two = cube();
    add(two, placed(cube(), {3, 0, 0}, 1));
    const Section half = cut(two, {0, 0, 0}, {0, 0, 1}, {.spacing = 0.2, .angle = 30});
    std::vector<double> angles;
    for (const auto& line : polylines(half.mesh, PolylineKind::hatching)) {
        ASSERT_EQ(line.size(), 2U);
        const glm::dvec3 way = line[1] - line[0];
        const double angle = std::atan2(way.y, way.x) * 180 / std::numbers::pi;
        const bool left = line[0].x < 1.5F;
        EXPECT_NEAR(std::fmod(angle + 360, 180), left ? 30 : 120, 0.01);
        EXPECT_EQ(line[0].z, 0);
    }
    // The lines are 0.2 apart. Across them the cube's section is 2 (cos 30 + sin 30) wide.
    const auto lines = polylines(half.mesh, PolylineKind::hatching);
    const auto of_left =
        std::ranges::count_if(lines, [](const auto& line) { return line[0].x < 1.5F; });
    EXPECT_NEAR(static_cast<double>(of_left), 2 * (0.866 + 0.5) / 0.2, 1.5);
    // An object with a name is one part, even if it has several pieces.
    two.groups = {{"pair", ""}};
    two.triangle_group.assign(two.triangles.size(), 0);
    for (const auto& line :
         polylines(cut(two, {0, 0, 0}, {0, 0, 1}, {.spacing = 0.2, .angle = 30}).mesh,
                   PolylineKind::hatching)) {
        const glm::dvec3 way = line[1] - line[0];
        EXPECT_NEAR(std::fmod(std::atan2(way.y, way.x) * 180 / std::numbers::pi + 360, 180), 30,
                    0.01);
    }
}

TEST(Sections, AQuarterIsTwoPlanes) {
    // The second plane cuts a body that has a face of the first cut.
    const std::vector planes{plane({0, 0, 0}, {0, 0, 1}), plane({0, 0, 0}, {1, 0, 0})};
    const Section quarter = cut_mesh(cube(), planes, {.spacing = 0.25});
    EXPECT_NEAR(volume(quarter.mesh), 2, 1e-6);
    EXPECT_EQ(open_edges(quarter.mesh), 0U);
    EXPECT_NEAR(face_area(quarter.mesh, {0, 0, 0}, {0, 0, 1}), 2, 1e-6);
    EXPECT_NEAR(face_area(quarter.mesh, {0, 0, 0}, {1, 0, 0}), 2, 1e-6);
    for (const auto& line : polylines(quarter.mesh, PolylineKind::hatching))
        for (const glm::vec3 point : line) EXPECT_LE(std::max(point.x, point.z), 1e-6F);
}

TEST(Sections, ObjectsThatTouchAndPiecesOfOneSurface) {
    // Two cubes, one upon the other, with common corners.
    Mesh two = cube();
    add(two, placed(cube(), {0, 2, 0}, 1));
    two.groups = {{"lower", ""}, {"upper", ""}};
    two.triangle_group.assign(two.triangles.size(), 0);
    std::fill(two.triangle_group.begin() + 12, two.triangle_group.end(), 1U);
    const Section half = cut(two, {0, 0, 0}, {0, 0, 1});
    EXPECT_TRUE(half.notes.empty());
    EXPECT_EQ(polylines(half.mesh, PolylineKind::section).size(), 2U);
    EXPECT_NEAR(face_area(half.mesh, {0, 0, 0}, {0, 0, 1}), 8, 1e-6);
    // One cube with another name for every side.
    Mesh sides = cube();
    sides.triangle_group.clear();
    for (std::uint32_t i = 0; i < sides.triangles.size(); ++i) {
        sides.groups.push_back({"side " + std::to_string(i), ""});
        sides.triangle_group.push_back(i);
    }
    const Section one = cut(sides, {0, 0, 0.25}, {0, 0, 1});
    EXPECT_TRUE(one.notes.empty());
    EXPECT_EQ(polylines(one.mesh, PolylineKind::section).size(), 1U);
    EXPECT_NEAR(face_area(one.mesh, {0, 0, 0.25}, {0, 0, 1}), 4, 1e-6);
}

TEST(Sections, UncutPartsStayWhole) {
    // A bolt of 16 sides in a cube.
    Mesh two = cube();
    add(two, placed(cylinder(16, true), {0, 0, 0}, 0.5F));
    two.groups = {{"frame/plate", ""}, {"frame/bolts/Bolt 1", ""}};
    two.triangle_group.assign(two.triangles.size(), 1);
    std::fill_n(two.triangle_group.begin(), 12, 0U);
    two.triangle_object = two.triangle_group;
    const std::vector planes{plane({0, 0, 0}, {0, 0, 1}), plane({0, 0, 0}, {1, 0, 0})};
    const double bolt = volume(placed(cylinder(16, true), {0, 0, 0}, 0.5F));
    for (const std::string name : {"Bolt*", "bolts", "bolts/Bolt ?"}) {
        SCOPED_TRACE(name);
        const Section rest = cut_mesh(two, planes, {.spacing = 0.1}, std::array{name});
        EXPECT_NEAR(volume(rest.mesh), 2 + bolt, 1e-5);
        EXPECT_EQ(open_edges(rest.mesh), 0U);
        EXPECT_NEAR(face_area(rest.mesh, {0, 0, 0}, {0, 0, 1}), 2, 1e-5);
    }
    EXPECT_NEAR(volume(cut_mesh(two, planes).mesh), 2 + bolt / 4, 1e-5);
}

TEST(Sections, LinesAndEdgesOfUncutPartsStayWhole) {
    Mesh two = cube();
    add(two, placed(cube(), {3, 0, 0}, 1));
    two.groups = {{"left", ""}, {"right", ""}};
    two.triangle_group.assign(two.triangles.size(), 1);
    std::fill_n(two.triangle_group.begin(), 12, 0U);
    two.triangle_object = two.triangle_group;
    for (const std::uint32_t first : {0U, 8U}) {
        two.polylines.push_back(
            {first, first + 1, first + 2, first + 3, first + 4, first + 5, first + 6, first + 7});
        two.polyline_object.push_back(first / 8);
        for (std::uint32_t i = 0; i < 8; ++i)
            for (std::uint32_t k = i + 1; k < 8; ++k)
                if (glm::distance(two.positions[first + i], two.positions[first + k]) < 2.1F)
                    two.known_edges.push_back({.from = first + i, .to = first + k});
    }
    const Section rest = cut_mesh(two, std::array{plane({0, 0, 0}, {0, 0, 1})}, {},
                                  std::array<std::string, 1>{"right"});
    std::size_t whole = 0;
    for (const KnownEdge& edge : rest.mesh.known_edges) {
        const glm::vec3 a = rest.mesh.positions[edge.from], b = rest.mesh.positions[edge.to];
        if (a.x < 1.5F) {
            EXPECT_LE(std::max(a.z, b.z), 0);
        }
        whole += a.x > 1.5F ? 1 : 0;
    }
    EXPECT_EQ(whole, 12U);
    float highest = -1;
    for (const auto& line : polylines(rest.mesh, PolylineKind::file))
        for (const glm::vec3 at : line)
            if (at.x > 1.5F) highest = std::max(highest, at.z);
    EXPECT_EQ(highest, 1);
}

// As in meshes of programs: one object has all parts.
TEST(Sections, CutPartsBesideUncutOnesOfTheSameObjectLoseTheirLines) {
    Mesh two = cube();
    add(two, placed(cylinder(16, true), {0, 0, 0}, 0.5F));
    two.groups = {{"plate", ""}, {"Bolt 1", ""}};
    two.triangle_group.assign(two.triangles.size(), 1);
    std::fill_n(two.triangle_group.begin(), 12, 0U);
    two.triangle_object.assign(two.triangles.size(), 0);
    add_polyline(two, std::vector<glm::vec3>{{-1, 1, -1}, {1, 1, -1}});
    two.polyline_object = {0};
    const std::vector planes{plane({0, 0, 0}, {0, 0, 1}), plane({0, 0, 0}, {1, 0, 0})};
    const Section rest =
        cut_mesh(two, planes, {.spacing = 0.1}, std::array<std::string, 1>{"Bolt*"});
    for (const auto kind : {PolylineKind::section, PolylineKind::hatching, PolylineKind::file}) {
        const auto lines = polylines(rest.mesh, kind);
        EXPECT_FALSE(lines.empty());
        for (const auto& line : lines)
            for (const glm::vec3 at : line) EXPECT_LE(at.x, 1e-5F);
    }
}

TEST(Sections, WhatDoesNotCloseIsSaidAndStaysOpen) {
    Mesh mesh = cylinder(16, false);
    mesh.triangles.pop_back(); // a gap in its side
    mesh.triangles.pop_back();
    add(mesh, placed(cube(), {5, 0, 0}, 1));
    const Section half = cut(mesh, {0, 0.25, 0}, {0, 1, 0});
    ASSERT_EQ(half.notes.size(), 1U);
    EXPECT_NE(half.notes[0].find("does not close, at "), std::string::npos) << half.notes[0];
    EXPECT_NE(half.notes[0].find("1 more places"), std::string::npos) << half.notes[0];
    // The cube beside it is closed, and hatched.
    EXPECT_NEAR(face_area(half.mesh, {0, 0.25, 0}, {0, 1, 0}), 4, 1e-6);
    for (const auto& line : polylines(half.mesh, PolylineKind::hatching))
        EXPECT_GT(line[0].x, 3.9F);
    EXPECT_GT(polylines(half.mesh, PolylineKind::section).size(), 10U); // it is outlined, too
}

TEST(Sections, CornersOfTheirOwnAndBothWindings) {
    const Mesh soup = test::with_own_corners(sphere(3)); // as in STL files
    EXPECT_TRUE(cut(soup, {0.1, 0, 0}, {1, 0, 0}).notes.empty());
    EXPECT_EQ(open_edges(cut(soup, {0.1, 0, 0}, {1, 0, 0}).mesh), 0U);
    test::Random random{2};
    const Section odd = cut(test::with_random_windings(sphere(3), random), {0.1, 0, 0}, {1, 0, 0});
    EXPECT_TRUE(odd.notes.empty());
    EXPECT_EQ(polylines(odd.mesh, PolylineKind::section).size(), 1U);
    EXPECT_EQ(open_edges(odd.mesh), 0U);
}

TEST(Sections, FilesLinesAreCutToo) {
    Mesh mesh = cube();
    const std::vector<glm::vec3> line{{0, 0, -2}, {0, 0, 2}, {1, 0, 2}, {1, 0, -2}};
    add_polyline(mesh, line);
    const auto left = polylines(cut(mesh, {0, 0, 0.5}, {0, 0, 1}).mesh, PolylineKind::file);
    ASSERT_EQ(left.size(), 2U);
    EXPECT_EQ(left[0], (std::vector<glm::vec3>{{0, 0, -2}, {0, 0, 0.5}}));
    EXPECT_EQ(left[1], (std::vector<glm::vec3>{{1, 0, 0.5}, {1, 0, -2}}));
}

std::string refusal(const std::function<void()>& what) {
    try {
        what();
    } catch (const UsageError& error) {
        return error.what();
    }
    return {};
}

TEST(Sections, RefusesWhatCannotBe) {
    const auto cut_at = [](glm::dvec3 point, glm::dvec3 normal, Hatching hatching = {}) {
        return refusal([&] { cut(cube(), point, normal, hatching); });
    };
    EXPECT_EQ(cut_at({0, 0, 5}, {0, 0, 1}),
              "section 0,0,5/0,0,1 misses the model, which goes from z=-1 to 1");
    EXPECT_NE(cut_at({0, 0, 5}, {0, 0, -1}).find("misses"), std::string::npos);
    EXPECT_NE(cut_at({3, 3, 3}, {1, 1, 1}).find("misses the model, which lies from"),
              std::string::npos);
    EXPECT_EQ(cut_at({0, 0, -1}, {0, 0, 1}), "section 0,0,-1/0,0,1 cuts away all of the model, "
                                             "which goes from z=-1 to 1; -z=-1 keeps it");
    EXPECT_NE(cut_at({0, 1, 0}, {0, -1, 0}).find("; +y=1 keeps it"), std::string::npos);
    EXPECT_NE(cut_at({-1, -1, -1}, {1, 1, 1}).find("the opposite normal keeps it"),
              std::string::npos);
    EXPECT_NE(cut_at({0, 0, 0}, {0, 0, 0}).find("normal"), std::string::npos);
    EXPECT_NE(cut_at({0, 0, 0}, {0, 0, 1}, {.spacing = -1}).find("spacing"), std::string::npos);
    EXPECT_NE(cut_at({0, 0, 0}, {0, 0, 1}, {.spacing = 1e-9}).find("too near"), std::string::npos);
    const std::vector<SectionPlane> many(7, plane({0, 0, 0}, {0, 0, 1}));
    EXPECT_NE(refusal([&] { cut_mesh(cube(), many); }).find("6 at most"), std::string::npos);
    EXPECT_NE(refusal([&] {
                  cut_mesh(cube(), std::array{many[0]}, {}, std::array<std::string, 1>{"Bolt*"});
              }).find("no part is called \"Bolt*\""),
              std::string::npos);
    EXPECT_NE(refusal([&] {
                  cut_mesh(cube(), std::array{many[0]}, {}, std::array<std::string, 1>{});
              }).find("must not be empty"),
              std::string::npos);
    // The plane goes through the upper cube alone.
    Mesh two = cube();
    add(two, placed(cube(), {3, 0, 3}, 1));
    two.groups = {{"lower", ""}, {"upper", ""}};
    two.triangle_group.assign(two.triangles.size(), 1);
    std::fill_n(two.triangle_group.begin(), 12, 0U);
    EXPECT_NE(refusal([&] {
                  cut_mesh(two, std::array{plane({0, 0, 3}, {0, 0, 1})}, {},
                           std::array<std::string, 1>{"upper"});
              }).find("cuts nothing"),
              std::string::npos);
}

TEST(Sections, PlanesAsText) {
    const Bounds bounds{{0, 10, -4}, {2, 30, 4}};
    const SectionPlane at = parse_section("x=0.5", bounds);
    EXPECT_EQ(at.point.x, 0.5);
    EXPECT_EQ(at.normal, (glm::dvec3{1, 0, 0}));
    EXPECT_FALSE(at.side_is_given);
    const SectionPlane share = parse_section("-y=25%", bounds);
    EXPECT_EQ(share.point.y, 15);
    EXPECT_EQ(share.normal, (glm::dvec3{0, -1, 0}));
    EXPECT_TRUE(share.side_is_given);
    const SectionPlane free = parse_section("1,-2.5,3/0,1,1", bounds);
    EXPECT_EQ(free.point, (glm::dvec3{1, -2.5, 3}));
    EXPECT_EQ(free.normal, (glm::dvec3{0, 1, 1}));
    for (const char* wrong : {"", "x", "x=", "w=1", "x=1mm", "1,2/0,0,1", "1,2,3/0,0,0", "1,2,3/",
                              "x=nan", "x=1e99", "--x=1", "1,2,3,4/0,0,1"}) {
        EXPECT_THROW(parse_section(wrong, bounds), UsageError) << wrong;
    }
}

/// The density of hatching depends on the size of the cut, not on other bodies.
TEST(Section, HatchingIsAsDenseAsTheCutIsLarge) {
    const auto lines = [](float size, const Mesh& beside) {
        Mesh mesh = test::cube();
        for (glm::vec3& position : mesh.positions) position *= size;
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), beside.positions.begin(),
                              beside.positions.end());
        for (const glm::uvec3 t : beside.triangles) mesh.triangles.push_back(t + first);
        return polylines(cut(mesh, {0.4 * static_cast<double>(size), 0, 0}, {1, 0, 0}).mesh,
                         PolylineKind::hatching)
            .size();
    };
    const std::size_t alone = lines(1, {});
    EXPECT_GT(alone, 20U);
    EXPECT_EQ(lines(100, {}), alone);
    Mesh far = test::cube(); // the plane misses it
    for (glm::vec3& position : far.positions) position.x -= 1000;
    EXPECT_EQ(lines(1, far), alone);
}

} // namespace
} // namespace lineatlas
