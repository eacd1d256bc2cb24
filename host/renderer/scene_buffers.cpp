#include "scene_buffers.hpp"

#include <algorithm>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_precision.hpp>

#include "compute/transfer.hpp"
#include "core/clusters.hpp"
#include "core/contact.hpp"
#include "core/meshlets.hpp"
#include "core/part_clusters.hpp"
#include "core/patches.hpp"
#include "glpasses/storage.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

// With fewer triangles a depth pass costs less than finding which clusters to leave out of it.
constexpr std::uint32_t fewest_triangles_culled = 50'000;
constexpr std::uint32_t cluster_size = LA_MESHLET_TRIANGLES;

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
    return std::as_bytes(std::span{values});
}

gl::Buffer upload_gl(std::span<const std::byte> data, const Purpose& purpose,
                     GLbitfield flags = 0) {
    gl::Buffer buffer = gl::Buffer::create();
    const std::byte nothing{};
    gl::allocate(buffer, std::max<std::size_t>(data.size(), 1),
                 data.empty() ? &nothing : data.data(), flags, purpose);
    return buffer;
}

/// A buffer of GL with the first `count` values of a table. Waits for the device.
template <class T>
gl::Buffer copy_to_gl(compute::Device& device, compute::Buffer& table, std::size_t count,
                      const Purpose& purpose) {
    return upload_gl(bytes_of(compute::read_back<T>(device, table, count)), purpose);
}

} // namespace

SceneBuffers::SceneBuffers(compute::Stages& stages, interop::Sharing& sharing, const LineSet& lines,
                           const AssemblyState* parts)
    : stages_(&stages), sharing_(&sharing), tables_{upload_lines(stages.device(), lines), nullptr},
      motion_(lines), classes_(line_classes(lines)),
      diagonal_(glm::distance(lines.bounds.min, lines.bounds.max)), contact_(contact_of(lines)),
      triangle_count_(static_cast<std::uint32_t>(lines.triangles.size())) {
    TriangleClusters made = parts != nullptr ? all_part_clusters(*parts)
                                             : build_clusters(lines.vertices, lines.triangles,
                                                              cluster_size, lines.objects);
    clusters_ = std::move(made.clusters);
    cluster_objects_ = std::move(made.objects);
    triangle_order_ = std::move(made.order);
    upload_colors(lines);
    tables_.clusters = compute::upload(device(), clusters_, compute::table::clusters);
    if (parts != nullptr) follow(*parts);
}

bool SceneBuffers::is_cut_up() const {
    return triangle_count_ >= fewest_triangles_culled;
}

std::vector<glm::uvec3> SceneBuffers::ordered_triangles() {
    return in_order(compute::read_back<glm::uvec3>(device(), *tables_.triangles, triangle_count_));
}

std::vector<glm::uvec3> SceneBuffers::in_order(const std::vector<glm::uvec3>& of_triangles) const {
    std::vector<glm::uvec3> ordered(triangle_count_);
    std::ranges::transform(triangle_order_, ordered.begin(),
                           [&](std::uint32_t place) { return of_triangles[place]; });
    return ordered;
}

GLuint SceneBuffers::gl_vertices() {
    if (tables_.moving) return tables_.moving->drawn.gl();
    if (!gl_vertices_)
        gl_vertices_ = copy_to_gl<glm::vec3>(device(), *tables_.vertices, motion_.vertex_count(),
                                             purpose::model);
    return gl_vertices_.id();
}

gl::TriangleBuffers SceneBuffers::gl_triangles() {
    if (!gl_indices_) {
        gl_indices_ = upload_gl(bytes_of(ordered_triangles()), purpose::model,
                                followed_ ? GL_DYNAMIC_STORAGE_BIT : 0);
    }
    return {gl_vertices(), gl_indices_.id(), triangle_count_};
}

