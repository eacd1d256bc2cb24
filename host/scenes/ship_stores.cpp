// What fills the ship's ends below deck: chain cable forward, coils of rope aft.
#include <cmath>
#include <numbers>

#include "ship_parts.hpp"

namespace lineatlas::scenes {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// A link of chain along x, 0.4 m long.
void add_link(MeshBuilder& b, const ShipMaterials& m, const glm::mat4& at) {
    Path path;
    for (int i = 0; i < 8; ++i) {
        const float angle = 2 * pi * (static_cast<float>(i) + 0.5F) / 8;
        const float x = 0.11F * std::cos(angle);
        path.emplace_back(x + (x > 0 ? 0.06F : -0.06F), 0.0F, -0.11F * std::sin(angle));
    }
    b.tube(at, m.iron, path, 0.030F, 4, true);
}

} // namespace

void add_stores(MeshBuilder& b, const ShipMaterials& m) {
    // Chain in rows to and fro; every other link stands upright in its neighbours.
    for (int layer = 0; layer < 2; ++layer)
        for (int row = -6; row <= 6; ++row)
            for (int i = 0; i < 26; ++i) {
                const glm::vec3 p{14.4F + 0.27F * static_cast<float>(i),
                                  -3.9F + 0.32F * static_cast<float>(layer),
                                  0.34F * static_cast<float>(row)};
                if (hull::half_breadth(p.x, p.y - 0.2F) - 0.60F < std::abs(p.z)) continue;
                add_link(b, m, move(p) * turn(i % 2 == 0 ? 0.0F : 0.5F * pi, {1, 0, 0}));
            }
    // Dunnage: loose boards across the floor of the hold and over the first tier of cargo.
    for (int i = 0; i < 960; ++i) {
        const float x = -18.0F + 0.07F * static_cast<float>(i % 480);
        const float y = i < 480 ? -4.3F : -3.30F;
        const float half = hull::half_breadth(x, y) - 0.75F;
        for (int k = -2; k < 2 && half > 0.6F; ++k) {
            const float z = 0.5F * half * static_cast<float>(k);
            b.open_quad(glm::mat4(1), m.ceiling, {x, y, z}, {x, y, z + 0.5F * half - 0.01F},
                        {x + 0.065F, y, z + 0.5F * half - 0.01F}, {x + 0.065F, y, z});
        }
    }
    for (int layer = 0; layer < 2; ++layer)
        for (int row = -2; row <= 2; ++row)
            for (int i = 0; i < 7; ++i) {
                const glm::vec3 p{-21.0F + 1.12F * static_cast<float>(i),
                                  -3.6F + 0.75F * static_cast<float>(layer),
                                  1.12F * static_cast<float>(row)};
                if (hull::half_breadth(p.x, p.y) - 0.95F < std::abs(p.z)) continue;
                for (const float radius : {0.50F, 0.36F})
                    add_coil(b, m, move(p), radius, 6 + (row + i + 2) % 3, 8);
            }
}

} // namespace lineatlas::scenes
