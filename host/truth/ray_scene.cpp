#include "ray_scene.hpp"

#include <utility>

#include <glm/geometric.hpp>

#include "core/patches.hpp"
#include "io/module_files.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

const rays::Module& ray_module() {
    static const auto& module =
        *static_cast<const rays::Module*>(load_module(module_files::rays, rays::module_symbol));
    return module;
}

rays::Scene* build(const LineSet& lines) {
    const rays::Module& module = ray_module();
    try {
        return module.build(lines.vertices, lines.triangles);
    } catch (const std::runtime_error& error) {
        throw DeviceError(std::string{"cannot check by rays: "} + error.what());
    }
}

} // namespace

void check_ray_module() {
    find_module(module_files::rays);
}

void RayScene::Release::operator()(rays::Scene* scene) const {
    ray_module().destroy(scene);
}

RayScene::RayScene(const LineSet& lines) : RayScene(lines, smooth_patches(lines)) {}

RayScene::RayScene(const LineSet& lines, std::vector<std::uint32_t> patches)
    : lines_(lines), patches_(std::move(patches)),
      extent_(glm::length(glm::dvec3{lines.bounds.max} - glm::dvec3{lines.bounds.min})),
      first_at_(lines.vertices.size() + 1), triangles_at_(3 * lines.triangles.size()),
      scene_(build(lines)) {
    for (const glm::uvec3& triangle : lines.triangles) {
        for (int k = 0; k < 3; ++k) ++first_at_[triangle[k] + 1];
    }
    for (std::size_t v = 1; v < first_at_.size(); ++v) first_at_[v] += first_at_[v - 1];
    std::vector<std::uint32_t> place(first_at_.begin(), first_at_.end() - 1);
    for (std::uint32_t i = 0; i < lines.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) triangles_at_[place[lines.triangles[i][k]]++] = i;
    }
}

std::span<const std::uint32_t> RayScene::triangles_at(std::uint32_t vertex) const {
    return std::span{triangles_at_}.subspan(first_at_[vertex],
                                            first_at_[vertex + 1] - first_at_[vertex]);
}

void RayScene::cast(std::span<const Sight> sights, const Judge& judge,
                    std::span<std::uint8_t> blocked) const {
    std::vector<rays::Ray> rays;
    rays.reserve(sights.size());
    for (const Sight& sight : sights)
        rays.push_back({glm::vec3{sight.origin}, glm::vec3{sight.end - sight.origin}});
    const rays::Judge asked{.stops =
                                [](const void* data, std::uint32_t ray, std::uint32_t triangle) {
                                    return (*static_cast<const Judge*>(data))(ray, triangle);
                                },
                            .data = &judge};
    ray_module().cast(*scene_, rays, asked, blocked);
}

} // namespace lineatlas
