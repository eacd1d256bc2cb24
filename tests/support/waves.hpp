#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "lineatlas/mesh.hpp"
#include "test_meshes.hpp"

// An undesigned surface with known ridges and valleys.
namespace lineatlas::test {

constexpr float wave = 2 * std::numbers::pi_v<float>; ///< from crest to crest of y = height cos(x)

/// The mesh of the waves: squares with sides of `edge`. Their corners are shifted by up to a
/// quarter of `edge` within the surface and by `noise` edges off it.
struct Waves {
    float edge = 0.3F;
    float noise = 0;
    float height = 2.5F;
    float crests = 3;
    float length = 12; ///< along them, in z

    Mesh mesh() const {
        Random random{5};
        const auto columns = static_cast<std::uint32_t>(crests * wave / edge);
        const auto rows = static_cast<std::uint32_t>(length / edge);
        Mesh result;
        for (std::uint32_t row = 0; row <= rows; ++row) {
            for (std::uint32_t column = 0; column <= columns; ++column) {
                const float x =
                    edge * (static_cast<float>(column) + random.between(-0.25F, 0.25F)) - wave / 2;
                const float z = edge * (static_cast<float>(row) + random.between(-0.25F, 0.25F));
                result.positions.emplace_back(
                    x, height * std::cos(x) + edge * noise * random.between(-1, 1), z);
            }
        }
        for (std::uint32_t row = 0; row < rows; ++row) {
            for (std::uint32_t column = 0; column < columns; ++column) {
                const std::uint32_t i = row * (columns + 1) + column, up = i + columns + 1;
                result.triangles.push_back({i, up, i + 1});
                result.triangles.push_back({i + 1, up, up + 1});
            }
        }
        return result;
    }
};

} // namespace lineatlas::test
