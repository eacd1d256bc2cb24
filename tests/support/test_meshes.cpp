#include "test_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace lineatlas::test {

glm::vec3 Random::point(float reach) {
    const float x = between(-reach, reach);
    const float y = between(-reach, reach);
    return {x, y, between(-reach, reach)};
}

glm::vec3 Random::direction() {
    for (;;) {
        const glm::vec3 candidate = point(1);
        const float length = glm::length(candidate);
        if (length > 0.1F && length <= 1) return candidate / length;
    }
}

glm::mat4 Random::placement(float reach) {
    const glm::mat4 move = glm::translate(glm::mat4{1}, point(reach));
    const glm::vec3 axis = direction();
    return glm::rotate(move, between(0, glm::two_pi<float>()), axis);
}

Mesh cube() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.positions.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1,
                                    (i & 4) != 0 ? 1 : -1);
    }
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh.triangles.emplace_back(a, b, c);
        mesh.triangles.emplace_back(a, c, d);
    };
    quad(0, 2, 3, 1);
    quad(4, 5, 7, 6);
    quad(0, 1, 5, 4);
    quad(2, 6, 7, 3);
    quad(0, 4, 6, 2);
    quad(1, 3, 7, 5);
    return mesh;
}

Mesh tetrahedron() {
    Mesh mesh;
    mesh.positions = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh;
}

Mesh sphere(int level) {
    Mesh mesh;
    mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (; level > 0; --level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto fresh = static_cast<std::uint32_t>(mesh.positions.size());
            const auto [found, added] = middles.try_emplace(std::minmax(a, b), fresh);
            if (added) {
                mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
            }
            return found->second;
        };
        std::vector<glm::uvec3> finer;
        for (const glm::uvec3 t : mesh.triangles) {
            const std::uint32_t xy = middle(t.x, t.y);
            const std::uint32_t yz = middle(t.y, t.z);
            const std::uint32_t zx = middle(t.z, t.x);
            finer.insert(finer.end(), {{t.x, xy, zx}, {t.y, yz, xy}, {t.z, zx, yz}, {xy, yz, zx}});
        }
        mesh.triangles = std::move(finer);
    }
    return mesh;
}

Mesh cylinder(std::uint32_t sides, bool capped) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const float angle =
            glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(sides);
        mesh.positions.emplace_back(std::cos(angle), -1, std::sin(angle));
        mesh.positions.emplace_back(std::cos(angle), 1, std::sin(angle));
    }
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t next = (i + 1) % sides;
        mesh.triangles.emplace_back(2 * i, 2 * i + 1, 2 * next + 1);
        mesh.triangles.emplace_back(2 * i, 2 * next + 1, 2 * next);
    }
    for (std::uint32_t i = 1; capped && i + 1 < sides; ++i) {
        mesh.triangles.emplace_back(0, 2 * i, 2 * i + 2);
        mesh.triangles.emplace_back(1, 2 * i + 3, 2 * i + 1);
    }
    return mesh;
}

Mesh open_strip(std::uint32_t quads) {
    Mesh mesh;
    for (std::uint32_t i = 0; i <= quads; ++i) {
        mesh.positions.emplace_back(i, 0, 0);
        mesh.positions.emplace_back(i, 1, 0);
    }
    for (std::uint32_t i = 0; i < quads; ++i) {
        mesh.triangles.emplace_back(2 * i, 2 * i + 2, 2 * i + 3);
        mesh.triangles.emplace_back(2 * i, 2 * i + 3, 2 * i + 1);
    }
    return mesh;
}

Mesh height_field(Random& random, std::uint32_t quads, float height) {
    Mesh mesh;
    const std::uint32_t row = quads + 1;
    for (std::uint32_t y = 0; y < row; ++y) {
        for (std::uint32_t x = 0; x < row; ++x) {
            mesh.positions.emplace_back(x, y, random.between(0, height));
        }
    }
    for (std::uint32_t y = 0; y < quads; ++y) {
        for (std::uint32_t x = 0; x < quads; ++x) {
            const std::uint32_t corner = y * row + x;
            mesh.triangles.emplace_back(corner, corner + 1, corner + row + 1);
            mesh.triangles.emplace_back(corner, corner + row + 1, corner + row);
        }
    }
    return mesh;
}

