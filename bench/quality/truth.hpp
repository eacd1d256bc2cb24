#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "clipped_lines.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"
#include "truth/blocking.hpp"

// The truth that every method is measured against: exact partial visibility (§3.2) by ray casting.
// It uses no depth buffer, so it has no resolution, bias or rounding of one.
namespace lineatlas::bench {

/// The width in pixels of the quad on the screen that stands for a line (§3.2).
inline constexpr float quad_width_pixels = 1;

struct TruthOptions {
    std::uint32_t rays = 64;         ///< per sample; rounded up to a square number
    float width = quad_width_pixels; ///< width of the quad in pixels
    BlockingRule rule{.patch_pixels = 2};
    unsigned threads = 2;
};

/// The nearest surface to a line among all surfaces that hide it.
struct Blocker {
    double distance; ///< from the line towards the eye, in pixel widths there
    std::uint32_t triangle;
};

/// Casts rays at the triangles of one line set. The line set must have lines of every kind and must
/// outlive this object.
class Oracle {
  public:
    explicit Oracle(const LineSet& lines) : scene_(lines) {}
    /// An oracle with given patches: a number per triangle.
    Oracle(const LineSet& lines, std::vector<std::uint32_t> patches)
        : scene_(lines, std::move(patches)) {}

    /// The visible share of every sample, 0 to 1, in the order of `lines.offsets`.
    ///
    /// Sample j of l is a quad from j/l to (j+1)/l of the segment in the window and `width` pixels
    /// wide. Rays go from the eye to jittered points of the quad, each at the depth of the nearest
    /// point of the line. Blocking decides what blocks a ray. The result is the same on every
    /// machine.
    std::vector<float> visibility(const ClippedLines& lines, const Camera& camera,
                                  const TruthOptions& options = {}) const;

    /// The blocker nearest to a sample's quad, to find the cause of an error.
    std::optional<Blocker> nearest_blocker(const ClippedLines& lines, const Camera& camera,
                                           std::uint32_t segment, std::uint32_t sample,
                                           const TruthOptions& options = {}) const;

    const LineSet& lines() const { return scene_.lines(); }
    const RayScene& scene() const { return scene_; }

  private:
    RayScene scene_;
};

} // namespace lineatlas::bench
