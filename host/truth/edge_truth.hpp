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
    undecided, ///< a pixel to one side of the line the answer is another, or nobody knows
};

/// A place on a segment.
struct EdgePoint {
    glm::vec2 at;          ///< pixels from the upper left corner of the picture, y down
    glm::vec2 along;       ///< direction of the line there, as long as 1
    float pixels;          ///< of the segment that it stands for, half before and half behind it
    std::uint32_t segment; ///< index into LineSet::segments
    float u;               ///< share of the part of the segment that is in the picture
    Visibility visibility;
    /// Whether the segment is surely a line. Others, which are near the threshold between a
    /// silhouette and none, may be drawn and may be missing.
    bool required;
    /// Of a chord that a mesh was cut to: the place over it on the circle. A line may run along
    /// either.
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
    /// Casts a ray from the eye to every point, and to those a pixel to its left and right; of
    /// silhouettes of smooth surfaces a tenth of a pixel beyond the surface. The scene must outlive
    /// it. The same for any number of threads.
    EdgeTruth(const RayScene& scene, const Camera& camera, const EdgeTruthOptions& options = {});

    glm::ivec2 size() const { return size_; }
    const RayScene& scene() const { return scene_; }
    std::span<const EdgePoint> points() const { return points_; } ///< by segment and along each
    std::span<const EdgePoint> points_of(std::uint32_t segment) const;

    /// What is nearest to a hidden point of what hides it.
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
