#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::test {

/// A built-in scene's lines, extracted once per process.
const LineSet& scene_lines(std::string_view name);

struct NamedCamera {
    std::string name;
    Camera camera;
};

/// Views on a scene: two from its camera path, and one from inside the model with much of it behind
/// the eye and across the eye plane.
std::vector<NamedCamera> scene_cameras(const std::string& name, glm::ivec2 size = {320, 240});

/// The same, but a single view of each large scene: the ship from outside and the office from
/// inside. A frame of these takes long, and one view is enough for errors of large tables.
std::vector<NamedCamera> few_scene_cameras(const std::string& name, glm::ivec2 size = {320, 240});

} // namespace lineatlas::test
