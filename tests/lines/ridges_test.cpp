// Ridges and valleys of surfaces with known crests and furrows.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "lineatlas/lines.hpp"
#include "test_meshes.hpp"
#include "waves.hpp"

namespace lineatlas {
namespace {

constexpr LineKindMask ridges_and_valleys = mask_of(LineKind::ridge) | mask_of(LineKind::valley);
using test::wave;
using test::Waves;

/// The parts of the lines of waves that run along a crest or a furrow, and other parts.
struct Found {
    float right = 0, wrong = 0; ///< length
    float covered = 0;          ///< share of the crests and furrows between the outer two
};

Found found_in(const LineSet& lines, const Waves& waves, float reach, float shift = 0) {
    Found found;
    constexpr int bins = 48; ///< along each line
    std::vector<std::array<bool, bins>> seen(2 * static_cast<std::size_t>(waves.crests) - 1);
    for (const Segment& segment : lines.segments) {
        const auto kind = static_cast<LineKind>(segment.tag & LA_TAG_KIND_MASK);
        if ((mask_of(kind) & ridges_and_valleys) == 0) continue;
        const glm::vec3 p = lines.vertices[segment.p], q = lines.vertices[segment.q];
        const glm::vec3 middle = 0.5F * (p + q);
        const float x = (middle.x - shift) / (wave / 2); // even at crests, odd in furrows
        const float nearest = std::round(x);
        const bool is_crest = static_cast<int>(nearest) % 2 == 0;
        const bool right =
            std::abs(x - nearest) * (wave / 2) <= reach && is_crest == (kind == LineKind::ridge);
        (right ? found.right : found.wrong) += glm::distance(p, q);
        const int bin = static_cast<int>(middle.z / waves.length * bins);
        if (right && nearest >= 0 && static_cast<std::size_t>(nearest) < seen.size() && bin >= 0 &&
            bin < bins)
            seen[static_cast<std::size_t>(nearest)].at(static_cast<std::size_t>(bin)) = true;
    }
    float count = 0;
    for (const auto& line : seen) count += static_cast<float>(std::ranges::count(line, true));
    found.covered = count / static_cast<float>(bins * seen.size());
    return found;
}

LineSet ridges_of(const Mesh& mesh) {
    return extract_lines(mesh, {.lines = ridges_and_valleys});
}

TEST(Ridges, RunAlongCrestsAndFurrows) {
    const Waves waves;
    const LineSet lines = ridges_of(waves.mesh());
    EXPECT_GT(lines.kind_counts[LA_KIND_RIDGE], 0U);
    EXPECT_GT(lines.kind_counts[LA_KIND_VALLEY], 0U);
    const Found found = found_in(lines, waves, 0.5F * waves.edge);
    EXPECT_GT(found.covered, 0.95F);
    EXPECT_LT(found.wrong, 0.02F * found.right);
    // Compared with places beside the crests the lines are wrong.
    const Found beside = found_in(lines, waves, 0.5F * waves.edge, waves.edge);
    EXPECT_GT(beside.wrong, 0.9F * (beside.wrong + beside.right));
}

TEST(Ridges, StayUnderNoise) {
    for (const float noise : {0.02F, 0.05F, 0.1F}) {
        const Waves waves{.noise = noise};
        const Found found = found_in(ridges_of(waves.mesh()), waves, waves.edge);
        EXPECT_GT(found.covered, 0.9F) << noise;
        EXPECT_LT(found.wrong, 0.1F * found.right) << noise;
    }
}

TEST(Ridges, StayWithHalfTheTriangles) {
    const Waves waves{.edge = 0.3F * std::numbers::sqrt2_v<float>};
    const Found found = found_in(ridges_of(waves.mesh()), waves, waves.edge);
    EXPECT_GT(found.covered, 0.8F);
    EXPECT_LT(found.wrong, 0.1F * found.right);
}

/// Creases of such a surface run in zigzags along its crests and furrows.
TEST(Ridges, TakeThePlaceOfCreases) {
    for (const float noise : {0.0F, 0.1F}) {
        const Waves waves{.noise = noise};
        const LineSet lines =
            extract_lines(waves.mesh(), {.lines = ridges_and_valleys | mask_of(LineKind::crease)});
        EXPECT_GT(found_in(lines, waves, waves.edge).covered, 0.9F) << noise;
        EXPECT_LT(lines.kind_counts[LA_KIND_CREASE], 30U) << noise;
    }
    // An angle from the user counts.
    const LineSet lines = extract_lines(Waves{}.mesh(), {.crease = 0.5F});
    EXPECT_GT(lines.kind_counts[LA_KIND_CREASE], 200U);
}

TEST(Ridges, LieWithinTheirTriangles) {
    const Mesh mesh = Waves{}.mesh();
    const LineSet lines = ridges_of(mesh);
    for (std::size_t i = 0; i < lines.segments.size(); ++i) {
        const Segment& segment = lines.segments[i];
        ASSERT_EQ(segment.face_a, segment.face_b);
        const glm::uvec3 t = lines.triangles[segment.face_a];
        const glm::vec3 a = lines.vertices[t.x];
        const glm::vec3 normal =
            glm::normalize(glm::cross(lines.vertices[t.y] - a, lines.vertices[t.z] - a));
        for (const std::uint32_t end : {segment.p, segment.q})
            EXPECT_NEAR(glm::dot(normal, lines.vertices[end] - a), 0, 1e-5F);
        EXPECT_EQ(lines.sources[i].triangle, lines.triangle_sources[segment.face_a]);
        EXPECT_EQ(lines.sources[i].from, LineSource::none);
    }
}

/// A wheel of radius 2 whose tube has radius 1.
Mesh torus() {
    constexpr std::uint32_t around = 160, across = 80;
    Mesh mesh;
    for (std::uint32_t i = 0; i < around; ++i) {
        for (std::uint32_t k = 0; k < across; ++k) {
            const float a = wave * static_cast<float>(i) / around;
            const float b =
                wave * (static_cast<float>(k) + 0.5F * static_cast<float>(i % 2)) / across;
            const float r = 2 + std::cos(b);
            mesh.positions.emplace_back(r * std::cos(a), std::sin(b), r * std::sin(a));
            const std::uint32_t next_i = (i + 1) % around, next_k = (k + 1) % across;
            mesh.triangles.push_back({i * across + k, i * across + next_k, next_i * across + k});
            mesh.triangles.push_back(
                {i * across + next_k, next_i * across + next_k, next_i * across + k});
        }
    }
    return mesh;
}

TEST(Ridges, AreNowhereOnRoundThings) {
    EXPECT_TRUE(ridges_of(test::sphere(5)).segments.empty());
    EXPECT_TRUE(ridges_of(torus()).segments.empty());
    test::Random random{7};
    Mesh rough = test::sphere(5);
    for (glm::vec3& p : rough.positions) p *= random.between(0.99F, 1.01F);
    EXPECT_TRUE(ridges_of(rough).segments.empty()) << "noise of a surface is no line";
}

TEST(Ridges, AreNowhereOnWhatSomebodyDesigned) {
    EXPECT_TRUE(ridges_of(test::cylinder(600, true)).segments.empty());
    // A corrugated sheet has strips that are flat along the crests.
    Waves waves;
    Mesh sheet = waves.mesh();
    const auto columns = static_cast<std::uint32_t>(waves.crests * wave / waves.edge);
    for (std::uint32_t i = 0; i < sheet.positions.size(); ++i) {
        glm::vec3& p = sheet.positions[i];
        p.x = waves.edge * static_cast<float>(i % (columns + 1)) - wave / 2;
        p.y = waves.height * std::cos(p.x);
    }
    EXPECT_TRUE(ridges_of(sheet).segments.empty());
}

TEST(Ridges, AreTheSameInEveryRun) {
    const Mesh mesh = Waves{.noise = 0.05F}.mesh();
    const LineSet one = ridges_of(mesh), other = ridges_of(mesh);
    ASSERT_EQ(one.segments.size(), other.segments.size());
    EXPECT_EQ(one.vertices, other.vertices);
}

TEST(Ridges, MoveWithTheirSurface) {
    const Mesh mesh = Waves{}.mesh();
    LineSet lines = ridges_of(mesh);
    std::vector<glm::vec3> lifted = mesh.positions;
    // Shears the waves, so that their crests are at other places.
    for (glm::vec3& p : lifted) p.y += p.x;
    const LineSet before = lines;
    move_vertices(lines, lifted);
    ASSERT_FALSE(lines.segments.empty());
    for (const Segment& segment : lines.segments) {
        const glm::vec3 was = before.vertices[segment.p], is = lines.vertices[segment.p];
        EXPECT_NEAR(is.x, was.x, 1e-4F);
        EXPECT_NEAR(is.y, was.y + was.x, 1e-4F);
    }
}

TEST(Ridges, AreOfTheKindsThatAreWanted) {
    const LineSet lines = extract_lines(Waves{}.mesh(), {.lines = mask_of(LineKind::valley)});
    EXPECT_GT(lines.kind_counts[LA_KIND_VALLEY], 0U);
    EXPECT_EQ(lines.kind_counts[LA_KIND_RIDGE], 0U);
}

} // namespace
} // namespace lineatlas
