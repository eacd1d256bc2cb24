#include "scene_buffers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_precision.hpp>

#include "core/clusters.hpp"
#include "glpasses/storage.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

// Below this a depth pass costs less than finding out what to leave out of it.
constexpr std::uint32_t fewest_triangles_culled = 50'000;
constexpr std::uint32_t cluster_size = 64;

// Points by which the motion of a picture is judged; up to twice as many.
constexpr std::size_t most_landmarks = 256;

/// In pixels; nothing for a point outside the picture.
std::optional<glm::vec2> window_position(glm::vec3 point, const glm::mat4& clip_from_world,
                                         glm::vec2 size) {
    const glm::vec4 clip = clip_from_world * glm::vec4{point, 1};
    if (!(std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w)) return std::nullopt;
    return (glm::vec2{clip} / clip.w + 1.0F) * 0.5F * size;
}

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
    return std::as_bytes(std::span{values});
}

gl::Buffer upload_gl(std::span<const std::byte> data) {
    gl::Buffer buffer = gl::Buffer::create();
    const std::byte nothing{};
    gl::allocate(buffer, std::max<std::size_t>(data.size(), 1),
                 data.empty() ? &nothing : data.data(), 0, "a model");
    return buffer;
}

std::unique_ptr<compute::Buffer> upload(compute::Backend& backend,
                                        std::span<const std::byte> data) {
    std::unique_ptr<compute::Buffer> buffer = backend.allocate(data.size());
    backend.upload(*buffer, data);
    return buffer;
}

} // namespace

SceneBuffers::SceneBuffers(compute::Backend& backend, const LineSet& lines)
    : backend_(&backend), tables_{.vertices = upload(backend, bytes_of(lines.vertices)),
                                  .triangles = upload(backend, bytes_of(lines.triangles)),
                                  .segments = upload(backend, bytes_of(lines.segments)),
                                  .clusters = nullptr},
      bounds_(lines.bounds), gl_vertices_(upload_gl(bytes_of(lines.vertices))),
      triangle_count_(static_cast<std::uint32_t>(lines.triangles.size())),
      segment_count_(static_cast<std::uint32_t>(lines.segments.size())) {
    if (triangle_count_ < fewest_triangles_culled) {
        gl_indices_ = upload_gl(bytes_of(lines.triangles));
        upload_colors(lines, {});
    } else {
        TriangleClusters parts = build_clusters(lines.vertices, lines.triangles, cluster_size);
        gl_indices_ = upload_gl(bytes_of(parts.triangles));
        clusters_ = std::move(parts.clusters);
        upload_colors(lines, parts.order);
    }
    const std::size_t every = std::max<std::size_t>(1, lines.vertices.size() / most_landmarks);
    for (std::size_t i = 0; i < lines.vertices.size(); i += every) {
        landmarks_.push_back(lines.vertices[i]);
    }
    tables_.clusters = upload(backend, bytes_of(clusters_));
}

float SceneBuffers::typical_motion(const Camera& from, const Camera& to) const {
    const glm::mat4 clip_from = from.clip_from_world(), clip_to = to.clip_from_world();
    if (clip_from == clip_to) return 0;
    std::array<float, 2 * most_landmarks> shifts;
    std::size_t count = 0;
    for (const glm::vec3 point : landmarks_) {
        const auto a = window_position(point, clip_from, glm::vec2{from.size});
        const auto b = window_position(point, clip_to, glm::vec2{to.size});
        if (a && b) shifts[count++] = glm::distance(*a, *b);
    }
    if (count == 0) return std::numeric_limits<float>::infinity();
    const auto middle = shifts.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(shifts.begin(), middle, shifts.begin() + static_cast<std::ptrdiff_t>(count));
    return *middle;
}

void SceneBuffers::upload_colors(const LineSet& lines, std::span<const std::uint32_t> order) {
    if (lines.triangle_color.empty()) return;
    // The table's last entry stands for no colour; a pass knows it by its alpha.
    std::vector<glm::u8vec4> table;
    table.reserve(lines.colors.size() + 1);
    for (const glm::vec3& color : lines.colors) {
        table.emplace_back(glm::round(255.0F * glm::clamp(color, 0.0F, 1.0F)), 255);
    }
    table.emplace_back(0);
    const auto upload_indices = [&]<class Index>(Index) {
        std::vector<Index> indices(lines.triangle_color.size());
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const std::size_t source = order.empty() ? i : order[i];
            const std::size_t index =
                std::min<std::size_t>(lines.triangle_color[source], lines.colors.size());
            indices[i] = static_cast<Index>(index);
        }
        gl_color_indices_ = upload_gl(bytes_of(indices));
    };
    const bool fits_a_byte = table.size() <= 256;
    if (fits_a_byte)
        upload_indices(std::uint8_t{});
    else
        upload_indices(std::uint16_t{});
    gl_colors_ = upload_gl(bytes_of(table));
    colors_ = {.indices = gl_color_indices_.id(),
               .index_format = static_cast<GLenum>(fits_a_byte ? GL_R8UI : GL_R16UI),
               .colors = gl_colors_.id()};
}

template <class T>
std::vector<T> SceneBuffers::download(compute::Buffer& buffer, std::size_t count) {
    std::vector<T> values(count);
    backend_->download(buffer, std::as_writable_bytes(std::span{values}));
    return values;
}

SceneBuffers::Tables SceneBuffers::copy_tables(compute::Backend& backend) {
    const auto copy = [&](compute::Buffer& buffer) {
        return upload(backend, bytes_of(download<std::byte>(buffer, buffer.size())));
    };
    return {.vertices = copy(*tables_.vertices),
            .triangles = copy(*tables_.triangles),
            .segments = copy(*tables_.segments),
            .clusters = copy(*tables_.clusters)};
}

std::vector<Segment> SceneBuffers::download_segments() {
    return download<Segment>(*tables_.segments, segment_count_);
}

gl::SegmentBuffers SceneBuffers::gl_segments() {
    if (!gl_segments_) {
        gl_segments_ = upload_gl(bytes_of(download_segments()));
        // In the order that segments refer to; gl_indices_ may have another.
        gl_table_triangles_ =
            upload_gl(bytes_of(download<glm::uvec3>(*tables_.triangles, triangle_count_)));
    }
    return {gl_segments_.id(), gl_vertices_.id(), gl_table_triangles_.id(), segment_count_};
}

gl::LineBuffers SceneBuffers::gl_lines(LineKindMask kinds) {
    kinds &= ~mask_of(LineKind::silhouette); // which edges those are changes from frame to frame
    if (!gl_lines_ || line_kinds_ != kinds) {
        std::vector<std::uint32_t> ends;
        for (const Segment& segment : download_segments()) {
            if ((kinds & (1U << (segment.tag & LA_TAG_KIND_MASK))) == 0) continue;
            ends.push_back(segment.p);
            ends.push_back(segment.q);
        }
        gl_lines_ = upload_gl(bytes_of(ends));
        line_kinds_ = kinds;
        line_count_ = static_cast<std::uint32_t>(ends.size() / 2);
    }
    return {gl_vertices_.id(), gl_lines_.id(), line_count_};
}

} // namespace lineatlas
