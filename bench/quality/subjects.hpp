#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

// The models and views that quality is measured on.
namespace lineatlas::bench {

/// A place on a camera path.
struct PathView {
    std::string name;
    double at;                        ///< along the path, 0 to 1
    std::function<View(double)> path; ///< of a model's file: a turntable

    View view() const { return path(at); }
};

struct Subject {
    std::string name;
    Mesh mesh;
    LineSet lines; ///< the mesh's lines by LineOptions{}
    std::vector<PathView> views;
};

/// Two views for still drawings. In perspective: a built-in scene is seen from outside and from
/// within, another model from the front and from behind. In orthographic projection: isometric and
/// front.
std::vector<PathView> still_views(const Subject& subject, glm::vec3 up, glm::ivec2 size,
                                  Projection projection);

/// The places of cameras along a path.
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
