#include "lines/noisy_creases.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "test_meshes.hpp"

namespace lineatlas {
namespace {

/// The number of creases of a mesh at 28.8 degrees, and the number of drawn ones.
struct Creases {
    std::uint32_t all, drawn;
    std::size_t noisy;

    explicit Creases(const Mesh& mesh) {
        constexpr LineKindMask kinds = mask_of(LineKind::crease) | mask_of(LineKind::silhouette);
        constexpr Silhouettes by_edges = Silhouettes::mesh;
        const LineSet fixed =
            extract_lines(mesh, {.lines = kinds, .crease = 0.5026548F, .silhouettes = by_edges});
        const LineSet chosen = extract_lines(mesh, {.lines = kinds, .silhouettes = by_edges});
        all = fixed.kind_counts[LA_KIND_CREASE];
        drawn = chosen.kind_counts[LA_KIND_CREASE];
        noisy = chosen.left_out.noisy_creases;
        EXPECT_EQ(fixed.left_out.noisy_creases, 0U) << "a number means that number";
        EXPECT_EQ(all, drawn + noisy);
        EXPECT_EQ(fixed.segments.size(), chosen.segments.size()) << "they are silhouettes still";
    }
};

/// A rough sheet of quads x quads squares along x and z, folded by `fold` radians about its middle
/// line along z.
Mesh folded_sheet(std::uint32_t quads, float roughness, float fold) {
    test::Random random{81};
    Mesh mesh;
    const float half = 0.5F * static_cast<float>(quads);
    for (std::uint32_t z = 0; z <= quads; ++z) {
        for (std::uint32_t x = 0; x <= quads; ++x) {
            const float across = static_cast<float>(x) - half;
            const float height = 2 * x == quads ? 0.0F : random.between(-roughness, roughness);
            const float angle = across > 0 ? fold : 0.0F;
            mesh.positions.emplace_back(across * std::cos(angle) - height * std::sin(angle),
                                        across * std::sin(angle) + height * std::cos(angle),
                                        static_cast<float>(z));
        }
    }
    for (std::uint32_t z = 0; z < quads; ++z) {
        for (std::uint32_t x = 0; x < quads; ++x) {
            const std::uint32_t i = z * (quads + 1) + x;
            mesh.triangles.push_back({i, i + quads + 1, i + 1});
            mesh.triangles.push_back({i + 1, i + quads + 1, i + quads + 2});
        }
    }
    return mesh;
}

TEST(NoisyCreases, AreNoneOfShapesWithFlatFaces) {
    for (const Mesh& mesh : {test::cube(), test::cylinder(6, true), test::cylinder(40, true)}) {
        const Creases creases{mesh};
        EXPECT_GT(creases.all, 0U);
        EXPECT_EQ(creases.noisy, 0U);
    }
}

TEST(NoisyCreases, AreNoneOfShapesThatRepeatThemselves) {
    // In these meshes no two neighbouring faces are in one plane.
    for (const Mesh& mesh : {test::tetrahedron(), test::sphere(0), test::sphere(1)}) {
        const Creases creases{test::moved(mesh, test::Random{82}.placement(1))};
        EXPECT_GT(creases.all, 0U);
        EXPECT_EQ(creases.noisy, 0U);
    }
}

/// A deformed box. None of its twelve triangles lies in the plane of another.
TEST(NoisyCreases, AreNoneOfACoarsePart) {
    Mesh mesh = test::cube();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const auto k = static_cast<float>(i);
        mesh.positions[i] +=
            0.2F * glm::vec3{std::sin(3 * k), std::sin(5 * k + 1), std::sin(7 * k + 2)};
    }
    EXPECT_EQ(extract_lines(mesh).left_out.noisy_creases, 0U);
    EXPECT_GE(extract_lines(mesh).kind_counts[LA_KIND_CREASE], 12U);
}

TEST(NoisyCreases, AreAllOfARoughSphere) {
    test::Random random{83};
    const Creases creases{test::with_random_radii(test::sphere(5), random, 0.95F)};
    EXPECT_GT(creases.all, 500U);
    EXPECT_LT(creases.drawn, creases.all / 50);
}

TEST(NoisyCreases, AreAllOfARoughSphereThatRepeatsItself) {
    // Marching cubes find the same noise in every octant of a shape with symmetries.
    Mesh mesh = test::sphere(5);
    for (glm::vec3& p : mesh.positions) {
        const glm::vec3 in_octant = glm::abs(p);
        p *= 1 + 0.05F * std::sin(1000 * glm::dot(in_octant, {1, 2.3F, 3.1F}));
    }
    const Creases creases{mesh};
    EXPECT_GT(creases.all, 500U);
    EXPECT_LT(creases.drawn, creases.all / 50);
}

TEST(NoisyCreases, LeaveAFoldInARoughSheet) {
    const Creases rough{folded_sheet(40, 0.15F, 0)};
    EXPECT_GT(rough.all, 10U);
    EXPECT_EQ(rough.drawn, 0U);
    for (const float degrees : {60.0F, 90.0F, 130.0F}) {
        const Creases folded{folded_sheet(40, 0.15F, glm::radians(degrees))};
        EXPECT_GE(folded.drawn, 40U) << degrees;
        EXPECT_LE(folded.drawn, 44U) << degrees;
    }
}

TEST(NoisyCreases, AreDroppedWhereTheyAreCrumbsOfTheModel) {
    // A tent that rises from the sheet and sinks back. Its ridge touches no other line.
    Mesh mesh = folded_sheet(40, 0.05F, 0);
    for (glm::vec3& p : mesh.positions) {
        const float rise = std::clamp((std::min(p.z, 40 - p.z) - 4) / 8, 0.0F, 1.0F);
        p.y += 4.2F * std::max(0.0F, 1 - std::abs(p.x) / 8) * rise;
    }
    const Creases near{mesh};
    EXPECT_GE(near.drawn, 16U);
    EXPECT_LE(near.drawn, 40U);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{5000, 0, 0}, {5000, 0, 1}, {5000, 1, 0}});
    mesh.triangles.push_back({first, first + 1, first + 2});
    const Creases far{mesh};
    EXPECT_EQ(far.all, near.all);
    EXPECT_LE(far.drawn, 2U) << "what hangs on the border of the sheet";
}