compute::MeshletTables SceneBuffers::meshlets() {
    if (!tables_.meshlets) {
        Meshlets built = build_meshlets(ordered_triangles(), clusters_, motion_.vertex_count());
        if (followed_) built = spread_out(built, 0);
        auto vertex_list =
            compute::upload(device(), built.vertices, compute::table::meshlet_vertices);
        auto corners = compute::upload(device(), built.corners, compute::table::meshlet_corners);
        tables_.meshlets = compute::upload(device(), built.meshlets, compute::table::meshlets);
        tables_.vertex_list = std::move(vertex_list);
        tables_.corners = std::move(corners);
    }
    return {cluster_buffer(), *tables_.meshlets, *tables_.vertex_list, *tables_.corners,
            static_cast<std::uint32_t>(clusters_.size())};
}

SceneBuffers::Surfaces SceneBuffers::surfaces() {
    if (!tables_.numbers) {
        std::vector<std::uint32_t> numbers(triangle_count_), patches(triangle_count_);
        const std::vector<std::uint32_t> of_triangles = smooth_patches(
            compute::read_back<glm::uvec3>(device(), *tables_.triangles, triangle_count_),
            download_segments(device(), tables_));
        for (std::uint32_t i = 0; i < triangle_count_; ++i) {
            numbers[triangle_order_[i]] = i;
            patches[i] = of_triangles[triangle_order_[i]];
        }
        auto uploaded = compute::upload(device(), numbers, compute::table::triangle_numbers);
        tables_.patches = compute::upload(device(), patches, compute::table::triangle_patches);
        tables_.numbers = std::move(uploaded);
    }
    return {*tables_.numbers, *tables_.patches};
}

SceneBuffers::GlSurfaces SceneBuffers::gl_surfaces() {
    if (!gl_numbers_) {
        const Surfaces own = surfaces();
        gl_patches_ = copy_to_gl<la_uint>(device(), own.patches, triangle_count_, purpose::model);
        gl_numbers_ = copy_to_gl<la_uint>(device(), own.numbers, triangle_count_, purpose::model);
    }
    return {gl_numbers_.id(), gl_patches_.id()};
}

template <class Change>
void SceneBuffers::change(const Change& change) {
    std::unique_ptr<Moving> made;
    if (!tables_.moving) made = make_moving(*stages_, *sharing_); // before anything changes
    change();
    start_moving(std::move(made));
}

void SceneBuffers::set_transforms(std::span<const glm::mat4> world_from_object) {
    change([&] { motion_.set_transforms(world_from_object); });
}

void SceneBuffers::set_positions(std::uint32_t first, std::span<const glm::vec3> positions) {
    change([&] { motion_.set_positions(first, positions); });
    device().upload(*tables_.vertices, std::as_bytes(positions), first * sizeof(glm::vec3));
    if (clusters_.empty()) return; // then there are no triangles
    if (!tables_.cluster_triangles) {
        tables_.cluster_triangles =
            compute::upload(device(), ordered_triangles(), compute::table::cluster_triangles);
    }
    const auto count = static_cast<std::uint32_t>(clusters_.size());
    stages_->launch_each<compute::kernels::transform_bounds>(
        count, {.vertices = *tables_.vertices,
                .triangles = *tables_.cluster_triangles,
                .clusters = *tables_.clusters});
    normals_.expect(*stages_, tables_, triangle_count_);
}

void SceneBuffers::set_hidden(std::span<const std::uint32_t> objects) {
    change([&] { motion_.set_hidden(objects); });
}

void SceneBuffers::start_moving(std::unique_ptr<Moving> made) {
    if (made) {
        tables_.moving = std::move(made);
        gl_vertices_ = {};
    }
    moved_ = true;
}

std::unique_ptr<SceneBuffers::Moving> SceneBuffers::make_moving(compute::Stages& stages,
                                                                interop::Sharing& sharing) const {
    const std::size_t room = followed_ ? followed_->object_room : 0;
    std::unique_ptr<Moving> made{new Moving{{stages, tables_, motion_, cluster_objects_, room},
                                            {sharing, compute::table::drawn_vertices}}};
    made->drawn.fit(motion_.vertex_count() * sizeof(glm::vec3));
    return made;
}

void SceneBuffers::move() {
    tables_.moving->move(tables_, motion_, normals_, tables_.clusters.get(),
                         &tables_.moving->drawn.compute());
    moved_ = false;
    boxes_are_old_ = true;
}

