#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "clipped_lines.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"
#include "truth/blocking.hpp"

// The truth that every visibility method is measured against: exact partial visibility (§3.2) by
// ray casting, without a depth buffer and so without its resolution, biases and rounding.
namespace lineatlas::bench {

/// The part of a line that stands for it: a quad this wide on the screen (§3.2).
inline constexpr float quad_width_pixels = 1;

struct TruthOptions {
    std::uint32_t rays = 64;         ///< per sample at least; rounded up to a square
    float width = quad_width_pixels; ///< of the quad, in pixels
    BlockingRule rule{.patch_pixels = 2};
    unsigned threads = 2;
};

/// What is nearest to a line among all that hides it.
struct Blocker {
    double distance; ///< from the line towards the eye, in pixel widths there
    std::uint32_t triangle;
};

/// Casts rays at the triangles of one line set, which must have been extracted with every kind and
/// outlive it.
class Oracle {
  public:
    explicit Oracle(const LineSet& lines) : scene_(lines) {}
    /// With patches of one's own, a number per triangle.
    Oracle(const LineSet& lines, std::vector<std::uint32_t> patches)
        : scene_(lines, std::move(patches)) {}

    /// The visible share of every sample, 0 to 1, in the order of `lines.offsets`.
    ///
    /// Sample j of l is the quad that reaches from j/l to (j+1)/l of the segment in the window and
    /// `width` pixels across it. Rays go from the eye to jittered points of the quad, each at the
    /// depth of the line beside it; what blocks them, Blocking says. The same on every machine.
    std::vector<float> visibility(const ClippedLines& lines, const Camera& camera,
                                  const TruthOptions& options = {}) const;

    /// The blocker nearest to one sample's quad; for finding causes.
    std::optional<Blocker> nearest_blocker(const ClippedLines& lines, const Camera& camera,
                                           std::uint32_t segment, std::uint32_t sample,
                                           const TruthOptions& options = {}) const;

    const LineSet& lines() const { return scene_.lines(); }
    const RayScene& scene() const { return scene_; }

  private:
    RayScene scene_;
};

} // namespace lineatlas::bench