Mesh two_sided_quad() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}};
    return mesh;
}

Mesh bent_pair(float angle, bool flipped) {
    Mesh mesh;
    mesh.positions = {
        {0, 0, 0}, {0, 1, 0}, {-1, 0.5F, 0}, {std::cos(angle), 0.5F, std::sin(angle)}};
    mesh.triangles = {{0, 1, 2}, flipped ? glm::uvec3{0, 1, 3} : glm::uvec3{1, 0, 3}};
    return mesh;
}

Mesh moebius_band(std::uint32_t quads) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < quads; ++i) {
        const float turn = glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(quads);
        for (const float v : {-0.3F, 0.3F}) {
            const float radius = 1 + v * std::cos(turn / 2);
            mesh.positions.emplace_back(radius * std::cos(turn), radius * std::sin(turn),
                                        v * std::sin(turn / 2));
        }
    }
    for (std::uint32_t i = 0; i < quads; ++i) {
        const bool last = i + 1 == quads;
        const std::uint32_t low = last ? 1 : 2 * i + 2;
        const std::uint32_t high = last ? 0 : 2 * i + 3;
        mesh.triangles.emplace_back(2 * i, low, high);
        mesh.triangles.emplace_back(2 * i, high, 2 * i + 1);
    }
    return mesh;
}

Mesh faces_on_an_edge(std::uint32_t faces) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 1, 0}};
    for (std::uint32_t i = 0; i < faces; ++i) {
        const float angle =
            glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(faces);
        mesh.positions.emplace_back(std::cos(angle), 0.5F, std::sin(angle));
        mesh.triangles.emplace_back(0, 1, i + 2);
    }
    return mesh;
}

Mesh split_edge(float angle) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0},
                      {0, 1, 0},
                      {0, 0.4F, 0},
                      {-1, 0.5F, 0},
                      {std::cos(angle), 0.5F, std::sin(angle)}};
    mesh.triangles = {{0, 1, 3}, {1, 0, 2}, {2, 0, 4}, {1, 2, 4}};
    return mesh;
}

Mesh random_soup(Random& random, std::uint32_t vertices, std::uint32_t triangles) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < vertices; ++i) mesh.positions.push_back(random.point(1));
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const std::uint32_t a = random.below(vertices);
        const std::uint32_t b = random.below(vertices);
        mesh.triangles.emplace_back(a, b, random.below(vertices));
    }
    return mesh;
}

Mesh moved(Mesh mesh, const glm::mat4& placement) {
    for (glm::vec3& p : mesh.positions) p = glm::vec3{placement * glm::vec4{p, 1}};
    return mesh;
}

Mesh with_own_corners(const Mesh& mesh) {
    Mesh result = mesh;
    result.positions.clear();
    for (glm::uvec3& t : result.triangles) {
        const auto first = static_cast<std::uint32_t>(result.positions.size());
        for (int corner = 0; corner < 3; ++corner) {
            result.positions.push_back(mesh.positions[t[corner]]);
        }
        t = {first, first + 1, first + 2};
    }
    return result;
}

Mesh with_random_windings(Mesh mesh, Random& random) {
    for (glm::uvec3& t : mesh.triangles) {
        if (random.coin()) std::swap(t.y, t.z);
    }
    return mesh;
}

Mesh with_random_radii(Mesh mesh, Random& random, float low) {
    for (glm::vec3& p : mesh.positions) p *= random.between(low, 1);
    return mesh;
}

Mesh with_random_groups(Mesh mesh, Random& random, std::uint32_t groups) {
    mesh.groups.clear();
    mesh.triangle_group.clear();
    for (std::uint32_t i = 0; i < groups; ++i) {
        mesh.groups.push_back({.object = "part " + std::to_string(i), .material = {}});
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        mesh.triangle_group.push_back(random.below(groups));
    }
    return mesh;
}

} // namespace lineatlas::test
