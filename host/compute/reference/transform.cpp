#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "stages.hpp"

namespace lineatlas::compute::reference {
namespace {

using Row = std::span<const float, 4>;

Row row_of(std::span<const float> matrices, std::uint32_t object, std::size_t axis) {
    return Row{matrices.subspan(12 * std::size_t{object} + 4 * axis, 4)};
}

float moved(Row row, glm::vec3 v) {
    return (row[0] * v.x + row[1] * v.y) + (row[2] * v.z + row[3]);
}

/// How far the moved box reaches from its moved middle; see transform.cl.
float reach_of(Row row, glm::vec3 middle, glm::vec3 half_size) {
    const float reach = (std::fabs(row[0]) * half_size.x + std::fabs(row[1]) * half_size.y) +
                        std::fabs(row[2]) * half_size.z;
    const float size = (std::fabs(row[0] * middle.x) + std::fabs(row[1] * middle.y)) +
                       (std::fabs(row[2] * middle.z) + std::fabs(row[3]));
    return reach + LA_BOX_ROUNDING * (reach + size);
}

} // namespace

void transform(std::span<const glm::vec3> rest, std::span<const std::uint32_t> objects,
               std::span<const float> matrices, std::span<glm::vec3> vertices) {
    for (std::size_t i = 0; i < rest.size(); ++i) {
        vertices[i] = {moved(row_of(matrices, objects[i], 0), rest[i]),
                       moved(row_of(matrices, objects[i], 1), rest[i]),
                       moved(row_of(matrices, objects[i], 2), rest[i])};
    }
}

void transform_boxes(std::span<const Cluster> rest, std::span<const std::uint32_t> objects,
                     std::span<const float> matrices, std::span<Cluster> clusters) {
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const glm::vec3 low{rest[i].low[0], rest[i].low[1], rest[i].low[2]};
        const glm::vec3 high{rest[i].high[0], rest[i].high[1], rest[i].high[2]};
        const glm::vec3 middle = (low + high) * 0.5F, half_size = (high - low) * 0.5F;
        clusters[i] = rest[i];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Row row = row_of(matrices, objects[i], axis);
            const float at = moved(row, middle);
            const float reach = reach_of(row, middle, half_size);
            clusters[i].low[axis] = at - reach;
            clusters[i].high[axis] = at + reach;
        }
    }
}

void transform_bounds(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> triangles,
                      std::span<Cluster> clusters) {
    for (Cluster& cluster : clusters) {
        glm::vec3 low{std::numeric_limits<float>::infinity()}, high = -low;
        for (const std::uint32_t vertex :
             triangles.subspan(3 * std::size_t{cluster.first}, 3 * std::size_t{cluster.count})) {
            low = glm::min(low, vertices[vertex]);
            high = glm::max(high, vertices[vertex]);
        }
        for (int axis = 0; axis < 3; ++axis) {
            cluster.low[axis] = low[axis];
            cluster.high[axis] = high[axis];
        }
    }
}

void transform_forget(std::span<const Segment> segments, std::span<const std::uint32_t> objects,
                      std::span<const std::uint8_t> jumped, std::span<std::uint32_t> ranges) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (jumped[objects[segments[i].p]] != 0) ranges[i] = 0;
    }
}

} // namespace lineatlas::compute::reference
