// The sails of the ship: sewn cloths, set or furled; and the ropes they hang on.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

#include "ship_parts.hpp"

namespace lineatlas::scenes {

void lay(MeshBuilder& b, const ShipMaterials& m, glm::vec3 from, glm::vec3 to, float radius,
         int lengths, float sag) {
    b.rope(m.rope, from, to, radius, std::max(2, lengths * 2 / 5), sag);
}

/// A square sail of sewn cloths, bellied forward, with reef points.
void add_square_sail(MeshBuilder& b, const ShipMaterials& m, glm::vec3 head, float head_half,
                     float foot_y, float foot_half, float belly, int rows) {
    const int cloths = static_cast<int>(2 * foot_half / 0.62F);
    auto point = [&](float s, float t) { // s across in [-1, 1], t down in [0, 1]
        const float half = glm::mix(head_half, foot_half, t);
        const float roach = 0.35F * (1 - s * s) * t * t;
        const float depth =
            belly * (1 - 0.85F * s * s) * std::sin(std::numbers::pi_v<float> * (0.08F + 0.80F * t));
        return glm::vec3(head.x + depth, glm::mix(head.y, foot_y, t) + roach, s * half);
    };
    for (int i = 0; i < cloths; ++i) {
        const float s0 = 2 * static_cast<float>(i) / static_cast<float>(cloths) - 1;
        const float s1 = 2 * (static_cast<float>(i) + 1.03F) / static_cast<float>(cloths) - 1;
        Path left;
        Path right;
        for (int k = 0; k <= rows; ++k) {
            const float t = static_cast<float>(k) / static_cast<float>(rows);
            left.push_back(point(s0, t));
            right.push_back(point(std::min(s1, 1.0F), t) + glm::vec3(0.012F, 0, 0));
        }
        b.strip(glm::mat4(1), m.sail, left, right);
    }
    for (const float t : {0.18F, 0.34F}) {
        for (int i = 0; i < 2 * cloths; ++i) {
            const float s = (2 * static_cast<float>(i) + 1) / static_cast<float>(2 * cloths) - 1;
            const glm::vec3 p = point(s, t) + glm::vec3(0.04F, 0, 0);
            lay(b, m, p, p + glm::vec3(0.05F, -0.55F, 0.03F), 0.010F, 3);
        }
    }
}

/// A sail rolled up on its yard: lumps of canvas between the gaskets.
void add_furled_sail(MeshBuilder& b, const ShipMaterials& m, glm::vec3 middle, float half) {
    b.panel(move(middle), m.sail, 90, 12, [half](float u, float v) {
        const float angle = 2 * std::numbers::pi_v<float> * v;
        const float s = 2 * u - 1;
        const float lump =
            0.30F * (1 - 0.5F * s * s) * (0.82F + 0.18F * std::abs(std::sin(u * 40.0F)));
        return glm::vec3(0.9F * lump * std::cos(angle), 0.30F + lump * std::sin(angle),
                         half * 0.92F * s);
    });
}

/// A three-cornered sail on a stay.
void add_staysail(MeshBuilder& b, const ShipMaterials& m, glm::vec3 tack, glm::vec3 head,
                  glm::vec3 clew, int cloths, int rows) {
    for (int i = 0; i < cloths; ++i) {
        auto point = [&](float across, float up) {
            const glm::vec3 luff = glm::mix(tack, head, up);
            const glm::vec3 leech = glm::mix(clew, head, up);
            const glm::vec3 p = glm::mix(luff, leech, across);
            const float belly =
                0.75F * std::sin(std::numbers::pi_v<float> * across) * (1 - up) * (0.25F + up);
            return p + glm::vec3(0, 0, belly);
        };
        Path lower;
        Path upper;
        const float y0 = static_cast<float>(i) / static_cast<float>(cloths);
        const float y1 = (static_cast<float>(i) + 1.02F) / static_cast<float>(cloths);
        for (int k = 0; k <= rows; ++k) {
            const float s = static_cast<float>(k) / static_cast<float>(rows);
            lower.push_back(point(s, y0));
            upper.push_back(point(s, std::min(y1, 0.99F)) + glm::vec3(0, 0, 0.01F));
        }
        b.strip(glm::mat4(1), m.sail, lower, upper);
    }
}

} // namespace lineatlas::scenes
