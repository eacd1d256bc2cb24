// A clevis: a base plate with two lugs and the pin through their eyes. One welded casting, with the
// machined faces as a second material. Castings have draft: their faces are never quite flat.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "builder.hpp"
#include "camera_path.hpp"
#include "scene_list.hpp"

namespace lineatlas::scenes {

namespace {

using Ring = std::vector<std::uint32_t>;

constexpr float pi = std::numbers::pi_v<float>;
constexpr float plate_height = 0.014F;
constexpr float plate_crown = 0.0005F; // the plate rises this much towards the lugs
constexpr float eye_height = 0.066F;
constexpr float eye_radius = 0.024F;
constexpr float bore_radius = 0.0115F;
constexpr float lug_thickness = 0.016F;
constexpr float lug_offset = 0.025F; // of a lug's middle from the middle of the part
constexpr float chamfer = 0.002F;
constexpr float fillet_radius = 0.006F;
constexpr int eye_segments = 12;
constexpr int bore_segments = 13;
constexpr int fillet_steps = 1;

struct Materials {
    Group cast;
    Group machined;
    Group bushing;
    Group steel;
};

/// The outline of a lug from its right foot over the eye to its left foot. A `turned` outline has
/// its arc points half a step on, so that the bands between outlines are made of equal triangles.
Path lug_outline(float inset, float z, bool turned) {
    const float r = eye_radius - inset;
    const float foot = plate_height + plate_crown + fillet_radius;
    Path points{{r, foot, z}};
    for (int i = 0; i <= eye_segments; ++i) {
        const float turn = static_cast<float>(i) - (turned && i > 0 ? 0.5F : 0.0F);
        const float angle = pi * turn / eye_segments;
        points.emplace_back(r * std::cos(angle), eye_height + r * std::sin(angle), z);
    }
    if (turned) points.emplace_back(-r, eye_height, z);
    points.emplace_back(-r, foot, z);
    return points;
}

Path circle_path(float radius, float height, float z, int segments, bool turned) {
    Path points;
    for (const glm::vec2& p :
         circle({0, height}, radius, segments, turned ? pi / static_cast<float>(segments) : 0.0F))
        points.emplace_back(p, z);
    return points;
}

/// A face of a lug: its outline, the raised boss ring and the bushing inside it. The pin fills the
/// bore, which is left out. `side` is +1 for the face towards +z.
void lug_face(MeshBuilder& b, const Materials& m, const Ring& outline, float z, float side) {
    const float boss = bore_radius + 0.0025F;
    const Outline hole = circle({0, eye_height}, boss, bore_segments);
    Outline flat;
    for (const std::uint32_t v : outline) flat.emplace_back(b.position(v));
    Ring all = outline;
    const Ring boss_ring = b.ring(
        glm::mat4(1), circle_path(boss, eye_height, z + side * 0.0013F, bore_segments, false));
    all.insert(all.end(), boss_ring.begin(), boss_ring.end());
    for (const glm::uvec3& t : triangulate(flat, std::span(&hole, 1))) {
        if (side > 0)
            b.triangle(m.cast, all[t.x], all[t.y], all[t.z]);
        else
            b.triangle(m.cast, all[t.x], all[t.z], all[t.y]);
    }
    const Ring mouth = b.ring(glm::mat4(1), circle_path(bore_radius, eye_height, z + side * 0.0009F,
                                                        bore_segments, true));
    if (side > 0)
        b.loft(m.bushing, boss_ring, mouth, true);
    else
        b.loft(m.bushing, mouth, boss_ring, true);
}

/// Points `distance` outside a closed loop in the x-z plane that runs counter-clockwise seen from
/// above, at height `y`.
Path grown(const Path& loop, float distance, float y) {
    const std::size_t n = loop.size();
    Path result;
    auto normal = [](glm::vec3 d) { return glm::normalize(glm::vec3(-d.z, 0, d.x)); };
    for (std::size_t i = 0; i < n; ++i) {
        const glm::vec3 before = normal(loop[i] - loop[(i + n - 1) % n]);
        const glm::vec3 after = normal(loop[(i + 1) % n] - loop[i]);
        const glm::vec3 miter = (before + after) / (1.0F + glm::dot(before, after));
        result.push_back(loop[i] + distance * miter);
        result.back().y = y;
    }
    return result;
}

/// Returns the loop where the fillet meets the plate.
Ring lug(MeshBuilder& b, const Materials& m, float middle) {
    const float half = 0.5F * lug_thickness;
    const glm::mat4 one(1);
    const Ring front = b.ring(one, lug_outline(chamfer, middle + half, false));
    const Ring front_rim = b.ring(one, lug_outline(0, middle + half - chamfer, true));
    const Ring back_rim = b.ring(one, lug_outline(0, middle - half + chamfer, false));
    const Ring back = b.ring(one, lug_outline(chamfer, middle - half, true));
    b.loft(m.cast, back, back_rim, false);
    b.loft(m.cast, back_rim, front_rim, false);
    b.loft(m.cast, front_rim, front, false);

    lug_face(b, m, front, middle + half, 1);
    lug_face(b, m, back, middle - half, -1);

    const Ring foot{front.front(), front_rim.front(), back_rim.front(), back.front(),
                    back.back(),   back_rim.back(),   front_rim.back(), front.back()};
    Path loop;
    for (const std::uint32_t v : foot) loop.push_back(b.position(v));
    Ring above = foot;
    for (int i = 1; i <= fillet_steps; ++i) {
        const float angle = 0.5F * pi * static_cast<float>(i) / fillet_steps;
        const float y = plate_height + plate_crown + fillet_radius * (1 - std::sin(angle));
        const Ring below = b.ring(one, grown(loop, fillet_radius * (1 - std::cos(angle)), y));
        b.loft(m.cast, below, above, true);
        above = below;
    }
    return above;
}

void plate(MeshBuilder& b, const Materials& m, std::span<const Ring> feet) {
    const glm::vec2 half{0.066F, 0.052F};
    auto outline_ring = [&](float inset, float y) {
        Path points;
        const glm::vec2 corner = half - inset;
        for (const glm::vec2& p : rounded_rectangle(-corner, corner, 0.014F - inset, 4))
            points.emplace_back(p.x, y, -p.y);
        return b.ring(glm::mat4(1), points);
    };
    auto hole_ring = [&](glm::vec2 centre, float y) {
        Path points;
        for (const glm::vec2& p : circle(centre, 0.0068F, 16)) points.emplace_back(p.x, y, -p.y);
        return b.ring(glm::mat4(1), points);
    };
    const Ring bottom = outline_ring(0, 0);
    const Ring rim = outline_ring(0, plate_height - chamfer);
    const Ring top = outline_ring(chamfer, plate_height);
    b.loft(m.cast, bottom, rim, true);
    b.loft(m.cast, rim, top, true);

    Ring all = top;
    std::vector<Outline> holes;
    auto add_hole = [&](const Ring& ring) {
        Outline hole;
        for (const std::uint32_t v : ring) hole.emplace_back(b.position(v).x, -b.position(v).z);
        holes.push_back(hole);
        all.insert(all.end(), ring.begin(), ring.end());
    };
    for (const Ring& foot : feet) add_hole(foot);
    for (const float x : {-1.0F, 1.0F}) {
        for (const float y : {-1.0F, 1.0F}) {
            const glm::vec2 centre{x * 0.050F, y * 0.034F};
            const Ring mouth = hole_ring(centre, plate_height + 0.3F * plate_crown);
            b.loft(m.machined, mouth, hole_ring(centre, 0), true);
            add_hole(mouth);
        }
    }
    Outline flat;
    for (const std::uint32_t v : top) flat.emplace_back(b.position(v).x, -b.position(v).z);
    for (const glm::uvec3& t : triangulate(flat, holes))
        b.triangle(m.cast, all[t.x], all[t.y], all[t.z]);
}

void pin(MeshBuilder& b, const Materials& m) {
    const glm::mat4 axis = along({0, eye_height, 0}, {0, eye_height, 1});
    const float r = bore_radius - 0.0006F;
    // The head shows its whole circle and is the finest; faces that lie against a lug are open.
    const glm::vec2 body[] = {{0, -0.0502F}, {r - 0.002F, -0.0498F}, {r, -0.0478F}, {r, 0.0352F}};
    b.lathe(axis, m.steel, body, bore_segments, true);
    const glm::vec2 head[] = {
        {0.0180F, 0.0356F}, {0.0180F, 0.0425F}, {0.0150F, 0.0455F}, {0, 0.0463F}};
    b.lathe(axis, m.steel, head, 20);
    const glm::vec2 washer[] = {{r + 0.0008F, -0.0382F}, {0.0180F, -0.0381F}, {0.0182F, -0.0353F}};
    b.lathe(axis, m.machined, washer, 18, true);

    // The split pin: a ring above the shaft, two legs bent apart below it.
    const float z = -0.0425F;
    Path eyelet;
    for (const glm::vec2& p : circle({0, eye_height + r + 0.0045F}, 0.0035F, 6))
        eyelet.emplace_back(p, z);
    b.tube(glm::mat4(1), m.steel, eyelet, 0.0011F, 3, true);
    for (const float side : {-1.0F, 1.0F}) {
        const Path leg{{side * 0.0013F, eye_height - r + 0.002F, z},
                       {side * 0.0013F, eye_height - r - 0.002F, z},
                       {side * 0.0060F, eye_height - r - 0.007F, z}};
        b.tube(glm::mat4(1), m.steel, leg, 0.0011F, 3);
    }
}

} // namespace

Scene make_clevis() {
    MeshBuilder b;
    const Materials m{b.group("body", "cast_iron", {0.70F, 0.73F, 0.76F}),
                      b.group("body", "machined_steel", {0.90F, 0.91F, 0.92F}),
                      b.group("bushing", "bronze", {0.88F, 0.77F, 0.56F}),
                      b.group("pin", "steel", {0.82F, 0.85F, 0.88F})};
    const Ring feet[] = {lug(b, m, lug_offset), lug(b, m, -lug_offset)};
    plate(b, m, feet);
    pin(b, m);

    Scene scene;
    scene.mesh = b.take();
    scene.view = orbit({0, 0.030F, 0}, 0.246F, 0.44F, 0.9F, 0.1F, 0.6F);
    return scene;
}

} // namespace lineatlas::scenes
