// The hull of the ship: its form, lapped planking, ribs and ceiling.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ship_parts.hpp"

namespace lineatlas::scenes {

namespace hull {

namespace {

float keel(float x) {
    return -5.2F + 0.0009F * x * x * (x < 0 ? 0.4F : 0.7F);
}

} // namespace

float sheer(float x) {
    const float s = (x + 4) / 30;
    return 3.3F + (s > 0 ? 1.5F * s * s : 1.1F * s * s);
}

glm::vec3 surface(float u, float h) {
    // The stem rakes forward with height, the sternpost and counter aft.
    const float x_bow = bow - 5.5F * std::pow(1 - h, 2.2F);
    const float x_stern = stern + 3.2F * std::pow(1 - h, 1.5F);
    const float x = glm::mix(x_stern, x_bow, u);
    const float y = glm::mix(keel(x), sheer(x), h);
    const float forward = std::max(0.0F, (u - 0.52F) / 0.48F);
    const float aft = std::max(0.0F, (0.52F - u) / 0.52F);
    const float transom = 0.62F * glm::smoothstep(0.45F, 0.95F, h);
    const float plan = (1 - std::pow(forward, glm::mix(2.0F, 3.4F, h))) *
                       (1 - std::pow(aft, glm::mix(1.9F, 3.0F, h)) * (1 - transom));
    // Full amidships, sharp at the ends; a little tumblehome.
    const float ends = std::max(forward, aft);
    const float round = glm::mix(4.2F, 1.6F, ends * ends);
    const float power = glm::mix(0.48F, 0.95F, ends * ends);
    const float section =
        std::pow(1 - std::pow(1 - h, round), power) * (1 - 0.07F * (1 - ends) * h * h * h);
    return {x, y, 0.16F + 5.4F * plan * section};
}

float half_breadth(float x, float y) {
    // The surface is given by (u, h); a few steps of substitution find them for (x, y).
    const float h = std::clamp((y - keel(x)) / (sheer(x) - keel(x)), 0.0F, 1.0F);
    const float x_bow = bow - 5.5F * std::pow(1 - h, 2.2F);
    const float x_stern = stern + 3.2F * std::pow(1 - h, 1.5F);
    const float u = (x - x_stern) / (x_bow - x_stern);
    return u <= 0 || u >= 1 ? 0.0F : surface(u, h).z;
}

bool in_hatch(float x, float z, float margin) {
    for (const Hatch& hatch : hatches)
        if (x > hatch.x0 - margin && x < hatch.x1 + margin &&
            std::abs(z) < hatch.half_width + margin)
            return true;
    return false;
}

} // namespace hull

namespace {

/// Strakes are evenly wide along the girth amidships.
float girth_to_height(float v) {
    const float flat = 1 - std::cos(0.5F * std::numbers::pi_v<float> * v);
    return glm::mix(v, flat, 0.45F);
}

glm::vec3 inset_point(float u, float v, float inset) {
    const float h = girth_to_height(v);
    const glm::vec3 p = hull::surface(u, h);
    const glm::vec3 du =
        hull::surface(std::min(u + 0.004F, 1.0F), h) - hull::surface(std::max(u - 0.004F, 0.0F), h);
    const glm::vec3 dh =
        hull::surface(u, std::min(h + 0.01F, 1.0F)) - hull::surface(u, std::max(h - 0.01F, 0.0F));
    const glm::vec3 normal = glm::normalize(glm::cross(du, dh) + glm::vec3(0, 0, 1e-6F));
    glm::vec3 result = p - inset * normal;
    result.z = std::max(result.z, 0.02F);
    return result;
}

glm::vec3 mirrored(glm::vec3 p, bool port) {
    return {p.x, p.y, port ? -p.z : p.z};
}

struct Planking {
    int strakes;
    int stations; ///< segments over the whole length
    int butts;    ///< planks in a strake
    float inset;  ///< of the plank's upper edge inside the hull surface
    float lap;    ///< how far the lower edge stands off, over the strake below
};

/// Lapped planks: each covers the top of the one below, so no daylight shows between them.
void add_planking(MeshBuilder& b, Group upper_group, Group lower_group, const Planking& planking) {
    const auto width = 1.0F / static_cast<float>(planking.strakes);
    for (int strake = 0; strake < planking.strakes; ++strake) {
        const float v0 = std::max(0.0F, (static_cast<float>(strake) - 0.12F) * width);
        const float v1 = static_cast<float>(strake + 1) * width;
        const Group g = static_cast<float>(strake) * width > 0.56F ? upper_group : lower_group;
        Path lower;
        Path upper;
        for (int i = 0; i <= planking.stations; ++i) {
            const float u = static_cast<float>(i) / static_cast<float>(planking.stations);
            lower.push_back(inset_point(u, v0, planking.inset - planking.lap));
            upper.push_back(inset_point(u, v1, planking.inset));
        }
        // Butts are staggered from strake to strake; a plank ends 4 mm short of the next one.
        const int length = planking.stations / planking.butts;
        int from = 0;
        int to = std::max(3, length * (1 + strake % 3) / 3);
        while (from < planking.stations) {
            to = std::min(to, planking.stations);
            if (planking.stations - to < 3) to = planking.stations;
            for (const bool port : {false, true}) {
                Path a;
                Path c;
                for (int i = from; i <= to; ++i) {
                    a.push_back(mirrored(lower[static_cast<std::size_t>(i)], port));
                    c.push_back(mirrored(upper[static_cast<std::size_t>(i)], port));
                }
                if (from > 0) {
                    a.front() += 0.004F * glm::normalize(a[1] - a[0]);
                    c.front() += 0.004F * glm::normalize(c[1] - c[0]);
                }
                if (port)
                    b.strip(glm::mat4(1), g, c, a);
                else
                    b.strip(glm::mat4(1), g, a, c);
            }
            from = to;
            to += length;
        }
    }
}

/// Ribs of three planks' width: a face to the inside and two sides.
void add_ribs(MeshBuilder& b, Group g, int count, int segments) {
    for (int i = 0; i < count; ++i) {
        const float u = 0.02F + 0.96F * (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
        const float half = 0.11F / (hull::bow - hull::stern);
        for (const bool port : {false, true}) {
            std::vector<std::uint32_t> edges[4];
            for (int k = 0; k <= segments; ++k) {
                const float v =
                    0.02F + 0.965F * static_cast<float>(k) / static_cast<float>(segments);
                const glm::vec3 corners[4] = {
                    inset_point(u - half, v, 0.03F), inset_point(u - half, v, 0.25F),
                    inset_point(u + half, v, 0.25F), inset_point(u + half, v, 0.03F)};
                for (int e = 0; e < 4; ++e)
                    edges[e].push_back(b.vertex(mirrored(corners[e], port)));
            }
            for (int e = 0; e < 3; ++e)
                for (std::size_t k = 0; k + 1 < edges[e].size(); ++k) {
                    const std::uint32_t q[4] = {edges[e][k], edges[e][k + 1], edges[e + 1][k + 1],
                                                edges[e + 1][k]};
                    if (port)
                        b.quad(g, q[3], q[2], q[1], q[0]);
                    else
                        b.quad(g, q[0], q[1], q[2], q[3]);
                }
        }
    }
}

/// The flat of the stern, planked across.
void add_transom(MeshBuilder& b, const ShipMaterials& m) {
    constexpr int rows = 26;
    for (int i = 0; i < rows; ++i) {
        const float v0 = (static_cast<float>(i) - 0.1F * (i > 0 ? 1.0F : 0.0F)) / rows;
        const float v1 = static_cast<float>(i + 1) / rows;
        Path lower;
        Path upper;
        for (int k = 0; k <= 6; ++k) {
            const float side = static_cast<float>(k) / 3 - 1;
            const float bulge = 0.10F * (1 - side * side);
            const glm::vec3 a = inset_point(0, v0, 0);
            const glm::vec3 c = inset_point(0, v1, 0);
            lower.emplace_back(a.x - bulge - 0.02F, a.y, a.z * side);
            upper.emplace_back(c.x - bulge, c.y, c.z * side);
        }
        b.strip(glm::mat4(1), v0 > 0.5F ? m.planking : m.bottom, lower, upper);
    }
}

/// Rails that follow the sheer: swept boxes.
void add_rail(MeshBuilder& b, Group g, float v, float rise, float in, float out, float height) {
    for (const bool port : {false, true}) {
        std::vector<std::uint32_t> edges[4];
        for (int i = 0; i <= 58; ++i) {
            const float u = 0.002F + 0.994F * static_cast<float>(i) / 58;
            const glm::vec3 p = hull::surface(u, v) + glm::vec3(0, rise, 0);
            const float inner = std::max(0.03F, p.z - in);
            const glm::vec3 corners[4] = {{p.x, p.y, p.z + out},
                                          {p.x, p.y + height, p.z + out},
                                          {p.x, p.y + height, inner},
                                          {p.x, p.y, inner}};
            for (int e = 0; e < 4; ++e) edges[e].push_back(b.vertex(mirrored(corners[e], port)));
        }
        for (int e = 0; e < 4; ++e)
            for (std::size_t k = 0; k + 1 < edges[e].size(); ++k) {
                const auto& f = edges[(e + 1) % 4];
                const std::uint32_t q[4] = {edges[e][k], edges[e][k + 1], f[k + 1], f[k]};
                if (port)
                    b.quad(g, q[3], q[2], q[1], q[0]);
                else
                    b.quad(g, q[0], q[1], q[2], q[3]);
            }
    }
}

} // namespace

void add_hull(MeshBuilder& b, const ShipMaterials& m) {
    add_planking(b, m.planking, m.bottom, {52, 264, 9, 0, 0.022F});
    add_planking(b, m.ceiling, m.ceiling, {38, 180, 9, 0.30F, 0.016F});
    add_ribs(b, m.frames, 100, 17);
    add_transom(b, m);
    add_rail(b, m.joinery, 1, 0.01F, 0.22F, 0.08F, 0.09F);
    add_rail(b, m.planking, 0.80F, 0, -0.03F, 0.11F, 0.12F);
    add_rail(b, m.planking, 0.70F, 0, -0.03F, 0.09F, 0.10F);

    // Keel, stem and sternpost.
    const float keel_y = hull::surface(0.5F, 0).y;
    b.box(glm::mat4(1), m.frames, {-25.6F, keel_y - 0.42F, -0.155F},
          {23.2F, keel_y + 0.05F, 0.155F});
    for (int i = 0; i < 14; ++i) {
        const float h0 = static_cast<float>(i) / 14;
        const float h1 = static_cast<float>(i + 1) / 14;
        const glm::vec3 a = hull::surface(1, h0);
        const glm::vec3 c = hull::surface(1, h1);
        const glm::mat4 at = along({a.x + 0.06F, a.y, 0}, {c.x + 0.06F, c.y, 0});
        const float half = 0.5F * glm::distance(a, c);
        b.box(at, m.frames, {-0.17F, 0.002F, -0.24F}, {0.17F, 2 * half - 0.002F, 0.24F});
    }
    // The rudder, with its iron straps.
    const glm::vec3 foot = hull::surface(0, 0.02F);
    const glm::vec3 head = hull::surface(0, 0.62F);
    const glm::mat4 rudder = along({foot.x - 0.42F, foot.y - 0.3F, 0}, {head.x - 0.42F, head.y, 0});
    b.prism(rudder, m.bottom,
            {{-0.30F, 0},
             {0.30F, 0},
             {0.30F, 6.0F},
             {-0.02F, 6.0F},
             {-0.26F, 3.0F},
             {-0.95F, 1.6F},
             {-0.95F, 0.3F}},
            -0.13F, 0.13F);
}

} // namespace lineatlas::scenes
