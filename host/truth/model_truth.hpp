#pragma once

#include <memory>
#include <optional>

#include "certificate.hpp"
#include "edge_truth.hpp"

namespace lineatlas {

/// The truth with which drawings of one model are compared. If the model has surfaces
/// (Mesh::surfaces), the truth is not the drawn triangles, but finer ones, with edges on the file's
/// curves and silhouettes on the surfaces themselves. If it has only triangles, lines may run along
/// the circles that these were cut from (MeshCircles), or along chords.
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

    EdgeTruth look(const RayScene& scene, const Camera& camera) const;

    RayScene scene_;
    std::optional<MeshCircles> circles_; ///< of a mesh whose file knows none
    std::unique_ptr<Fine> fine_; ///< null: the triangles that are drawn are all that is known
};

} // namespace lineatlas
