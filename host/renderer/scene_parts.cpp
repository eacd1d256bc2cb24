// The parts of an assembly among the tables of a scene: each has rooms of its own in all of them.

#include <algorithm>
#include <span>

#include <glm/geometric.hpp>

#include "core/part_clusters.hpp"
#include "core/patches.hpp"
#include "scene_buffers.hpp"

namespace lineatlas {
namespace {

template <class Values>
void upload_at(compute::Device& device, compute::Buffer& buffer, std::size_t first,
               const Values& values) {
    const auto bytes = std::as_bytes(std::span{values});
    if (!bytes.empty()) device.upload(buffer, bytes, first * sizeof(values[0]));
}

template <class T>
std::span<const T> in(const std::vector<T>& table, std::uint32_t first, std::uint32_t count) {
    return std::span{table}.subspan(first, count);
}

/// Where the candidates of a part that are edges meet each other, in the form of LineTables::Chunk.
/// Lists of the part's rooms begin at twice its first candidate. There is one more vertex than the
/// part has.
EdgeEnds ends_of(const PartRooms& rooms, const LineSet& part) {
    const Contours& contours = part.contours;
    const std::span kept = std::span{part.segments}.first(part.segments.size() - contours.replaced -
                                                          contours.faces.size());
    const auto is_candidate = [](const Segment& segment) {
        return (segment.tag & LA_TAG_KIND_MASK) == LA_KIND_SILHOUETTE;
    };
    const std::span edges{std::ranges::find_if(kept, is_candidate), kept.end()};
    EdgeEnds result = ends_by_vertex(edges, rooms.vertices.size);
    const std::uint32_t first = 2 * rooms.candidates.first;
    for (std::uint32_t& offset : result.offsets) offset += first;
    for (std::uint32_t& end : result.ends) end += first;
    result.ends.resize(2 * std::size_t{rooms.candidates.size}, 0);
    return result;
}

} // namespace

/// Whether all segments of the parts are in one table, also those for contours.
bool SceneBuffers::has_rooms_of(const AssemblyState& parts) const {
    return tables_.chunks.size() == 1 && segment_count() == parts.lines.segments.size();
}

void SceneBuffers::follow(const AssemblyState& parts) {
    if (!has_rooms_of(parts)) return; // then tables are made anew for every change
    followed_ = {parts.layout, parts.changes.size(), parts.object_room};
    std::vector<std::uint32_t> offsets(parts.lines.vertices.size() + 1, 0);
    std::vector<std::uint32_t> ends(2 * std::size_t{parts.first_replaced - parts.first_candidate},
                                    0);
    for (std::uint32_t i = 0; i < parts.parts.size(); ++i) {
        if (!parts.parts[i].is_there) continue;
        const PartRooms& rooms = parts.parts[i].rooms;
        const EdgeEnds own = ends_of(rooms, part_lines(parts, i));
        std::ranges::copy(own.offsets, offsets.begin() + rooms.vertices.first);
        std::ranges::copy(own.ends, ends.begin() + 2 * rooms.candidates.first);
    }
    LineTables::Chunk& chunk = tables_.chunks.front();
    chunk.end_offsets = compute::upload(device(), offsets, compute::table::end_offsets);
    chunk.ends = compute::upload(device(), ends, compute::table::ends);
    start_moving(make_moving(*stages_, *sharing_)); // GL too reads a part's places from the device
}

bool SceneBuffers::update_parts(const AssemblyState& parts) {
    if (!followed_ || followed_->layout != parts.layout || !has_rooms_of(parts)) return false;
    normals_.find(*stages_, tables_);
    for (; followed_->changes < parts.changes.size(); ++followed_->changes)
        update_part(parts, parts.changes[followed_->changes]);
    diagonal_ = glm::distance(parts.lines.bounds.min, parts.lines.bounds.max);
    upload_colors(parts.lines);
    // What only other methods need is made anew when they ask for it.
    for (gl::Buffer* buffer : {&gl_segments_, &gl_table_triangles_, &gl_lines_, &gl_numbers_,
                               &gl_patches_, &gl_smooth_corners_, &gl_normals_})
        *buffer = {};
    tables_.smooth_corners.reset();
    normals_.forget(); // as soon as positions change again
    moved_ = true;
    return true;
}

void SceneBuffers::update_part(const AssemblyState& parts, const AssemblyState::Change& change) {
    const auto [object, rooms] = change;
    const AssemblyState::Part& own = parts.parts[object];
    const bool is_here = own.is_there && own.rooms == rooms;
    const LineSet part = is_here ? part_lines(parts, object) : LineSet{};
    upload_part_lines(parts, rooms);
    upload_part_ends(rooms, part);
    upload_part_contours(parts.lines.contours, rooms, part);
    upload_part_triangles(object, rooms, part);
    upload_part_surfaces(rooms, part);
    tables_.moving->set_object(object, rooms.vertices.first, rooms.vertices.size,
                               rooms.clusters.first, rooms.clusters.size);
    motion_.set_object(object, parts.lines, own.box);
}

void SceneBuffers::upload_part_lines(const AssemblyState& parts, const PartRooms& rooms) {
    const LineSet& lines = parts.lines;
    upload_at(device(), *tables_.vertices, rooms.vertices.first,
              in(lines.vertices, rooms.vertices.first, rooms.vertices.size));
    upload_at(device(), *tables_.triangles, rooms.triangles.first,
              in(lines.triangles, rooms.triangles.first, rooms.triangles.size));
    for (const PartRoom& room : segment_rooms(parts, rooms)) {
        upload_at(device(), *tables_.chunks.front().segments, room.first,
                  in(lines.segments, room.first, room.size));
        classes_.update(lines, room.first, room.size);
    }
}

void SceneBuffers::upload_part_ends(const PartRooms& rooms, const LineSet& part) {
    const EdgeEnds own = ends_of(rooms, part);
    const LineTables::Chunk& chunk = tables_.chunks.front();
    upload_at(device(), *chunk.end_offsets, rooms.vertices.first, own.offsets);
    upload_at(device(), *chunk.ends, 2 * std::size_t{rooms.candidates.first}, own.ends);
}

void SceneBuffers::upload_part_contours(const Contours& all, const PartRooms& rooms,
                                        const LineSet& part) {
    const LineTables::Chunk& chunk = tables_.chunks.front();
    if (!chunk.faces) return;
    std::vector<compute::ContourEdge> edges = contour_edges(part.contours, part.segments);
    for (compute::ContourEdge& edge : edges) {
        for (la_uint* face : {&edge.face_a, &edge.face_b})
            if (*face != LA_NO_FACE) *face += rooms.triangles.first;
    }
    edges.resize(rooms.edges.size, {.face_a = 0, .face_b = LA_NO_FACE});
    std::vector<glm::uvec3> corners = contour_corners(part.contours);
    for (glm::uvec3& face : corners) face += rooms.corners.first;
    std::vector<compute::ContourFace> faces = contour_faces(part.contours);
    for (compute::ContourFace& face : faces) {
        for (la_uint& edge : face.edges) edge += rooms.edges.first;
        for (la_uint& across : face.across)
            if (across != LA_NO_FACE) across += rooms.faces.first;
    }
    // Room beyond the part's faces holds faces with three equal corners, which no contour crosses.
    corners.resize(rooms.faces.size, glm::uvec3{0});
    faces.resize(rooms.faces.size, {});
    std::vector<std::uint32_t> patches = contour_patches(part, part.segments);
    for (std::uint32_t& patch : patches)
        if (patch != LA_NO_SURFACE) patch += rooms.edges.first;
    patches.resize(rooms.triangles.size, LA_NO_SURFACE);
    upload_at(device(), *chunk.corners, rooms.corners.first,
              in(all.corners, rooms.corners.first, rooms.corners.size));
    upload_at(device(), *chunk.edges, rooms.edges.first, edges);
    upload_at(device(), *chunk.face_corners, rooms.faces.first, corners);
    upload_at(device(), *chunk.faces, rooms.faces.first, faces);
    upload_at(device(), *chunk.patches, rooms.triangles.first, patches);
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
    if (gl_indices_) {
        constexpr std::size_t size = sizeof(glm::uvec3);
        glNamedBufferSubData(gl_indices_.id(), static_cast<GLintptr>(rooms.triangles.first * size),
                             static_cast<GLsizeiptr>(own.triangles.size() * size),
                             own.triangles.data());
    }
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
