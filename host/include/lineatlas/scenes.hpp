#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "lineatlas/camera.hpp"
#include "lineatlas/export.hpp"
#include "lineatlas/mesh.hpp"

/// @file
/// The built-in models.
/// @code{.cpp}
/// const Scene ship = make_scene("ship");
/// const LineSet its_lines = extract_lines(ship.mesh);
/// const Camera first = make_camera(ship.view(0), size, its_lines.bounds);
/// @endcode

namespace lineatlas {

/// A built-in procedural model with the camera path of its measurements (Table 1). It is the same
/// on every machine and in every run.
struct Scene {
    std::string name; ///< the name for make_scene()
    Mesh mesh;        ///< y up
    /// The view at `t` in [0, 1] along the camera path; continuous, with near and far planes set so
    /// that they do not change along the path. An orbit closes: view(0) equals view(1).
    std::function<View(float t)> view;
};

/// The names that make_scene() takes, in the order of Table 1: clevis, house, ship, office.
LINEATLAS_API std::span<const std::string_view> scene_names();

/// Builds a scene. Throws UsageError for an unknown name.
LINEATLAS_API Scene make_scene(std::string_view name);

} // namespace lineatlas
