#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

namespace lineatlas::rays {

/// Triangles in a structure for casting rays.
class Scene;

/// A ray goes from `origin` to `origin + way` and a little beyond.
struct Ray {
    glm::vec3 origin, way;
};

/// Decides whether a triangle stops a ray. `stops` is called for triangles that the ray goes
/// through, in any order and on the thread that casts, until it returns true.
struct Judge {
    bool (*stops)(const void* data, std::uint32_t ray, std::uint32_t triangle);
    const void* data; ///< handed on to `stops`
};

/// The functions of the module lineatlas-rays, the only one that links Embree. No ray slips between
/// two triangles that share an edge. Every refusal is a std::runtime_error that says the cause in
/// one line.
struct Module {
    /// Copies its arguments.
    Scene* (*build)(std::span<const glm::vec3> vertices, std::span<const glm::uvec3> triangles);
    void (*destroy)(Scene* scene);
    /// May be called from several threads. `stopped` has a place per ray and gets 0 or 1.
    void (*cast)(const Scene& scene, std::span<const Ray> rays, const Judge& judge,
                 std::span<std::uint8_t> stopped);
};

/// The module's one symbol. Its number changes with `Module`.
inline constexpr const char* module_symbol = "lineatlas_rays_1";

} // namespace lineatlas::rays

extern "C" const lineatlas::rays::Module lineatlas_rays_1;
