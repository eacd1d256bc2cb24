// The hull of the ship: its form, lapped planking, ribs and ceiling.
#include <algorithm>
#include <cmath>
#include <functional>
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
    // Where the two sides meet, layers keep apart by how deep they lie.
    result.z = std::max(result.z, 0.16F - 0.3F * inset);
    return result;
}

glm::vec3 mirrored(glm::vec3 p, bool port) {
    return {p.x, p.y, port ? -p.z : p.z};
}

struct Planking {
    int strakes;
    int stations;     ///< segments over the whole length
    int rows;         ///< segments over the width of a strake
    int butts;        ///< planks in a strake
    int hidden_butts; ///< the same below the main deck
    float inset;      ///< of the plank's upper edge inside the hull surface
    float lap;     ///< how far the lower edge stands out (inwards if negative) over the one below
    float overlap; ///< of the widths of two strakes
};

/// Lapped planks: each covers the top of the one below, so no daylight shows between them.
void add_planking(MeshBuilder& b, const std::function<Group(float)>& group_of,
                  const Planking& planking) {
    const auto width = 1.0F / static_cast<float>(planking.strakes);
    for (int strake = 0; strake < planking.strakes; ++strake) {
        const float v0 = std::max(0.0F, (static_cast<float>(strake) - planking.overlap) * width);
        const float v1 = static_cast<float>(strake + 1) * width;
        auto group_of_row = [&](int row) {
            return group_of(glm::mix(
                v0, v1, (static_cast<float>(row) + 0.5F) / static_cast<float>(planking.rows)));
        };
        // Butts are staggered from strake to strake; a plank ends 4 mm short of the next one.
        const int butts = v1 < 0.82F ? planking.hidden_butts : planking.butts;
        const int length = planking.stations / butts;
        int from = 0;
        int to = butts == 1 ? length : std::max(3, length * (1 + strake % 3) / 3);
        while (from < planking.stations) {
            to = std::min(to, planking.stations);
            if (planking.stations - to < 3) to = planking.stations;
            for (const bool port : {false, true}) {
                auto surface = [&](float along, float up) {
                    const float s = port ? 1 - along : along;
                    const float u = glm::mix(static_cast<float>(from), static_cast<float>(to), s) /
                                    static_cast<float>(planking.stations);
                    const float butt = from > 0 && s == 0 ? 0.00007F : 0.0F;
                    return mirrored(inset_point(u + butt, glm::mix(v0, v1, up),
                                                planking.inset - planking.lap * (1 - up)),
                                    port);
                };
                b.patch(glm::mat4(1), to - from, planking.rows, surface, group_of_row);
            }
            from = to;
            to += length;
        }
    }
}

