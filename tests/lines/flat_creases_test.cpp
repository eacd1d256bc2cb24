#include "lines/flat_creases.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include "test_meshes.hpp"

namespace lineatlas {
namespace {

/// How many creases are drawn that bend by less than 28.8 degrees.
std::int64_t flat_creases_of(const Mesh& mesh) {
    constexpr LineKindMask kinds =
        mask_of(LineKind::crease) | mask_of(LineKind::boundary) | mask_of(LineKind::silhouette);
    const LineSet fixed = extract_lines(mesh, {.lines = kinds, .crease = least_crease_angle});
    const LineSet chosen = extract_lines(mesh, {.lines = kinds});
    return std::int64_t{chosen.kind_counts[LA_KIND_CREASE]} +
           static_cast<std::int64_t>(chosen.left_out.noisy_creases) -
           std::int64_t{fixed.kind_counts[LA_KIND_CREASE]};
}

/// A polygon, any number of corners.
void add_face(Mesh& mesh, const std::vector<std::uint32_t>& corners) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

/// Walls of height 1 around a rectangle, and a roof on them.
Mesh hip_roof(float width, float depth, float pitch) {
    Mesh mesh;
    const float x = width / 2, z = depth / 2, rise = z * std::tan(glm::radians(pitch));
    for (const float y : {0.0F, 1.0F})
        for (const glm::vec2 corner : {glm::vec2{-x, -z}, {x, -z}, {x, z}, {-x, z}})
            mesh.positions.emplace_back(corner.x, y, corner.y);
    mesh.positions.emplace_back(z - x, 1 + rise, 0);
    if (width > depth) mesh.positions.emplace_back(x - z, 1 + rise, 0);
    const std::uint32_t left = 8, right = width > depth ? 9 : 8;
    add_face(mesh, {0, 1, 2, 3});
    for (std::uint32_t i = 0; i < 4; ++i) {
        const std::uint32_t next = (i + 1) % 4;
        add_face(mesh, {i, i + 4, next + 4, next});
    }
    add_face(mesh, {7, left, 4});
    add_face(mesh, {5, right, 6});
    if (left == right) {
        add_face(mesh, {4, left, 5});
        add_face(mesh, {6, left, 7});
    } else {
        add_face(mesh, {4, left, right, 5});
        add_face(mesh, {6, right, left, 7});
    }
    return mesh;
}

/// A band between two lines of points in the plane, pulled up by `height`.
Mesh wall(const std::vector<glm::vec2>& one, const std::vector<glm::vec2>& other, float height) {
    Mesh mesh;
    const auto count = static_cast<std::uint32_t>(one.size());
    for (const float y : {0.0F, height})
        for (const std::vector<glm::vec2>* line : {&one, &other})
            for (const glm::vec2 point : *line) mesh.positions.emplace_back(point.x, y, point.y);
    const auto at = [&](std::uint32_t i, std::uint32_t line, std::uint32_t level) {
        return (2 * level + line) * count + i;
    };
    for (std::uint32_t i = 0; i + 1 < count; ++i) {
        add_face(mesh, {at(i, 0, 0), at(i + 1, 0, 0), at(i + 1, 1, 0), at(i, 1, 0)});
        add_face(mesh, {at(i, 0, 1), at(i, 1, 1), at(i + 1, 1, 1), at(i + 1, 0, 1)});
        add_face(mesh, {at(i, 0, 0), at(i, 0, 1), at(i + 1, 0, 1), at(i + 1, 0, 0)});
        add_face(mesh, {at(i, 1, 0), at(i + 1, 1, 0), at(i + 1, 1, 1), at(i, 1, 1)});
    }
    for (const std::uint32_t end : {0U, count - 1})
        add_face(mesh, {at(end, 0, 0), at(end, 1, 0), at(end, 1, 1), at(end, 0, 1)});
    return mesh;
}

/// A wall of thickness 0.3 that turns by `turn` degrees at each of the corners between its pieces.
Mesh bent_wall(const std::vector<float>& turns, float piece) {
    std::vector<glm::vec2> inner, outer;
    glm::vec2 place{0};
    float way = 0;
    for (std::size_t i = 0; i < turns.size() + 2; ++i) {
        const float turn = i > 0 && i <= turns.size() ? glm::radians(turns[i - 1]) : 0;
        const float across = way + turn / 2;
        inner.push_back(place);
        outer.push_back(place +
                        0.3F / std::cos(turn / 2) * glm::vec2{-std::sin(across), std::cos(across)});
        way += turn;
        place += piece * glm::vec2{std::cos(way), std::sin(way)};
    }
    return wall(inner, outer, 2);
}

/// A body of revolution with quads between rings (radius, height), closed where a radius is 0.
Mesh turned(std::uint32_t sides, const std::vector<glm::vec2>& rings) {
    Mesh mesh;
    for (const glm::vec2 ring : rings)
        for (std::uint32_t i = 0; i < sides; ++i) {
            const float angle =
                2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(sides);
            mesh.positions.emplace_back(ring.x * std::cos(angle), ring.y, ring.x * std::sin(angle));
        }
    for (std::uint32_t ring = 0; ring + 1 < rings.size(); ++ring)
        for (std::uint32_t i = 0; i < sides; ++i) {
            const std::uint32_t next = (i + 1) % sides;
            add_face(mesh, {ring * sides + i, (ring + 1) * sides + i, (ring + 1) * sides + next,
                            ring * sides + next});
        }
    return mesh;
}

TEST(FlatCreases, AreTheHipsOfRoofs) {
    for (int pitch = 5; pitch <= 45; pitch += 1) {
        // All lines: four below, four of the corners, eaves and hips.
        const LineSet square = extract_lines(hip_roof(4, 4, static_cast<float>(pitch)));
        EXPECT_EQ(square.kind_counts[LA_KIND_CREASE], 16U) << "pitch " << pitch;
        const LineSet longer = extract_lines(hip_roof(7, 4, static_cast<float>(pitch)));
        EXPECT_EQ(longer.kind_counts[LA_KIND_CREASE], 17U) << "and the ridge, pitch " << pitch;
    }
}

TEST(FlatCreases, AreNotTakenWithAnAngle) {
    const LineSet lines = extract_lines(hip_roof(4, 4, 10), {.crease = least_crease_angle});
    EXPECT_EQ(lines.kind_counts[LA_KIND_CREASE], 12U);
}

TEST(FlatCreases, AreWhereWallsBend) {
    EXPECT_EQ(flat_creases_of(bent_wall({22}, 3)), 2);
    EXPECT_EQ(flat_creases_of(bent_wall({22, -22}, 3)), 4) << "to and fro";
}

TEST(FlatCreases, AreNoFacetsOfRoundThings) {
    for (std::uint32_t sides = 8; sides <= 64; ++sides) {
        std::vector<glm::vec2> ball;
        for (std::uint32_t i = 0; i <= sides / 2; ++i) {
            const float angle =
                2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(sides);
            ball.emplace_back(std::sin(angle), -std::cos(angle));
        }
        EXPECT_EQ(flat_creases_of(turned(sides, {{0, -1}, {1, -1}, {1, 1}, {0, 1}})), 0) << sides;
        EXPECT_EQ(flat_creases_of(turned(sides, ball)), 0) << sides;
        for (const float height : {0.1F, 0.3F, 1.0F, 4.0F}) {
            EXPECT_EQ(flat_creases_of(turned(sides, {{0, 0}, {1, 0}, {0, height}})), 0)
                << "cone, " << sides << " sides, height " << height;
            EXPECT_EQ(flat_creases_of(turned(sides, {{0, 0}, {1, 0}, {0.5F, height}, {0, height}})),
                      0)
                << "cut cone, " << sides << " sides, height " << height;
        }
    }
}

TEST(FlatCreases, AreNoFacetsOfFillets) {
    for (std::size_t facets = 3; facets <= 16; ++facets) {
        const std::vector<float> turns(facets, 90.0F / static_cast<float>(facets));
        EXPECT_EQ(flat_creases_of(bent_wall(turns, 1)), 0) << facets;
    }
}

TEST(FlatCreases, AreNoDiagonalsOfWarpedFaces) {
    // A box whose lid is turned by ten degrees.
    Mesh mesh = hip_roof(4, 4, 0);
    for (std::uint32_t i = 4; i < 8; ++i) {
        const glm::vec3 p = mesh.positions[i];
        const float sine = std::sin(glm::radians(10.0F)), cosine = std::cos(glm::radians(10.0F));
        mesh.positions[i] = {cosine * p.x - sine * p.z, p.y, sine * p.x + cosine * p.z};
    }
    EXPECT_EQ(flat_creases_of(mesh), 0);
}

TEST(FlatCreases, AreNoFoldsOfSheetsNorRough) {
    EXPECT_EQ(flat_creases_of(test::bent_pair(glm::radians(20.0F), false)), 0);
    test::Random random{48};
    for (const float height : {0.1F, 0.2F, 0.4F, 0.8F})
        EXPECT_EQ(flat_creases_of(test::height_field(random, 20, height)), 0) << height;
}

TEST(FlatCreases, AreLarge) {
    Mesh mesh = hip_roof(4, 4, 10);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const Mesh plate = hip_roof(400, 400, 0);
    for (const glm::vec3& position : plate.positions) mesh.positions.push_back(position + 3.0F);
    for (const glm::uvec3& triangle : plate.triangles) mesh.triangles.push_back(triangle + first);
    EXPECT_EQ(flat_creases_of(mesh), 0);
}

} // namespace
} // namespace lineatlas
