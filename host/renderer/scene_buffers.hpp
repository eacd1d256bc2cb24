#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "compute/backend.hpp"
#include "glpasses/depth_pass.hpp"
#include "glpasses/fill_pass.hpp"
#include "glpasses/line_pass.hpp"
#include "glpasses/objects.hpp"
#include "glpasses/spine_pass.hpp"
#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// A line set on the device: what is uploaded once and read in every frame, by kernels and by GL
/// passes.
class SceneBuffers {
  public:
    /// Throws DeviceError when memory runs out.
    SceneBuffers(compute::Backend& backend, const LineSet& lines);

    /// What compute stages read.
    struct Tables {
        std::unique_ptr<compute::Buffer> vertices, triangles, segments, clusters;
    };
    /// The same on another backend, from the memory of this one.
    Tables copy_tables(compute::Backend& backend);
    /// From now on these.
    void use(compute::Backend& backend, Tables tables) noexcept {
        backend_ = &backend;
        tables_ = std::move(tables);
    }

    compute::SegmentTable table() const {
        return {*tables_.vertices, *tables_.triangles, *tables_.segments, triangle_count_,
                segment_count_};
    }
    /// For drawing: the triangles in an order of their own.
    gl::TriangleBuffers gl_triangles() const {
        return {gl_vertices_.id(), gl_indices_.id(), triangle_count_};
    }
    /// In the order of gl_triangles().
    const gl::TriangleColors& gl_colors() const { return colors_; }
    gl::SegmentBuffers gl_segments();
    /// The fixed lines among `kinds` as pairs of vertices.
    gl::LineBuffers gl_lines(LineKindMask kinds);
    /// Pieces of gl_triangles(); none for a small model, which is not worth cutting up.
    std::span<const Cluster> clusters() const { return clusters_; }
    compute::Buffer& cluster_buffer() const { return *tables_.clusters; }
    const Bounds& bounds() const { return bounds_; }
    float diagonal() const { return glm::distance(bounds_.min, bounds_.max); }
    /// How far points of the model move on the screen between two cameras: the median, in pixels;
    /// infinite if none can be seen in both.
    float typical_motion(const Camera& from, const Camera& to) const;
    std::uint32_t triangle_count() const { return triangle_count_; }
    std::uint32_t segment_count() const { return segment_count_; }
    std::uint64_t mesh_bytes() const {
        return tables_.vertices->size() + tables_.triangles->size();
    }
    std::uint64_t segment_bytes() const { return tables_.segments->size(); }

  private:
    /// `order`: where each of gl_triangles() stands among the line set's; empty: there too.
    void upload_colors(const LineSet& lines, std::span<const std::uint32_t> order);
    template <class T>
    std::vector<T> download(compute::Buffer& buffer, std::size_t count);
    std::vector<Segment> download_segments();

    compute::Backend* backend_;
    Tables tables_;
    Bounds bounds_;
    std::vector<glm::vec3> landmarks_; ///< some of the vertices
    std::vector<Cluster> clusters_;
    gl::Buffer gl_vertices_, gl_indices_;
    gl::Buffer gl_color_indices_, gl_colors_; ///< empty for a model without colours
    gl::TriangleColors colors_;
    // What only the methods besides the atlas need; made when first asked for.
    gl::Buffer gl_segments_, gl_table_triangles_, gl_lines_;
    LineKindMask line_kinds_ = 0; ///< that `gl_lines_` holds
    std::uint32_t line_count_ = 0;
    std::uint32_t triangle_count_;
    std::uint32_t segment_count_;
};

} // namespace lineatlas
