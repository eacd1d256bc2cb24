#pragma once

#include <optional>
#include <span>
#include <string>

#include "lineatlas/camera.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas::apps {

/// How far chords of exact surfaces may be off in pictures, in pixels.
inline constexpr double most_pixels_off = 0.25;

/// Pixels per unit of length at the nearest curved thing that the camera sees: triangles of the
/// mesh with different normals at their corners, and edges of the file in several pieces. 0 if it
/// sees none.
double pixels_per_unit(const Mesh& mesh, const Camera& camera);

/// The deflection that a file of exact surfaces must be read with for these pictures; nothing if
/// `used` is fine enough. It is never less than a hundred-thousandth of the mesh's diagonal. If
/// that is not fine enough, `note` says by how much chords are off.
std::optional<double> finer_deflection(const Mesh& mesh, std::span<const Camera> cameras,
                                       double used, std::string& note);

} // namespace lineatlas::apps
