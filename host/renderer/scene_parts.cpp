// The parts of an assembly among the tables of a scene: each has rooms of its own in all of them.

#include <algorithm>
#include <numeric>
#include <span>

#include <glm/geometric.hpp>

#include "core/part_clusters.hpp"
#include "core/patches.hpp"
#include "scene_buffers.hpp"

namespace lineatlas {
namespace {

template <class T>
void upload_at(compute::Device& device, compute::Buffer& buffer, std::size_t first,
               std::span<const T> values) {
    if (!values.empty()) device.upload(buffer, std::as_bytes(values), first * sizeof(T));
}
template <class T>
void upload_at(compute::Device& device, compute::Buffer& buffer, std::size_t first,
               const std::vector<T>& values) {
    upload_at(device, buffer, first, std::span<const T>{values});
}

template <class T>
std::span<const T> in(const std::vector<T>& table, std::uint32_t first, std::uint32_t count) {
    return std::span{table}.subspan(first, count);
}

/// Where candidates meet, with the part's lists in its own room. See LineTables::Chunk.
struct Ends {
    std::vector<std::uint32_t> offsets, ends;
};

Ends ends_of(const PartRooms& rooms, const LineSet& part) {
    const auto first = std::ranges::find_if(part.segments, [](const Segment& segment) {
        return (segment.tag & LA_TAG_KIND_MASK) == LA_KIND_SILHOUETTE;
    });
    const std::span<const Segment> candidates{first, part.segments.end()};
    Ends result{.offsets = std::vector<std::uint32_t>(rooms.vertices.size, 0),
                .ends = std::vector<std::uint32_t>(2 * std::size_t{rooms.candidates.size}, 0)};
    for (const Segment& segment : candidates) {
        ++result.offsets[segment.p + 1]; // there is one vertex more
        ++result.offsets[segment.q + 1];
    }
    std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
    std::vector<std::uint32_t> next = result.offsets;
    std::uint32_t end = 2 * rooms.candidates.first;
    for (const Segment& segment : candidates) {
        result.ends[next[segment.p]++] = end++;
        result.ends[next[segment.q]++] = end++;
    }
    for (std::uint32_t& offset : result.offsets) offset += 2 * rooms.candidates.first;
    return result;
}

} // namespace

void SceneBuffers::follow(const AssemblyState& parts) {
    if (tables_.chunks.size() > 1) return; // then they are made anew for every change
    followed_ = {parts.layout, parts.changes.size(), parts.object_room, parts.first_candidate};
    std::vector<std::uint32_t> offsets(parts.lines.vertices.size() + 1, 0);
    std::vector<std::uint32_t> ends(
        2 * (parts.lines.segments.size() - std::size_t{parts.first_candidate}), 0);
    for (std::uint32_t i = 0; i < parts.parts.size(); ++i) {
        if (!parts.parts[i].is_there) continue;
        const PartRooms& rooms = parts.parts[i].rooms;
        const Ends own = ends_of(rooms, part_lines(parts, i));
        std::ranges::copy(own.offsets, offsets.begin() + rooms.vertices.first);
        std::ranges::copy(own.ends, ends.begin() + 2 * std::ptrdiff_t{rooms.candidates.first});
    }
    LineTables::Chunk& chunk = tables_.chunks.front();
    chunk.end_offsets = upload(device(), std::as_bytes(std::span{offsets}), purpose::segments);
    chunk.ends = upload(device(), std::as_bytes(std::span{ends}), purpose::segments);
    start_moving(make_moving(*stages_, mode_)); // in GL, too, a part is where the device puts it
}

bool SceneBuffers::update_parts(const AssemblyState& parts) {
    if (!followed_ || followed_->layout != parts.layout || tables_.chunks.size() > 1) return false;
    for (; followed_->changes < parts.changes.size(); ++followed_->changes)
        update_part(parts, parts.changes[followed_->changes]);
    diagonal_ = glm::distance(parts.lines.bounds.min, parts.lines.bounds.max);
    upload_colors(parts.lines);
    // What only other methods need is made anew when they ask for it.
    for (gl::Buffer* buffer :
         {&gl_segments_, &gl_table_triangles_, &gl_lines_, &gl_numbers_, &gl_patches_})
        *buffer = {};
    moved_ = true;
    return true;
}

void SceneBuffers::update_part(const AssemblyState& parts, const AssemblyState::Change& change) {
    const auto [object, rooms] = change;
    const AssemblyState::Part& own = parts.parts[object];
    const bool is_here = own.is_there && own.rooms == rooms;
    const LineSet part = is_here ? part_lines(parts, object) : LineSet{};
    upload_part_lines(parts.lines, rooms);
    upload_part_ends(rooms, part);
    upload_part_triangles(object, rooms, part);
    upload_part_surfaces(rooms, part);
    tables_.moving->set_object(object, rooms.vertices.first, rooms.vertices.size,
                               rooms.clusters.first, rooms.clusters.size);
    motion_.set_object(object, parts.lines, own.box);
}

void SceneBuffers::upload_part_lines(const LineSet& lines, const PartRooms& rooms) {
    upload_at(device(), *tables_.vertices, rooms.vertices.first,
              in(lines.vertices, rooms.vertices.first, rooms.vertices.size));
    upload_at(device(), *tables_.triangles, rooms.triangles.first,
              in(lines.triangles, rooms.triangles.first, rooms.triangles.size));
    for (const auto& [first, count] :
         {std::pair{rooms.fixed.first, rooms.fixed.size},
          std::pair{followed_->first_candidate + rooms.candidates.first, rooms.candidates.size}}) {
        upload_at(device(), *tables_.chunks.front().segments, first,
                  in(lines.segments, first, count));
        classes_.update(lines, first, count);
    }
}

void SceneBuffers::upload_part_ends(const PartRooms& rooms, const LineSet& part) {
    const Ends own = ends_of(rooms, part);
    const LineTables::Chunk& chunk = tables_.chunks.front();
    upload_at(device(), *chunk.end_offsets, rooms.vertices.first, own.offsets);
    upload_at(device(), *chunk.ends, 2 * std::size_t{rooms.candidates.first}, own.ends);
}

void SceneBuffers::upload_part_triangles(std::uint32_t object, const PartRooms& rooms,
                                         const LineSet& part) {
    const TriangleClusters own = part_clusters(object, rooms, part);
    std::ranges::copy(own.order, triangle_order_.begin() + rooms.triangles.first);
    std::ranges::copy(own.clusters, clusters_.begin() + rooms.clusters.first);
    std::ranges::copy(own.objects, cluster_objects_.begin() + rooms.clusters.first);
    upload_at(device(), *tables_.clusters, rooms.clusters.first, own.clusters);
    if (tables_.cluster_triangles)
        upload_at(device(), *tables_.cluster_triangles, rooms.triangles.first, own.triangles);
    constexpr std::size_t size = sizeof(glm::uvec3);
    glNamedBufferSubData(gl_indices_.id(), static_cast<GLintptr>(rooms.triangles.first * size),
                         static_cast<GLsizeiptr>(own.triangles.size() * size),
                         own.triangles.data());
    if (!tables_.meshlets) return;
    const Meshlets meshlets = part_meshlets(rooms, own);
    const std::size_t first = rooms.clusters.first;
    upload_at(device(), *tables_.meshlets, first, meshlets.meshlets);
    upload_at(device(), *tables_.vertex_list, first * LA_MESHLET_VERTICES, meshlets.vertices);
    upload_at(device(), *tables_.corners, first * LA_MESHLET_VERTICES, meshlets.corners);
}

void SceneBuffers::upload_part_surfaces(const PartRooms& rooms, const LineSet& part) {
    if (!tables_.numbers) return;
    const std::uint32_t first = rooms.triangles.first;
    const std::vector<std::uint32_t> of_triangles = smooth_patches(part);
    std::vector<std::uint32_t> numbers(rooms.triangles.size), patches(rooms.triangles.size);
    for (std::uint32_t i = 0; i < of_triangles.size(); ++i) {
        const std::uint32_t place = triangle_order_[first + i] - first;
        numbers[place] = first + i;
        patches[i] = first + of_triangles[place];
    }
    upload_at(device(), *tables_.numbers, first, numbers);
    upload_at(device(), *tables_.patches, first, patches);
}

} // namespace lineatlas
