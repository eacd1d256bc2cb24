#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "lineatlas/lines.hpp"
#include "projection.hpp"
#include "rays_module.hpp"

namespace lineatlas {

/// Throws FileError if the module that casts rays is not in its place. Does not load it.
void check_ray_module();

/// The triangles of a line set as rays meet them.
class RayScene {
  public:
    /// `lines` must have been extracted with every kind (smooth_patches()) and outlive this object.
    /// Throws FileError if the module cannot be loaded, and DeviceError if it refuses the scene.
    explicit RayScene(const LineSet& lines);
    /// As above, with the caller's patches: a number per triangle.
    RayScene(const LineSet& lines, std::vector<std::uint32_t> patches);

    const LineSet& lines() const { return lines_; }
    std::span<const std::uint32_t> patches() const { return patches_; } ///< per triangle
    double extent() const { return extent_; }                           ///< diagonal of the bounds
    /// The triangles at a vertex.
    std::span<const std::uint32_t> triangles_at(std::uint32_t vertex) const;

    /// Whether each sight is blocked: `judge` is asked about triangles on its way, in any order,
    /// until one blocks it. May be called from several threads.
    using Judge = std::function<bool(std::uint32_t sight, std::uint32_t triangle)>;
    void cast(std::span<const Sight> sights, const Judge& judge,
              std::span<std::uint8_t> blocked) const;

  private:
    struct Release {
        void operator()(rays::Scene* scene) const;
    };

    const LineSet& lines_;
    std::vector<std::uint32_t> patches_;
    double extent_;
    std::vector<std::uint32_t> first_at_, triangles_at_;
    std::unique_ptr<rays::Scene, Release> scene_;
};

} // namespace lineatlas
