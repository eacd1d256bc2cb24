#include "moving_tables.hpp"

#include <algorithm>
#include <cstddef>

#include <glm/vec3.hpp>

#include "core/objects.hpp"

namespace lineatlas {
namespace {

constexpr std::size_t matrix_floats = 12, turn_floats = 9;

/// Appends three rows of `columns` numbers.
template <int columns, class Matrix>
void add_rows(std::vector<float>& rows, const Matrix& matrix) {
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < columns; ++column) rows.push_back(matrix[column][row]);
}

std::vector<std::uint32_t> object_of_vertices(const SceneMotion& motion) {
    std::vector<std::uint32_t> result(motion.vertex_count());
    for (std::size_t i = 0; i < motion.objects().size(); ++i) {
        const LineObject& object = motion.objects()[i];
        std::ranges::fill(std::span{result}.subspan(object.first_vertex, object.vertex_count),
                          static_cast<std::uint32_t>(i));
    }
    return result;
}

} // namespace

MovingTables::MovingTables(compute::Stages& stages, const LineTables& lines,
                           const SceneMotion& motion,
                           std::span<const std::uint32_t> cluster_objects, std::size_t object_room)
    : stages_(stages), device_(stages.device()), vertex_count_(motion.vertex_count()),
      cluster_count_(static_cast<std::uint32_t>(cluster_objects.size())),
      corner_count_(lines.contour_chunk().corner_count()),
      objects_(compute::upload(device_, object_of_vertices(motion), compute::table::objects)),
      cluster_objects_(compute::upload(device_, cluster_objects, compute::table::cluster_objects)),
      vertices_(compute::allocate(device_, vertex_count_ * sizeof(glm::vec3),
                                  compute::table::moved_vertices)),
      clusters_(compute::allocate(device_, cluster_count_ * sizeof(Cluster),
                                  compute::table::moved_clusters)) {
    object_room = std::max(object_room, motion.objects().size());
    matrices_ = compute::allocate(device_, object_room * matrix_floats * sizeof(float),
                                  compute::table::matrices);
    jumped_ = compute::allocate(device_, object_room, compute::table::jumped);
    if (corner_count_ == 0) return;
    turns_ = compute::allocate(device_, object_room * turn_floats * sizeof(float),
                               compute::table::turns);
    corners_ = compute::allocate(device_, corner_count_ * sizeof(ContourCorner),
                                 compute::table::turned_corners);
}

void MovingTables::set_object(std::uint32_t object, std::uint32_t first_vertex,
                              std::uint32_t vertices, std::uint32_t first_cluster,
                              std::uint32_t clusters) {
    const std::vector<std::uint32_t> numbers(std::max(vertices, clusters), object);
    const auto bytes = std::as_bytes(std::span{numbers});
    constexpr std::size_t size = sizeof(std::uint32_t);
    device_.upload(*objects_, bytes.first(vertices * size), first_vertex * size);
    device_.upload(*cluster_objects_, bytes.first(clusters * size), first_cluster * size);
}

void MovingTables::place(std::span<const glm::mat4> world_from_object) {
    rows_.clear();
    for (const glm::mat4& m : world_from_object) add_rows<4>(rows_, m);
    device_.upload(*matrices_, std::as_bytes(std::span{rows_}));
    if (!turns_) return;
    rows_.clear();
    for (const glm::mat4& m : world_from_object) add_rows<3>(rows_, normal_turn(m));
    device_.upload(*turns_, std::as_bytes(std::span{rows_}));
}

void MovingTables::move(LineTables& lines, const SceneMotion& motion, ContourNormals& normals,
                        compute::Buffer* clusters, compute::Buffer* drawn) {
    place(motion.transforms());
    normals.find(stages_, lines);
    if (drawn == nullptr) {
        unread_.fit(vertex_count_ * sizeof(glm::vec3));
        drawn = unread_.get();
    }
    stages_.launch_each<compute::kernels::transform>(vertex_count_, {.rest = *lines.vertices,
                                                                     .objects = *objects_,
                                                                     .matrices = *matrices_,
                                                                     .vertices = *vertices_,
                                                                     .drawn = *drawn});
    if (clusters != nullptr) {
        stages_.launch_each<compute::kernels::transform_boxes>(cluster_count_,
                                                               {.rest = *clusters,
                                                                .objects = *cluster_objects_,
                                                                .matrices = *matrices_,
                                                                .clusters = *clusters_});
    }
    if (turns_) {
        stages_.launch_each<compute::kernels::contour_turn>(corner_count_,
                                                            {.rest = *lines.contour_chunk().corners,
                                                             .objects = *objects_,
                                                             .turns = *turns_,
                                                             .corners = *corners_});
    }
    ++lines.version;
}

void MovingTables::forget(const compute::SegmentTable& table, std::span<const std::uint8_t> jumped,
                          compute::Buffer& ranges) {
    device_.upload(*jumped_, std::as_bytes(jumped));
    stages_.launch_each<compute::kernels::transform_forget>(
        table.segment_count,
        {.segments = table.segments, .objects = *objects_, .jumped = *jumped_, .ranges = ranges});
}

} // namespace lineatlas
