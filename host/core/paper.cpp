#include "paper.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace lineatlas {
namespace {

constexpr int size = PaperTile::size;

std::uint32_t hash(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::uint32_t h = a * 0x9E3779B1U ^ b * 0x85EBCA77U ^ c * 0xC2B2AE3DU;
    h = (h ^ h >> 15U) * 0x2C1B3C6DU;
    h = (h ^ h >> 12U) * 0x297A2D39U;
    return h ^ h >> 15U;
}

/// A random number in [0, 1).
float random_unit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return static_cast<float>(hash(a, b, c) >> 8U) * 0x1p-24F;
}

/// Smooth noise in [0, 1) with features of `cell` pixels, which divides the tile's size.
float noise(int x, int y, int cell, std::uint32_t key) {
    const int cells = size / cell;
    const auto at = [&](int column, int row) {
        return random_unit(static_cast<std::uint32_t>(column % cells),
                           static_cast<std::uint32_t>(row % cells), key);
    };
    const auto smooth = [&](int place) {
        const float t = (static_cast<float>(place % cell) + 0.5F) / static_cast<float>(cell);
        return t * t * (3 - 2 * t);
    };
    const auto mix = [](float a, float b, float t) { return a + (b - a) * t; };
    const int column = x / cell;
    const int row = y / cell;
    const float tx = smooth(x);
    return mix(mix(at(column, row), at(column + 1, row), tx),
               mix(at(column, row + 1), at(column + 1, row + 1), tx), smooth(y));
}

/// Short bent fibres: how much each pixel is covered by one, 0 to 1.
std::vector<float> fibres() {
    constexpr std::uint32_t count = 1100;
    std::vector<float> cover(std::size_t{size} * size, 0.0F);
    const auto touch = [&](glm::vec2 p, float strength) {
        const glm::vec2 corner = glm::floor(p - 1.0F);
        for (int dy = 0; dy < 4; ++dy) {
            for (int dx = 0; dx < 4; ++dx) {
                const glm::vec2 texel = corner + glm::vec2{dx, dy};
                const float nearness = 1 - glm::distance(texel + 0.5F, p) / 1.1F;
                if (nearness <= 0) continue;
                const int x = static_cast<int>(texel.x) & (size - 1);
                const int y = static_cast<int>(texel.y) & (size - 1);
                float& value = cover[static_cast<std::size_t>(y) * size + x];
                value = std::max(value, strength * nearness);
            }
        }
    };
    for (std::uint32_t i = 0; i < count; ++i) {
        glm::vec2 p =
            static_cast<float>(size) * glm::vec2{random_unit(i, 0, 1), random_unit(i, 0, 2)};
        glm::vec2 direction{random_unit(i, 0, 3) - 0.5F, random_unit(i, 0, 4) - 0.5F};
        direction /= std::max(glm::length(direction), 1e-3F);
        const float bend = 0.06F * (random_unit(i, 0, 5) - 0.5F);
        const float strength = 0.4F + 0.6F * random_unit(i, 0, 6);
        const auto steps = 24 + hash(i, 0, 7) % 64;
        for (std::uint32_t step = 0; step < steps; ++step) {
            const float along = static_cast<float>(step) / static_cast<float>(steps);
            touch(p, strength * 4 * along * (1 - along)); // fading at both ends
            p += 0.6F * direction;
            direction += bend * glm::vec2{-direction.y, direction.x};
            direction = glm::normalize(direction);
        }
    }
    return cover;
}

} // namespace

PaperTile make_paper() {
    const std::vector<float> fibre = fibres();
    PaperTile tile;
    tile.depth.reserve(fibre.size());
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const float tooth = 0.4F * noise(x, y, 2, 1) + 0.25F * noise(x, y, 4, 2) +
                                0.35F * random_unit(static_cast<std::uint32_t>(x),
                                                    static_cast<std::uint32_t>(y), 3);
            const float pulp = 0.6F * noise(x, y, 16, 4) + 0.4F * noise(x, y, 64, 5);
            const float deep = std::max(0.0F, tooth - 0.35F);
            const float depth = 0.42F * deep + 0.08F * pulp * tooth +
                                0.12F * fibre[static_cast<std::size_t>(y) * size + x];
            tile.depth.push_back(
                static_cast<std::uint8_t>(std::lround(255 * std::clamp(depth, 0.0F, 1.0F))));
        }
    }
    return tile;
}

} // namespace lineatlas