/// Ribs: a face to the inside and two sides. They stay clear of the planking, whose hidden-line
/// test could not tell them apart from far away.
void add_ribs(MeshBuilder& b, Group g, int count, int segments) {
    for (int i = 0; i < count; ++i) {
        const float u = 0.02F + 0.85F * (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
        const float half = 0.11F / (hull::bow - hull::stern);
        for (const bool port : {false, true}) {
            std::vector<std::uint32_t> edges[4];
            for (int k = 0; k <= segments; ++k) {
                const float v =
                    0.02F + 0.965F * static_cast<float>(k) / static_cast<float>(segments);
                const glm::vec3 corners[4] = {
                    inset_point(u - half, v, 0.26F), inset_point(u - half, v, 0.35F),
                    inset_point(u + half, v, 0.35F), inset_point(u + half, v, 0.26F)};
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

/// The flat of the stern, planked across, with the windows of the great cabin.
void add_transom(MeshBuilder& b, const ShipMaterials& m) {
    auto at = [](float v, float side, float out) {
        const glm::vec3 edge = inset_point(0, v, 0);
        return glm::vec3(edge.x - 0.10F * (1 - side * side) - out, edge.y, edge.z * side);
    };
    constexpr int boards = 9;
    for (int i = 0; i < boards; ++i) {
        const float v0 = std::max(0.0F, (static_cast<float>(i) - 0.1F) / boards);
        const float v1 = static_cast<float>(i + 1) / boards;
        b.panel(glm::mat4(1), v0 > 0.6F ? m.planking : m.bottom, 8, 5, [&](float u, float v) {
            return at(glm::mix(v0, v1, v), 2 * u - 1, 0.03F * (1 - v));
        });
    }
    for (int i = -2; i <= 2; ++i) {
        const float side = 0.30F * static_cast<float>(i);
        const glm::mat4 window = along(at(0.74F, side, 0.035F), at(0.80F, side, 0.035F));
        for (const float x : {-0.30F, 0.26F})
            b.box(window, m.joinery, {-0.04F, 0, x}, {0.04F, 0.75F, x + 0.04F});
        for (const float y : {0.0F, 0.35F, 0.71F})
            b.box(window, m.joinery, {-0.04F, y, -0.256F}, {0.04F, y + 0.04F, 0.256F});
    }
}

/// Rails that follow the sheer: swept boxes.
void add_rail(MeshBuilder& b, Group g, float v, float rise, float in, float out, float height) {
    for (const bool port : {false, true}) {
        std::vector<std::uint32_t> edges[4];
        for (int i = 0; i <= 58; ++i) {
            const float u = 0.002F + 0.997F * static_cast<float>(i) / 58;
            const glm::vec3 p = hull::surface(u, v) + glm::vec3(0, rise, 0);
            const float inner = std::max(0.03F, p.z - in);
            const float outer = std::max(inner + 0.02F, p.z + out);
            const glm::vec3 corners[4] = {{p.x, p.y, outer},
                                          {p.x, p.y + height, outer},
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
    // Few and wide strakes outside, where every edge shows; the inside can take many narrow ones.
    add_planking(
        b,
        [&](float v) {
            return v < 0.675F ? m.bottom : v > 0.945F && v < 0.978F ? m.stripe : m.planking;
        },
        {13, 116, 4, 1, 1, 0, 0.04F, 0.02F});
    add_planking(b, [&](float) { return m.ceiling; }, {50, 210, 1, 10, 52, 0.42F, -0.03F, 0.02F});
    add_ribs(b, m.frames, 116, 20);
    add_transom(b, m);
    add_rail(b, m.joinery, 1, 0.01F, 0.46F, 0.08F, 0.09F);
    add_rail(b, m.planking, 0.80F, 0, -0.05F, 0.13F, 0.14F);
    add_rail(b, m.planking, 0.70F, 0, -0.05F, 0.11F, 0.12F);
    for (const float v : {0.22F, 0.42F, 0.58F}) add_rail(b, m.frames, v, 0, 0.56F, -0.47F, 0.16F);

    // Keel and stem, each from one piece, a centimetre inside the planks that end on them.
    const float keel_y = hull::surface(0.5F, 0).y;
    constexpr int pieces = 14;
    Outline keel{{-25.7F, keel_y - 0.42F}, {23.4F, keel_y - 0.42F}};
    Outline stem;
    for (int i = 0; i <= pieces; ++i) {
        const glm::vec3 p = hull::surface(1 - static_cast<float>(i) / pieces, 0);
        keel.emplace_back(std::clamp(p.x, -25.69F, 23.39F), p.y + 0.06F);
        stem.emplace_back(hull::surface(1, static_cast<float>(i) / pieces) +
                          glm::vec3(0.36F, 0.02F, 0));
    }
    stem.front().y = keel_y - 0.42F;
    for (int i = pieces; i >= 0; --i) {
        const glm::vec3 p = hull::surface(1, static_cast<float>(i) / pieces);
        stem.emplace_back(std::max(23.41F, p.x - 0.25F), p.y + (i == 0 ? 0.06F : 0.0F));
    }
    stem.emplace_back(23.41F, keel_y - 0.42F);
    b.prism(glm::mat4(1), m.frames, keel, -0.145F, 0.145F);
    b.prism(glm::mat4(1), m.frames, stem, -0.148F, 0.148F);
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
    for (const float y : {0.8F, 2.6F, 4.4F})
        for (const float side : {-1.0F, 1.0F})
            b.box(rudder, m.iron, {-0.24F, y, side * 0.145F - 0.011F},
                  {0.34F, y + 0.14F, side * 0.145F + 0.011F});
}

} // namespace lineatlas::scenes
