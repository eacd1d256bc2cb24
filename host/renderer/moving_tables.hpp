#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "compute/stages/stages.hpp"
#include "glpasses/interop/shared_table.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas {

/// What the device has of a model that moves, beside the model as it was made: where its vertices
/// are now. Kernels and GL read them at the same time, so each has its own.
class MovingTables {
  public:
    struct Shape {
        std::uint32_t vertex_count;
        std::span<const LineObject> objects;
        std::size_t object_room;                        ///< at least as many
        std::span<const std::uint32_t> cluster_objects; ///< per cluster
        std::uint32_t corner_count = 0;                 ///< of contours
    };
    /// Throws DeviceError when memory runs out.
    MovingTables(compute::Stages& stages, interop::Sharing& sharing, const Shape& shape);

    /// Vertices and clusters from these on are of that object.
    void set_object(std::uint32_t object, std::uint32_t first_vertex, std::uint32_t vertices,
                    std::uint32_t first_cluster, std::uint32_t clusters);

    /// Where transform() moves objects to. Writes tables, and so waits for kernels that were
    /// launched before.
    void place(std::span<const glm::mat4> world_from_object);
    /// What is moved: as the model was made.
    struct Rest {
        compute::Buffer& vertices;
        compute::Buffer& clusters;
        compute::Buffer* corners; ///< of contours; null if there are none
    };
    void transform(const Rest& rest);
    /// Empties the `ranges` of `temporal` for segments of objects with a 1 in `jumped`.
    void forget(const compute::SegmentTable& table, std::span<const std::uint8_t> jumped,
                compute::Buffer& ranges);

    compute::Buffer& vertices() const { return *vertices_; }
    GLuint gl_vertices() { return drawn_.gl(); }
    compute::Buffer& clusters() const { return *clusters_; }
    compute::Buffer* corners() const { return corners_.get(); } ///< null if there are none
    std::uint64_t bytes() const;

  private:
    compute::Stages& stages_;
    compute::Device& device_; ///< of stages_
    std::uint32_t vertex_count_, cluster_count_, corner_count_;
    std::unique_ptr<compute::Buffer> objects_, cluster_objects_, matrices_, jumped_;
    std::unique_ptr<compute::Buffer> vertices_, clusters_;
    std::unique_ptr<compute::Buffer> turns_, corners_; ///< where there are contours
    interop::SharedTable drawn_;
    std::vector<float> rows_; ///< of matrices, kept for its memory
};

} // namespace lineatlas
