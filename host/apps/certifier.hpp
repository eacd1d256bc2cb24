#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "lineatlas/lines.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {
class ModelTruth;
}

namespace lineatlas::apps {

/// `draw --certify`: checks drawings of one model by rays.
class Certifier {
  public:
    /// `lines` are those that are drawn, extracted of the mesh by `options`, and must outlive it.
    /// Throws FileError when the module for rays can't be loaded.
    Certifier(const Mesh& mesh, const LineSet& lines, const LineOptions& options);
    ~Certifier();

    /// Says on stdout, and returns, what rays find in one line.
    std::string check(const VectorDrawing& drawing, const Camera& camera,
                      const std::filesystem::path& path) const;

  private:
    std::unique_ptr<ModelTruth> truth_;
};

} // namespace lineatlas::apps
