#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "clipped_lines.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

// The truth that every visibility method is measured against: exact partial visibility (§3.2) by
// ray casting, without a depth buffer and so without its resolution, biases and rounding.
namespace lineatlas::bench {

/// The part of a line that stands for it: a quad this wide on the screen (§3.2).
inline constexpr float quad_width_pixels = 1;

/// What stands before a line by no more than this many pixel widths is its own neighbourhood and
/// hides nothing: the quad dips into a curved surface beside a crease or a silhouette.
inline constexpr float neighbourhood_pixels = 2;

struct TruthOptions {
    std::uint32_t rays = 64;                    ///< per sample at least; rounded up to a square
    float width = quad_width_pixels;            ///< of the quad, in pixels
    float neighbourhood = neighbourhood_pixels; ///< in world-space pixel widths at the line
    unsigned threads = 2;
};

/// What is nearest to a line among all that stands before it, the line's own faces apart.
struct Blocker {
    double distance; ///< from the line towards the eye, in pixel widths there
    std::uint32_t triangle;
};

/// Casts rays at the triangles of one line set, which must outlive it.
class Oracle {
  public:
    explicit Oracle(const LineSet& lines);
    ~Oracle();
    Oracle(const Oracle&) = delete;
    Oracle& operator=(const Oracle&) = delete;

    /// The visible share of every sample, 0 to 1, in the order of `lines.offsets`.
    ///
    /// Sample j of l is the quad that reaches from j/l to (j+1)/l of the segment in the window and
    /// `width` pixels across it. Rays go from the eye to jittered points of the quad, each at the
    /// depth of the line beside it. A ray is blocked by any triangle on its way but those that hold
    /// both ends of the segment and those within the neighbourhood of its end. The same on every
    /// machine.
    std::vector<float> visibility(const ClippedLines& lines, const Camera& camera,
                                  const TruthOptions& options = {}) const;

    /// The blocker nearest to one sample's quad, neighbourhood included; for finding causes.
    std::optional<Blocker> nearest_blocker(const ClippedLines& lines, const Camera& camera,
                                           std::uint32_t segment, std::uint32_t sample) const;

    const LineSet& lines() const { return lines_; }

  private:
    struct Scene;
    const LineSet& lines_;
    std::unique_ptr<Scene> scene_;
};

} // namespace lineatlas::bench
