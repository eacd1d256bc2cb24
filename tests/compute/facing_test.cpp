// facing: compared with the sign of a volume in whole numbers. Floats hold numbers of this size
// exactly.

#include <array>
#include <cmath>
#include <random>

#include <glm/fwd.hpp>
#include <glm/geometric.hpp>

#include "stage_test.hpp"

namespace lineatlas::test {
namespace {

LINEATLAS_STAGE_TEST(FacingStage);

struct Triangles {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> corners;
};

/// The sine of the angle between a triangle and the line of sight; 0 if the triangle has no area.
double sine_of(const std::array<glm::i64vec3, 3>& t, const glm::i64vec4& eye) {
    const glm::dvec3 a{t[0]};
    const glm::dvec3 normal = glm::cross(glm::dvec3{t[1]} - a, glm::dvec3{t[2]} - a);
    const glm::dvec3 to_eye = glm::dvec3{eye} - a * static_cast<double>(eye.w);
    const double size = glm::length(normal) * glm::length(to_eye);
    return size > 0 ? std::abs(glm::dot(normal, to_eye)) / size : 0;
}

/// Six times the volume between a triangle and the eye, positive where it is counter-clockwise.
std::int64_t volume(const std::array<glm::i64vec3, 3>& t, const glm::i64vec4& eye) {
    // The determinant of three corners and the eye in homogeneous coordinates, by its last row.
    const auto det = [](const glm::i64vec3& a, const glm::i64vec3& b, const glm::i64vec3& c) {
        return a.x * (b.y * c.z - c.y * b.z) - b.x * (a.y * c.z - c.y * a.z) +
               c.x * (a.y * b.z - b.y * a.z);
    };
    const glm::i64vec3 e{eye.x, eye.y, eye.z};
    return det(t[1], t[2], e) - det(t[0], t[2], e) + det(t[0], t[1], e) -
           eye.w * det(t[0], t[1], t[2]);
}

TEST_P(FacingStage, IsTheSideOfTheEye) {
    std::minstd_rand random{5};
    const auto whole = [&] { return static_cast<std::int64_t>(random() % 21) - 10; };
    Triangles model;
    std::vector<std::array<glm::i64vec3, 3>> exact;
    for (std::uint32_t i = 0; i < 500; ++i) {
        auto& triangle = exact.emplace_back();
        for (glm::i64vec3& corner : triangle) {
            corner = {whole(), whole(), whole()};
            model.vertices.emplace_back(corner);
        }
        model.corners.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    const auto vertices = put(model.vertices);
    const auto triangles = put(model.corners);
    const auto front = device().allocate(exact.size());
    const auto count = static_cast<std::uint32_t>(exact.size());
    // Eyes at points, and directions to a parallel viewer. In the last view some triangles are edge
    // on.
    for (const glm::i64vec4 eye :
         {glm::i64vec4{7, -3, 12, 1}, {-2, 1, 0, 1}, {3, 5, -2, 0}, {0, 0, 1, 0}}) {
        std::vector<std::uint8_t> expected;
        for (const auto& triangle : exact) {
            const bool edge_on = sine_of(triangle, eye) < 1e-5;
            expected.push_back(volume(triangle, eye) > 0 && !edge_on ? 1 : 0);
        }
        stages().facing({*vertices, *triangles, *triangles, count, 0}, glm::vec4{eye}, *front);
        EXPECT_TRUE(equal(get<std::uint8_t>(*front, count), expected));
    }
}

TEST_P(FacingStage, CounterClockwiseIsFrontAndEdgeOnIsBack) {
    const auto vertices = put(std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}});
    const auto triangles = put(std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {0, 1, 3}});
    const auto front = device().allocate(4);
    const auto seen_from = [&](glm::vec4 eye) {
        stages().facing({*vertices, *triangles, *triangles, 4, 0}, eye, *front);
        return get<std::uint8_t>(*front, 4);
    };
    EXPECT_TRUE(equal(seen_from({0.2F, 0.2F, 9, 1}), {1, 0, 1, 0}));
    EXPECT_TRUE(equal(seen_from({0.2F, 0.2F, -9, 1}), {0, 1, 0, 0}));
    EXPECT_TRUE(equal(seen_from({0, 0, 1, 0}), {1, 0, 1, 0}));
    EXPECT_TRUE(equal(seen_from({4, -7, 0, 1}), {0, 0, 0, 0})) << "edge on";
    EXPECT_TRUE(equal(seen_from({4, -7, 5e-5F, 1}), {0, 0, 0, 0})) << "nearly";
    EXPECT_TRUE(equal(seen_from({4, -7, 2e-4F, 1}), {1, 0, 1, 0})) << "but just";
}

TEST_P(FacingStage, OfTheSmallestTrianglesTheSignSaysIt) {
    const auto vertices = put(std::vector<glm::vec3>{{0, 0, 0}, {1e-15F, 0, 0}, {0, 1e-15F, 0}});
    const auto triangles = put(std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 1}});
    const auto front = device().allocate(2);
    stages().facing({*vertices, *triangles, *triangles, 2, 0}, {0, 0, 1, 0}, *front);
    EXPECT_TRUE(equal(get<std::uint8_t>(*front, 2), {1, 0}));
}

} // namespace
} // namespace lineatlas::test
