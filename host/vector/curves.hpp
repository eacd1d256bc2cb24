#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "lineatlas/camera.hpp"
#include "lineatlas/mesh.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Which parts of paths run along the file's own circles and ellipses (Mesh::edge_curves), or
/// along circles that a mesh was cut from (MeshCircles).
class PathCurves {
  public:
    /// Null: no curves are known. Keeps a reference to the mesh.
    PathCurves(const LineSet& lines, const Mesh* mesh, const Camera& camera);
    ~PathCurves();
    PathCurves(const PathCurves&) = delete;
    PathCurves& operator=(const PathCurves&) = delete;

    /// Puts points onto their curves, and adds points until no chord is off its curve by more than
    /// a hundredth of a pixel. A point that is not on its curve stays, as on an object that has
    /// moved since it was read. If an edge ends less than a chord's length beside the end of a
    /// silhouette on a surface, as a rim does, its end moves there.
    void bend(std::vector<VectorPath>& paths) const;

    /// Names the file's edge or face that each piece shows.
    void name(std::vector<VectorPath>& paths) const;

    /// Per path a number, the same for all paths that lie on one circle or ellipse on the screen
    /// all along; no_curve for other paths. Empty where no curves are known.
    std::vector<std::uint32_t> numbers(const std::vector<VectorPath>& paths) const;
    static constexpr std::uint32_t no_curve = 0xFFFFFFFF;

    /// Makes find() keep chords of a mesh's circles straight if other lines run along them. Call it
    /// before remove_overlaps(), which leaves one of two such lines.
    void keep_shared_chords(const std::vector<VectorPath>& paths) const;

    /// The points of a path, ascending, at which a curve begins or ends. They must be kept: where a
    /// curve touches a line or another curve, the path hardly bends.
    std::vector<std::uint32_t> joints(const VectorPath& path) const;

    /// Fills VectorPath::curves, and puts ends of paths, which lie on chords, onto curves. A part
    /// of a path gets no curve if its points are not on the curve, as on an object that has moved
    /// since it was read. It gets none either if half a pixel holds the curve, because it is small
    /// or seen edge on; then the part ends where the curve turns. Chords of a mesh's circle become
    /// arcs from corner to corner if the corners are within 0.02 pixels of it. All corners stay
    /// where they are. A part of a chord stays straight. So does a chord at which another line
    /// ends, unless that line is within 0.02 pixels of the arc.
    void find(std::vector<VectorPath>& paths) const;

  private:
    class Finder;
    std::unique_ptr<Finder> finder_;
};

} // namespace lineatlas
