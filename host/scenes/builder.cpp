#include "builder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

namespace lineatlas::scenes {

namespace {

constexpr float two_pi = 2 * std::numbers::pi_v<float>;

glm::vec3 apply(const glm::mat4& at, glm::vec3 p) {
    return glm::vec3(at * glm::vec4(p, 1));
}

float ratio(int i, int n) {
    return static_cast<float>(i) / static_cast<float>(n);
}

} // namespace

glm::mat4 move(glm::vec3 by) {
    return glm::translate(glm::mat4(1), by);
}

glm::mat4 turn(float radians, glm::vec3 axis) {
    return glm::rotate(glm::mat4(1), radians, axis);
}

glm::mat4 lay_flat() {
    return {{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}};
}

glm::mat4 along(glm::vec3 from, glm::vec3 to) {
    const glm::vec3 y = glm::normalize(to - from);
    const glm::vec3 helper = std::abs(y.x) < 0.9F ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
    const glm::vec3 z = glm::normalize(glm::cross(helper, y));
    const glm::vec3 x = glm::cross(y, z);
    return {glm::vec4(x, 0), glm::vec4(y, 0), glm::vec4(z, 0), glm::vec4(from, 1)};
}

float hash01(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::uint32_t h = a * 0x9E3779B1U ^ b * 0x85EBCA77U ^ c * 0xC2B2AE3DU;
    h = (h ^ (h >> 16)) * 0x7FEB352DU;
    h = (h ^ (h >> 15)) * 0x846CA68BU;
    h ^= h >> 16;
    return static_cast<float>(h >> 8) * 0x1p-24F;
}

Group MeshBuilder::group(std::string object, std::string material, glm::vec3 color) {
    m_mesh.groups.push_back({std::move(object), std::move(material), color});
    return static_cast<Group>(m_mesh.groups.size() - 1);
}

Mesh MeshBuilder::take() {
    if (m_last_object == 0) m_mesh.triangle_object.clear(); // the whole mesh is one object
    return std::move(m_mesh);
}

std::uint32_t MeshBuilder::vertex(glm::vec3 position) {
    m_mesh.positions.push_back(position);
    return static_cast<std::uint32_t>(m_mesh.positions.size() - 1);
}

void MeshBuilder::triangle(Group g, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const glm::vec3 ab = position(b) - position(a);
    const glm::vec3 ac = position(c) - position(a);
    const glm::vec3 normal = glm::cross(ab, ac);
    const float longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), 1e-12F});
    if (glm::dot(normal, normal) < 1e-9F * longest * longest) return;
    m_mesh.triangles.emplace_back(a, b, c);
    m_mesh.triangle_group.push_back(g);
    m_mesh.triangle_object.push_back(m_object);
}

void MeshBuilder::quad(Group g, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                       std::uint32_t d) {
    triangle(g, a, b, c);
    triangle(g, a, c, d);
}

std::vector<std::uint32_t> MeshBuilder::ring(const glm::mat4& at,
                                             std::span<const glm::vec3> points) {
    std::vector<std::uint32_t> result;
    result.reserve(points.size());
    for (const glm::vec3& p : points) result.push_back(vertex(apply(at, p)));
    return result;
}

void MeshBuilder::loft(Group g, std::span<const std::uint32_t> a, std::span<const std::uint32_t> b,
                       bool closed) {
    const std::size_t last_a = closed ? a.size() : a.size() - 1;
    const std::size_t last_b = closed ? b.size() : b.size() - 1;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < last_a || j < last_b) {
        const std::uint32_t a0 = a[i % a.size()];
        const std::uint32_t b0 = b[j % b.size()];
        const std::uint32_t a1 = a[(i + 1) % a.size()];
        const std::uint32_t b1 = b[(j + 1) % b.size()];
        const bool on_a =
            j == last_b || (i < last_a && glm::distance(position(a1), position(b0)) <=
                                              glm::distance(position(a0), position(b1)));
        if (on_a) {
            triangle(g, a0, a1, b0);
            ++i;
        } else {
            triangle(g, a0, b1, b0);
            ++j;
        }
    }
}

