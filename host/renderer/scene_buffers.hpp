#pragma once

#include <cstdint>
#include <memory>

#include "compute/backend.hpp"
#include "glpasses/depth_pass.hpp"
#include "glpasses/objects.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// A line set on the device: what is uploaded once and read in every frame, by kernels and by GL passes.
class SceneBuffers {
  public:
    /// Throws DeviceError when memory runs out.
    SceneBuffers(compute::Backend& backend, const LineSet& lines);

    compute::SegmentTable table() const {
        return {*vertices_, *triangles_, *segments_, triangle_count_, segment_count_};
    }
    gl::TriangleBuffers gl_triangles() const {
        return {gl_vertices_.id(), gl_indices_.id(), triangle_count_};
    }
    std::uint32_t triangle_count() const { return triangle_count_; }
    std::uint32_t segment_count() const { return segment_count_; }
    std::uint64_t device_bytes() const {
        return vertices_->size() + triangles_->size() + segments_->size();
    }

  private:
    std::unique_ptr<compute::Buffer> vertices_, triangles_, segments_;
    gl::Buffer gl_vertices_, gl_indices_;
    std::uint32_t triangle_count_;
    std::uint32_t segment_count_;
};

} // namespace lineatlas