std::span<const Cluster> SceneBuffers::boxes() {
    if (boxes_are_old_) {
        device().download(cluster_buffer(), std::as_writable_bytes(std::span{clusters_}));
        boxes_are_old_ = false;
    }
    return clusters_;
}

void SceneBuffers::forget_jumps(std::span<const glm::mat4> transforms_from, const Camera& camera,
                                float most_pixels, compute::Buffer& ranges) {
    if (!tables_.moving) return;
    const std::vector<std::uint8_t> jumped = motion_.jumped(transforms_from, camera, most_pixels);
    if (!jumped.empty()) tables_.moving->forget(candidate_table(), jumped, ranges);
}

void SceneBuffers::upload_colors(const LineSet& lines) {
    tables_.colors.reset();
    if (lines.triangle_color.empty()) return;
    // The table's last entry stands for no colour. Passes know it by its alpha of 0.
    std::vector<glm::u8vec4> table;
    table.reserve(lines.colors.size() + 1);
    for (const glm::vec3& color : lines.colors) {
        table.emplace_back(glm::round(255.0F * glm::clamp(color, 0.0F, 1.0F)), 255);
    }
    table.emplace_back(0);
    const auto upload_indices = [&]<class Index>(Index) {
        std::vector<Index> indices(lines.triangle_color.size());
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const std::size_t index = std::min<std::size_t>(
                lines.triangle_color[triangle_order_[i]], lines.colors.size());
            indices[i] = static_cast<Index>(index);
        }
        gl_color_indices_ = upload_gl(bytes_of(indices), purpose::fill);
    };
    const bool fits_a_byte = table.size() <= 256;
    if (fits_a_byte)
        upload_indices(std::uint8_t{});
    else
        upload_indices(std::uint16_t{});
    gl_colors_ = upload_gl(bytes_of(table), purpose::fill);
    colors_ = {.indices = gl_color_indices_.id(),
               .index_format = static_cast<GLenum>(fits_a_byte ? GL_R8UI : GL_R16UI),
               .colors = gl_colors_.id()};
}