void MeshBuilder::box(const glm::mat4& at, Group g, glm::vec3 lo, glm::vec3 hi, unsigned faces) {
    std::uint32_t v[8];
    for (unsigned i = 0; i < 8; ++i)
        v[i] = vertex(apply(at, {i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z}));
    if (faces & minus_x) quad(g, v[0], v[4], v[6], v[2]);
    if (faces & plus_x) quad(g, v[1], v[3], v[7], v[5]);
    if (faces & minus_y) quad(g, v[0], v[1], v[5], v[4]);
    if (faces & plus_y) quad(g, v[2], v[6], v[7], v[3]);
    if (faces & minus_z) quad(g, v[0], v[2], v[3], v[1]);
    if (faces & plus_z) quad(g, v[4], v[5], v[7], v[6]);
}

void MeshBuilder::open_quad(const glm::mat4& at, Group g, glm::vec3 a, glm::vec3 b, glm::vec3 c,
                            glm::vec3 d) {
    const std::uint32_t first = vertex(apply(at, a));
    vertex(apply(at, b));
    vertex(apply(at, c));
    vertex(apply(at, d));
    quad(g, first, first + 1, first + 2, first + 3);
}

void MeshBuilder::prism(const glm::mat4& at, Group g, const Outline& outline, float z0, float z1,
                        std::span<const Outline> holes) {
    const auto first = static_cast<std::uint32_t>(m_mesh.positions.size());
    auto add_points = [&](const Outline& points) {
        for (const glm::vec2& p : points) {
            vertex(apply(at, {p, z0}));
            vertex(apply(at, {p, z1}));
        }
    };
    auto add_walls = [&](std::uint32_t start, std::uint32_t count, bool outward) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t a = start + 2 * i;
            const std::uint32_t b = start + 2 * ((i + 1) % count);
            if (outward)
                quad(g, a, b, b + 1, a + 1);
            else
                quad(g, b, a, a + 1, b + 1);
        }
    };
    add_points(outline);
    add_walls(first, static_cast<std::uint32_t>(outline.size()), true);
    for (const Outline& hole : holes) {
        const auto start = static_cast<std::uint32_t>(m_mesh.positions.size());
        add_points(hole);
        add_walls(start, static_cast<std::uint32_t>(hole.size()), false);
    }
    for (const glm::uvec3& t : triangulate(outline, holes)) {
        triangle(g, first + 2 * t.x + 1, first + 2 * t.y + 1, first + 2 * t.z + 1);
        triangle(g, first + 2 * t.x, first + 2 * t.z, first + 2 * t.y);
    }
}

void MeshBuilder::lathe(const glm::mat4& at, Group g, std::span<const glm::vec2> profile,
                        int segments, bool staggered) {
    std::vector<std::uint32_t> below;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        std::vector<std::uint32_t> here;
        if (profile[i].x <= 0) {
            here.push_back(vertex(apply(at, {0, profile[i].y, 0})));
        } else {
            const float phase = staggered && i % 2 == 1 ? 0.5F : 0.0F;
            for (int k = 0; k < segments; ++k) {
                const float angle =
                    two_pi * (static_cast<float>(k) + phase) / static_cast<float>(segments);
                here.push_back(vertex(apply(at, {profile[i].x * std::cos(angle), profile[i].y,
                                                 -profile[i].x * std::sin(angle)})));
            }
        }
        if (i > 0 && here.size() > 1 && below.size() > 1) {
            loft(g, below, here, true);
        } else if (i > 0) {
            const std::size_t n = std::max(here.size(), below.size());
            for (std::size_t k = 0; k < n && n > 1; ++k) {
                if (here.size() == 1)
                    triangle(g, below[k], below[(k + 1) % n], here[0]);
                else
                    triangle(g, below[0], here[(k + 1) % n], here[k]);
            }
        }
        below = std::move(here);
    }
}

void MeshBuilder::rod(Group g, glm::vec3 from, glm::vec3 to, float radius, int segments,
                      bool capped) {
    const glm::mat4 at = along(from, to);
    const float length = glm::distance(from, to);
    Path circle(static_cast<std::size_t>(segments));
    for (int k = 0; k < segments; ++k) {
        const float angle = two_pi * ratio(k, segments);
        circle[static_cast<std::size_t>(k)] = {radius * std::cos(angle), 0,
                                               -radius * std::sin(angle)};
    }
    const auto lower = ring(at, circle);
    for (glm::vec3& p : circle) p.y = length;
    const auto upper = ring(at, circle);
    const std::size_t n = lower.size();
    for (std::size_t k = 0; k < n; ++k)
        quad(g, lower[k], lower[(k + 1) % n], upper[(k + 1) % n], upper[k]);
    for (std::size_t k = 1; capped && k + 1 < n; ++k) {
        triangle(g, lower[0], lower[k + 1], lower[k]);
        triangle(g, upper[0], upper[k], upper[k + 1]);
    }
}

