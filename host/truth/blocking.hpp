#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/contact.hpp"
#include "ray_scene.hpp"

namespace lineatlas {

/// When a triangle before a line hides it (docs/quality.md).
struct BlockingRule {
    /// A triangle whose plane is nearer to the line's point than this share of the model's extent,
    /// or than twice LineSet::precision, touches it and does not hide it: that is all that
    /// coordinates of a file can tell.
    double contact = contact_share;
    /// A smooth surface bends before its own outline: hits on the patches of the line's own
    /// triangles nearer to the end than this many pixels there do not hide it. Of points 0.
    double patch_pixels = 0;
};

/// The triangles that can hide one segment of a scene.
class Blocking {
  public:
    /// All must outlive it.
    Blocking(const RayScene& scene, const PreciseCamera& projection, const BlockingRule& rule,
             std::uint32_t segment);

    /// How far before the end of a sight of the segment a triangle hides it, in world units.
    /// Nothing if it doesn't: it holds the segment itself, touches the point, lies before the near
    /// plane, or bends into the way beside its own outline. The sight must go through it.
    std::optional<double> before(const Sight& sight, std::uint32_t triangle) const;

    /// Whether a triangle is of a smooth patch that holds the segment.
    bool is_own_surface(std::uint32_t triangle) const;

  private:
    const RayScene& scene_;
    const PreciseCamera& projection_;
    double contact_, patch_pixels_;
    std::vector<std::uint32_t> own_, own_patches_;
};

} // namespace lineatlas
