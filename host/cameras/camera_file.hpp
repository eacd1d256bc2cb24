#pragma once

#include <filesystem>
#include <string>

#include "lineatlas/camera_path.hpp"

namespace lineatlas {

/// The keyframes of a JSON file (docs/output.md). Members that the first key leaves out are taken
/// from `defaults`, those that others leave out from the key before. `origin` is subtracted from
/// all points. Throws FileError that names the file, the key and the way out.
CameraPath read_camera_path(const std::filesystem::path& file, const View& defaults,
                            glm::dvec3 origin = glm::dvec3{0});

/// The file of a path with one key at `view`. `origin` is added to its points.
std::string camera_file(const View& view, glm::dvec3 origin);

} // namespace lineatlas
