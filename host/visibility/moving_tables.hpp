#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "compute/stages/stages.hpp"
#include "contour_normals.hpp"
#include "line_tables.hpp"
#include "scene_motion.hpp"

namespace lineatlas {

/// The tables on the device of a model that moves, in addition to the model as it was made: the
/// present places of its vertices.
class MovingTables {
  public:
    /// `cluster_objects`: per cluster; none if nobody asks for clusters. `object_room`: room for so
    /// many objects, if the model may get more. Throws DeviceError when memory runs out.
    MovingTables(compute::Stages& stages, const LineTables& lines, const SceneMotion& motion,
                 std::span<const std::uint32_t> cluster_objects = {}, std::size_t object_room = 0);

    /// Gives ranges of vertices and clusters to an object.
    void set_object(std::uint32_t object, std::uint32_t first_vertex, std::uint32_t vertices,
                    std::uint32_t first_cluster, std::uint32_t clusters);

    /// Moves the model, whose tables `lines` are, with the `normals` of its contours. Writes
    /// tables, so it waits for kernels that were launched before. `clusters`: of the model as it
    /// was made; null if nobody asks for them. `drawn`: gets the vertices too, for GL, which reads
    /// them while kernels do; null: GL reads none.
    void move(LineTables& lines, const SceneMotion& motion, ContourNormals& normals,
              compute::Buffer* clusters = nullptr, compute::Buffer* drawn = nullptr);
    /// Empties the `ranges` of `temporal` for segments of objects with a 1 in `jumped`.
    void forget(const compute::SegmentTable& table, std::span<const std::uint8_t> jumped,
                compute::Buffer& ranges);

    compute::Buffer& vertices() const { return *vertices_; }
    compute::Buffer& clusters() const { return *clusters_; }
    compute::Buffer* corners() const { return corners_.get(); } ///< null if there are none

  private:
    /// Sets where objects move to.
    void place(std::span<const glm::mat4> world_from_object);

    compute::Stages& stages_;
    compute::Device& device_; ///< of stages_
    std::uint32_t vertex_count_, cluster_count_, corner_count_;
    std::unique_ptr<compute::Buffer> objects_, cluster_objects_, matrices_, jumped_;
    std::unique_ptr<compute::Buffer> vertices_, clusters_;
    std::unique_ptr<compute::Buffer> turns_, corners_; ///< null without contours
    compute::Table unread_{
        device_, compute::table::drawn_vertices}; ///< used if nobody asks for vertices for GL
    std::vector<float> rows_;                     ///< rows of matrices, kept for its memory
};

} // namespace lineatlas
