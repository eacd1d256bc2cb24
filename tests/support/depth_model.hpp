#pragma once

#include <vector>

#include "compute/stages/stages.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::test {

/// The part of a depth buffer that kernels are to draw.
struct DepthWanted {
    glm::mat4 clip_from_world{1};
    glm::ivec2 whole_size{0, 0}; ///< texels
    TexelRectangle part;         ///< in texels of the whole
    bool numbered = false;       ///< also draws the number of the triangle in each texel
    bool texels = true;          ///< draws the depth itself
};

/// The result of `depth`.
struct DrawnDepth {
    std::vector<float> texels, tiles;
    std::vector<std::uint32_t> seen;    ///< per cluster
    std::vector<std::uint32_t> numbers; ///< per texel, of the line set's triangles; if wanted
};

/// Triangles on a device as `depth` draws them.
class DepthModel {
  public:
    /// `cluster_size`: triangles, at most.
    DepthModel(compute::Device& device, const std::vector<glm::vec3>& vertices,
               const std::vector<glm::uvec3>& triangles, std::uint32_t cluster_size);

    std::size_t clusters() const { return count_; }
    /// Draws into memory that held something else.
    DrawnDepth draw(compute::Stages& stages, const DepthWanted& wanted);
    /// The same into the given images. `blank` says which of their parts are known to be blank.
    void draw_into(compute::Stages& stages, const DepthWanted& wanted, compute::Buffer& depth,
                   compute::Buffer& numbers, compute::Buffer& blank);
    /// Draws the whole of a buffer.
    DrawnDepth draw(compute::Stages& stages, const glm::mat4& clip_from_world, glm::ivec2 size) {
        return draw(stages, {clip_from_world, size, {{0, 0}, size}});
    }

  private:
    compute::DepthArgs args(const DepthWanted& wanted, compute::Buffer& depth,
                            compute::Buffer& tiles, compute::Buffer& seen) const;

    compute::Device& device_;
    std::uint32_t count_;
    /// Places in the line set of the triangles that `depth` numbers.
    std::vector<std::uint32_t> order_;
    std::unique_ptr<compute::Buffer> vertices_, clusters_, meshlets_, vertex_list_, corners_;
};

} // namespace lineatlas::test
