#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/contact.hpp"
#include "ray_scene.hpp"

namespace lineatlas {

/// When a triangle before a line hides it (docs/quality.md).
struct BlockingRule {
    /// A triangle touches the line's point, and does not hide it, if its plane is nearer to the
    /// point than this share of the model's extent, or than twice LineSet::precision. Coordinates
    /// of a file tell no more.
    double contact = contact_share;
    /// A smooth surface bends before its own outline. Hits on the patches of the line's own
    /// triangles do not hide the point if they are nearer to it than this many pixels there. 0 for
    /// points on the line.
    double patch_pixels = 0;
};

/// The triangles that can hide one segment of a scene.
class Blocking {
  public:
    /// All arguments must outlive this object.
    Blocking(const RayScene& scene, const PreciseCamera& projection, const BlockingRule& rule,
             std::uint32_t segment);

    /// How far before the end of a sight of the segment a triangle hides that end, in world units.
    /// Nothing if the triangle does not hide it: the triangle holds the segment itself, touches the
    /// point, lies before the near plane, or bends into the way beside its own outline. The sight
    /// must go through the triangle.
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