void MeshBuilder::tube(const glm::mat4& at, Group g, std::span<const glm::vec3> path, float radius,
                       int segments, bool closed) {
    // A frame carried along the path without twist; a closed path is expected to lie in a plane.
    const std::size_t n = path.size();
    auto direction = [&](std::size_t i) {
        const std::size_t next = closed ? (i + 1) % n : std::min(i + 1, n - 1);
        const std::size_t previous = closed ? (i + n - 1) % n : (i == 0 ? 0 : i - 1);
        return glm::normalize(path[next] - path[previous]);
    };
    auto join = [&](const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& c) {
        for (std::size_t k = 0; k < a.size(); ++k)
            quad(g, a[k], a[(k + 1) % a.size()], c[(k + 1) % a.size()], c[k]);
    };
    glm::vec3 side = glm::vec3(along({}, direction(0))[0]);
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t> below;
    for (std::size_t i = 0; i < n; ++i) {
        const glm::vec3 forward = direction(i);
        side = glm::normalize(side - forward * glm::dot(side, forward));
        const glm::vec3 other = glm::cross(forward, side);
        Path points;
        for (int k = 0; k < segments; ++k) {
            const float angle = two_pi * ratio(k, segments);
            points.push_back(path[i] + radius * (side * std::cos(angle) + other * std::sin(angle)));
        }
        auto here = ring(at, points);
        if (i == 0)
            first = here;
        else
            join(below, here);
        below = std::move(here);
    }
    if (closed) join(below, first);
}

void MeshBuilder::rope(Group g, glm::vec3 from, glm::vec3 to, float radius, int lengths,
                       float sag) {
    const glm::mat4 frame = along(from, to);
    std::uint32_t below[3] = {};
    for (int i = 0; i <= lengths; ++i) {
        const float s = ratio(i, lengths);
        const glm::vec3 centre = glm::mix(from, to, s) - glm::vec3(0, 4 * sag * s * (1 - s), 0);
        std::uint32_t here[3];
        for (int k = 0; k < 3; ++k) {
            const float angle = two_pi * ratio(k, 3);
            here[k] = vertex(centre + radius * (glm::vec3(frame[0]) * std::cos(angle) -
                                                glm::vec3(frame[2]) * std::sin(angle)));
        }
        for (int k = 0; i > 0 && k < 3; ++k)
            quad(g, below[k], below[(k + 1) % 3], here[(k + 1) % 3], here[k]);
        for (int k = 0; k < 3; ++k) below[k] = here[k];
    }
}

void MeshBuilder::panel(const glm::mat4& at, Group g, int nu, int nv,
                        const std::function<glm::vec3(float, float)>& surface) {
    patch(at, nu, nv, surface, [g](int) { return g; });
}

void MeshBuilder::patch(const glm::mat4& at, int nu, int nv,
                        const std::function<glm::vec3(float, float)>& surface,
                        const std::function<Group(int)>& group_of_row) {
    const auto first = static_cast<std::uint32_t>(m_mesh.positions.size());
    for (int j = 0; j <= nv; ++j)
        for (int i = 0; i <= nu; ++i) vertex(apply(at, surface(ratio(i, nu), ratio(j, nv))));
    const auto row = static_cast<std::uint32_t>(nu + 1);
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(nv); ++j)
        for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(nu); ++i) {
            const std::uint32_t a = first + j * row + i;
            quad(group_of_row(static_cast<int>(j)), a, a + 1, a + row + 1, a + row);
        }
}

void MeshBuilder::strip(const glm::mat4& at, Group g, std::span<const glm::vec3> lower,
                        std::span<const glm::vec3> upper) {
    const auto a = ring(at, lower);
    const auto b = ring(at, upper);
    for (std::size_t i = 0; i + 1 < a.size(); ++i) quad(g, a[i], a[i + 1], b[i + 1], b[i]);
}

} // namespace lineatlas::scenes
