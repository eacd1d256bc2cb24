#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "lineatlas/lines.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {
class RayScene;
}

namespace lineatlas::apps {

/// `draw --certify`: checks drawings of one model by rays.
class Certifier {
  public:
    /// `lines` are those that are drawn, of the mesh, and must outlive it; creases are those of
    /// LineOptions::crease. Throws FileError when the module for rays can't be loaded.
    Certifier(const Mesh& mesh, const LineSet& lines, std::optional<float> crease_angle);
    ~Certifier();

    /// Says on stdout, and returns, what rays find in one line.
    std::string check(const VectorDrawing& drawing, const Camera& camera,
                      const std::filesystem::path& path) const;

  private:
    std::unique_ptr<RayScene> scene_;
};

} // namespace lineatlas::apps
