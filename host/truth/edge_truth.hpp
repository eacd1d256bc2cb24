#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "blocking.hpp"
#include "ray_scene.hpp"
#include "vector/mesh_circles.hpp"

// Where the lines of a model are visible, point by point: the truth for drawings as paths.
// Silhouettes of smooth surfaces run where the surface itself turns away (contour_crossing.hpp).
namespace lineatlas {

enum class Visibility : std::uint8_t {
    hidden,
    visible,
    undecided, ///< the answer is another a pixel to one side of the line, or is not known
};

/// A place on a segment.
struct EdgePoint {
    glm::vec2 at;          ///< pixels from the upper left corner of the picture, y down
    glm::vec2 along;       ///< direction of the line there, of length 1
    float pixels;          ///< length of the segment that it stands for, half before and half
                           ///< behind it
    std::uint32_t segment; ///< index into LineSet::segments
    float u;               ///< share of the part of the segment that is in the picture
    Visibility visibility;
    /// Whether the segment is surely a line. Segments near the threshold of being a silhouette may
    /// be drawn and may be missing.
    bool required;
    /// For a chord of a circle that a mesh was cut from, the place on the circle over the point. A
    /// line may run along either.
    std::optional<glm::vec2> on_arc{};
};

struct EdgeTruthOptions {
    double step = 0.25; ///< pixels between points at most
    BlockingRule rule{};
    unsigned threads = 2;
    const MeshCircles* circles = nullptr; ///< of the scene's lines; null: none are known
};

class EdgeTruth {
  public:
    /// Casts rays from the eye to every point, and to the places a pixel to its left and right. For
    /// silhouettes of smooth surfaces the ray to the point passes a tenth of a pixel beyond the
    /// surface. The scene must outlive this object. The result is the same for any number of
    /// threads.
    EdgeTruth(const RayScene& scene, const Camera& camera, const EdgeTruthOptions& options = {});

    glm::ivec2 size() const { return size_; }
    const RayScene& scene() const { return scene_; }
    std::span<const EdgePoint> points() const { return points_; } ///< by segment and along each
    std::span<const EdgePoint> points_of(std::uint32_t segment) const;

    /// The nearest to a hidden point of the triangles that hide it.
    struct Blocker {
        double distance; ///< along the sight, in pixel widths at the point
        std::uint32_t triangle;
    };
    std::optional<Blocker> nearest_blocker(const EdgePoint& point) const;

  private:
    glm::ivec2 size_;
    const RayScene& scene_;
    PreciseCamera projection_;
    BlockingRule rule_;
    std::vector<EdgePoint> points_;
    std::vector<std::size_t> first_; ///< point of each segment, then their number
};

} // namespace lineatlas
