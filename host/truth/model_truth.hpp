#pragma once

#include <memory>

#include "certificate.hpp"
#include "edge_truth.hpp"

namespace lineatlas {

/// The truth with which drawings of one model are compared. If the model has surfaces
/// (Mesh::surfaces), the truth is not the drawn triangles, but finer ones, with edges on the file's
/// curves and silhouettes on the surfaces themselves.
class ModelTruth {
  public:
    /// `lines`: the drawn lines, extracted from the mesh by `options`; they must outlive this
    /// object. Throws FileError if the module for rays cannot be loaded, and DeviceError if it
    /// refuses the scene.
    ModelTruth(const Mesh& mesh, const LineSet& lines, const LineOptions& options);
    ~ModelTruth();

    /// Where lines are visible for a camera, by as many threads as there are cores.
    EdgeTruth seen(const Camera& camera) const;

    /// How a drawing with this camera differs from `truth`, the result of seen() for the camera.
    Certificate certify(const EdgeTruth& truth, const Camera& camera,
                        const DrawnLines& drawn) const;

  private:
    struct Fine;

    RayScene scene_;
    std::unique_ptr<Fine> fine_; ///< null: only the drawn triangles are known
};

} // namespace lineatlas
