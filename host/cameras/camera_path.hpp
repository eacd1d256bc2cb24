#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "lineatlas/camera.hpp"

namespace lineatlas {

/// A camera that moves through keyframes of a JSON file (docs/output.md), smoothly.
class CameraPath {
  public:
    /// What the first key leaves out is taken from `defaults`, what others leave out from the key
    /// before. `origin` is taken off all points. Throws FileError that names the file, the key and
    /// the way out.
    CameraPath(const std::filesystem::path& file, const View& defaults,
               glm::dvec3 origin = glm::dvec3{0});

    /// Through views that are so many frames apart, from frame 0 on.
    CameraPath(std::span<const View> views, int frames_apart);

    int first_frame() const;
    int last_frame() const;
    View view(double frame) const;

  private:
    struct Key {
        double frame = 0;
        View view;
    };

    std::vector<Key> keys_; ///< by rising frame; at least one
};

/// The file of a path of one key, at `view`, whose points are `origin` nearer to zero.
std::string camera_file(const View& view, glm::dvec3 origin);

} // namespace lineatlas