/// A sheet of 10 x 10 squares that is curved everywhere. It has a fold in its middle along z, bent
/// by `bend` in the middle of the fold and by `bend_at_border` at its ends.
Mesh curved_fold(float bend, float bend_at_border) {
    Mesh mesh = folded_sheet(10, 0, 0);
    for (glm::vec3& p : mesh.positions) {
        const float z = p.z - 5;
        const float share = 1 - z * z / 25;
        const float here = bend_at_border + (bend - bend_at_border) * share;
        p.y = -std::tan(glm::radians(here / 2)) * std::abs(p.x) + 0.08F * p.x * z -
              0.02F * (p.x * p.x + z * z);
    }
    return mesh;
}

TEST(NoisyCreases, OfCurvedPartsAreFoldsThatFadeAtAllTheirEnds) {
    const Creases fading{curved_fold(38, 8)};
    EXPECT_GE(fading.all, 4U);
    EXPECT_LE(fading.all, 8U);
    EXPECT_EQ(fading.drawn, 0U);
    const Creases sharp{curved_fold(60, 8)};
    EXPECT_GE(sharp.all, 6U);
    EXPECT_EQ(sharp.drawn, sharp.all) << "what is bent by more than 45 degrees is no curve";
    const Creases whole{curved_fold(38, 36)};
    EXPECT_GE(whole.all, 10U);
    EXPECT_EQ(whole.drawn, whole.all) << "it ends at borders";
}

/// A sheet of flat squares, folded along z by 20 degrees, except at `sharp` edges in the middle,
/// where it is folded by 36.
Mesh fold_of_flat_squares(int sharp) {
    Mesh mesh = folded_sheet(12, 0, 0);
    for (glm::vec3& p : mesh.positions) {
        const bool middle = p.z >= 6 && p.z <= 6 + static_cast<float>(sharp);
        p.y = p.x == 0 ? 0 : -std::tan(glm::radians(middle ? 18.0F : 10.0F));
    }
    return mesh;
}

TEST(NoisyCreases, OfFlatFacesAreOneOrTwoEdgesByThemselves) {
    for (const int edges : {1, 2}) {
        const Creases stub{fold_of_flat_squares(edges)};
        EXPECT_EQ(stub.all, static_cast<std::uint32_t>(edges));
        EXPECT_EQ(stub.drawn, 0U);
    }
    const Creases line{fold_of_flat_squares(3)};
    EXPECT_EQ(line.all, 3U);
    EXPECT_EQ(line.drawn, 3U);
}

/// A rough sheet folded by `fold` radians. Three in ten of its triangles are cut into three in one
/// plane. So it has as many flat faces as meshes by marching tetrahedra.
Mesh sheet_in_pieces(float fold) {
    Mesh mesh = folded_sheet(40, 0.2F, fold);
    std::vector<glm::uvec3> triangles;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[i];
        if (i % 10 % 3 != 0 || i % 10 == 9) {
            triangles.push_back(t);
            continue;
        }
        const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back((mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) /
                                 3.0F);
        triangles.insert(triangles.end(),
                         {{t.x, t.y, middle}, {t.y, t.z, middle}, {t.z, t.x, middle}});
    }
    mesh.triangles = triangles;
    return mesh;
}

TEST(NoisyCreases, AreThoseOfARoughSurfaceInPiecesThatAreFlat) {
    const Creases rough{sheet_in_pieces(0)};
    EXPECT_GT(rough.all, 200U);
    EXPECT_EQ(rough.drawn, 0U);
    const Creases folded{sheet_in_pieces(1.2F)};
    EXPECT_GE(folded.drawn, 36U);
    EXPECT_LE(folded.drawn, 44U);
}

TEST(NoisyCreases, DoNotDependOnSizeAndPlace) {
    test::Random random{84};
    const Mesh mesh = folded_sheet(24, 0.25F, 1);
    const Creases expected{mesh};
    for (const float scale : {0x1p-20F, 0x1p20F}) { // exact
        const Creases scaled{test::moved(mesh, glm::scale(glm::mat4{1}, glm::vec3{scale}))};
        EXPECT_EQ(scaled.drawn, expected.drawn) << scale;
    }
    const Creases turned{test::with_random_windings(mesh, random)};
    EXPECT_EQ(turned.drawn, expected.drawn);
}

} // namespace
} // namespace lineatlas