compute::Buffer* SceneBuffers::colors() {
    if (colors_.indices == 0) return nullptr;
    if (tables_.colors) return tables_.colors.get();
    const auto read = [](GLuint buffer, auto& values) {
        const auto bytes = std::as_writable_bytes(std::span{values});
        glGetNamedBufferSubData(buffer, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
    };
    GLint table_bytes = 0;
    glGetNamedBufferParameteriv(colors_.colors, GL_BUFFER_SIZE, &table_bytes);
    std::vector<std::uint32_t> table(static_cast<std::size_t>(table_bytes) / sizeof(glm::u8vec4));
    read(colors_.colors, table);
    std::vector<std::uint32_t> colors(triangle_count_);
    const auto look_up = [&]<class Index>(Index) {
        std::vector<Index> indices(triangle_count_);
        read(colors_.indices, indices);
        std::ranges::transform(indices, colors.begin(), [&](Index i) { return table[i]; });
    };
    if (colors_.index_format == GL_R8UI)
        look_up(std::uint8_t{});
    else
        look_up(std::uint16_t{});
    tables_.colors = compute::upload(device(), colors, compute::table::colors);
    return tables_.colors.get();
}

std::vector<glm::uvec3> SceneBuffers::smooth_corners(const compute::ContourTables& contours) const {
    const auto own =
        compute::read_back<glm::uvec3>(device(), *contours.face_corners, contours.face_count);
    const std::vector<Segment> segments = download_segments(device(), tables_);
    const std::span faces = std::span{segments}.last(contours.face_count);
    std::vector<glm::uvec3> of_triangle(triangle_count_, glm::uvec3{LA_NO_SURFACE});
    for (std::uint32_t i = 0; i < contours.face_count; ++i)
        if (own[i].x != own[i].y) // else it stands in empty room, see Assembly
            of_triangle[faces[i].face_a] = own[i];
    return in_order(of_triangle);
}

compute::SmoothTriangles SceneBuffers::smooth_triangles() {
    const std::optional<compute::ContourTables> contours = contours_now();
    if (!contours) return {};
    if (!tables_.smooth_corners)
        tables_.smooth_corners =
            compute::upload(device(), smooth_corners(*contours), compute::table::smooth_corners);
    return {tables_.smooth_corners.get(), contours->corners};
}

std::optional<gl::SmoothTriangles> SceneBuffers::gl_smooth_triangles() {
    const std::optional<compute::ContourTables> contours = contours_now();
    if (!contours) return {};
    if (!gl_smooth_corners_)
        gl_smooth_corners_ = upload_gl(bytes_of(smooth_corners(*contours)), purpose::fill);
    if (!gl_normals_ || normals_version_ != tables_.version) {
        gl_normals_ = copy_to_gl<ContourCorner>(
            device(), *contours->corners, tables_.contour_chunk().corner_count(), purpose::fill);
        normals_version_ = tables_.version;
    }
    return gl::SmoothTriangles{gl_smooth_corners_.id(), gl_normals_.id(),
                               tables_.contour_chunk().corner_count(), motion_.vertex_count()};
}

SceneBuffers::Tables SceneBuffers::copy_tables(compute::Stages& stages, interop::Sharing& sharing) {
    const auto copy = [&](compute::Buffer& buffer, const compute::TableName& name) {
        return compute::upload(
            stages.device(), compute::read_back<std::byte>(device(), buffer, buffer.size()), name);
    };
    normals_.find(*stages_, tables_);
    const LineSet contours = download_contours(device(), tables_, triangle_count_);
    std::vector<LineTables::Chunk> chunks =
        upload_segments(stages.device(), download_segments(device(), tables_), &contours);
    if (followed_ && chunks.size() == 1) { // lists of parts stay where they are
        chunks.front().end_offsets =
            copy(*tables_.chunks.front().end_offsets, compute::table::end_offsets);
        chunks.front().ends = copy(*tables_.chunks.front().ends, compute::table::ends);
    }
    Tables copied{{.vertices = copy(*tables_.vertices, compute::table::vertices),
                   .triangles = copy(*tables_.triangles, compute::table::triangles),
                   .chunks = std::move(chunks),
                   .tracer = tables_.tracer},
                  copy(*tables_.clusters, compute::table::clusters),
                  tables_.cluster_triangles
                      ? copy(*tables_.cluster_triangles, compute::table::cluster_triangles)
                      : nullptr};
    if (tables_.moving) copied.moving = make_moving(stages, sharing);
    return copied;
}

gl::SegmentBuffers SceneBuffers::gl_segments() {
    if (!gl_segments_) {
        gl_segments_ = upload_gl(bytes_of(download_segments(device(), tables_)), purpose::spine);
        // These are in the order that segments refer to. gl_indices_ may have another order.
        gl_table_triangles_ =
            copy_to_gl<glm::uvec3>(device(), *tables_.triangles, triangle_count_, purpose::spine);
    }
    return {.segments = gl_segments_.id(),
            .vertices = gl_vertices(),
            .triangles = gl_table_triangles_.id(),
            .numbers = 0,
            .segment_count = segment_count(),
            .vertex_count = motion_.vertex_count(),
            .triangle_count = triangle_count_};
}

gl::LineBuffers SceneBuffers::gl_lines(LineKindMask kinds) {
    kinds &= ~mask_of(LineKind::silhouette); // silhouettes change from frame to frame
    if (!gl_lines_ || line_kinds_ != kinds) {
        std::vector<std::uint32_t> ends;
        for (const Segment& segment : download_segments(device(), tables_)) {
            if ((kinds & (1U << (segment.tag & LA_TAG_KIND_MASK))) == 0) continue;
            ends.push_back(segment.p);
            ends.push_back(segment.q);
        }
        gl_lines_ = upload_gl(bytes_of(ends), purpose::segments);
        line_kinds_ = kinds;
        line_count_ = static_cast<std::uint32_t>(ends.size() / 2);
    }
    return {gl_vertices(), gl_lines_.id(), line_count_};
}

} // namespace lineatlas
