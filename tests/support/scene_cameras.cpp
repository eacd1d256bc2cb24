#include "scene_cameras.hpp"

#include <functional>
#include <map>
#include <string>

#include <glm/geometric.hpp>

#include "lineatlas/scenes.hpp"

namespace lineatlas::test {

const LineSet& scene_lines(std::string_view name) {
    static std::map<std::string, LineSet, std::less<>> cache;
    auto found = cache.find(name);
    if (found == cache.end())
        found = cache.emplace(name, extract_lines(make_scene(std::string{name}).mesh)).first;
    return found->second;
}

std::vector<NamedCamera> scene_cameras(const std::string& name, glm::ivec2 size) {
    const Scene scene = make_scene(name);
    const LineSet& lines = scene_lines(name);
    const glm::vec3 center = 0.5F * (lines.bounds.min + lines.bounds.max);
    const float extent = glm::length(lines.bounds.max - lines.bounds.min);
    // Skewed, so that no axis-aligned face is seen exactly edge-on.
    const View inside{.eye = center + 0.013F * extent * glm::vec3{1, 0.7F, -0.4F},
                      .target = center + extent * glm::vec3{1, 0.11F, 0.23F},
                      .fov_y = 1.2F,
                      .near = 1e-3F * extent,
                      .far = 2 * extent};
    return {{"start", make_camera(scene.view(0.1F), size, lines.bounds)},
            {"later", make_camera(scene.view(0.55F), size, lines.bounds)},
            {"inside", make_camera(inside, size, lines.bounds)}};
}

std::vector<NamedCamera> few_scene_cameras(const std::string& name, glm::ivec2 size) {
    std::vector<NamedCamera> all = scene_cameras(name, size);
    if (name == "ship") return {all.front()};
    if (name == "office") return {all.back()};
    return all;
}

} // namespace lineatlas::test
