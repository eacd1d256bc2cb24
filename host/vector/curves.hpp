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

    /// Puts points onto curves, and between their chords' ends as many more as it takes to run
    /// along them within a hundredth of a pixel. A point that is not on its curve stays, as on an
    /// object that has moved since it was read. An edge that ends beside the end of a silhouette on
    /// a surface, as a rim does within a chord's length, ends there.
    void bend(std::vector<VectorPath>& paths) const;

    /// Names the file's edge or face that each piece shows.
    void name(std::vector<VectorPath>& paths) const;

    /// Per path a number that those have in common which lie on one circle or ellipse on the screen
    /// all along, or no_curve. Empty where no curves are known.
    std::vector<std::uint32_t> numbers(const std::vector<VectorPath>& paths) const;
    static constexpr std::uint32_t no_curve = 0xFFFFFFFF;

    /// Keeps chords of a mesh's circles straight that other lines run along: for find(), before
    /// remove_overlaps() leaves one of both.
    void keep_shared_chords(const std::vector<VectorPath>& paths) const;

    /// The points of a path, ascending, at which a curve begins or ends: where one touches a line
    /// or another curve, hardly anything bends.
    std::vector<std::uint32_t> joints(const VectorPath& path) const;

    /// Fills VectorPath::curves, and puts ends of paths, which lie on chords, onto curves. A part
    /// whose points are not on its curve, as of an object that has moved since it was read, has
    /// none; neither has one that is seen so flat or is so small that half a pixel holds it, but
    /// its ends go where it turns. Chords of a mesh's circle become arcs from corner to corner if
    /// the corners are within 0.02 pixels of it. All corners stay where they are. A part of a chord
    /// stays straight; so does a chord at which another line ends, unless that is within 0.02
    /// pixels of the arc.
    void find(std::vector<VectorPath>& paths) const;

  private:
    class Finder;
    std::unique_ptr<Finder> finder_;
};

} // namespace lineatlas
