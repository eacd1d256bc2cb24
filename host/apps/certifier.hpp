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
    /// `lines`: the lines that are drawn, extracted from the mesh by `options`; they must outlive
    /// this object. Throws FileError if the module for rays cannot be loaded.
    Certifier(const Mesh& mesh, const LineSet& lines, const LineOptions& options);
    ~Certifier();

    /// Checks a drawing. Prints the result as one line on stdout and returns it.
    std::string check(const VectorDrawing& drawing, const Camera& camera,
                      const std::filesystem::path& path) const;

  private:
    std::unique_ptr<ModelTruth> truth_;
};

} // namespace lineatlas::apps
