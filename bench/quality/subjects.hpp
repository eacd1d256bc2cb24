#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

// What quality is measured on.
namespace lineatlas::bench {

/// A place on a camera path.
struct PathView {
    std::string name;
    double at;                        ///< along the path, 0 to 1
    std::function<View(double)> path; ///< a model's path is a turntable

    View view() const { return path(at); }
};

struct Subject {
    std::string name;
    Mesh mesh;
    LineSet lines; ///< of the mesh, by LineOptions{}
    std::vector<PathView> views;
};

/// Two views for drawings that stand still. In perspective, of a built-in scene: all of it, and
/// from within; of others: all of it from the front, and from behind. In orthographic projection,
/// of both: isometric and front.
std::vector<PathView> still_views(const Subject& subject, glm::vec3 up, glm::ivec2 size,
                                  Projection projection);

/// Where to look from.
struct Places {
    std::vector<double> at;          ///< along the path
    std::vector<float> distances{1}; ///< times the eye's distance from its target
    Projection projection = Projection::perspective;
};

/// `count` places, evenly along the path.
std::vector<double> even_places(int count);

Subject scene_subject(const std::string& name, const Places& places);
Subject model_subject(const std::filesystem::path& path, glm::vec3 up, glm::ivec2 size,
                      const Places& places);

} // namespace lineatlas::bench
