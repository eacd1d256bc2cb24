#include "exact_visibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "compute/transfer.hpp"
#include "core/screen_bounds.hpp"
#include "core/surface_view.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::compute {
namespace {

/// Rounding of a sum of four products of floats, with some to spare.
constexpr float sum_rounding = 2.5e-7F;
/// Rounding of a position on the screen, as a share of the picture's longer side.
constexpr float place_rounding = 1e-7F;

/// A good number of triangles in a tile, if they were all in one layer.
constexpr float triangles_per_tile = 400;
constexpr float smallest_tile = 4, largest_tile = 64;
constexpr float most_tiles_a_side = 128; // with more, tiles are made larger

/// First guesses; a frame that needs more makes its tables grow.
constexpr std::uint32_t least_entries = 1U << 8U, most_entries = 1U << 14U;
constexpr std::uint32_t least_groups = 1U << 6U, most_groups = 1U << 12U;
constexpr std::uint32_t triangles_per_group = 8; // the last group of a tile is seldom full
constexpr std::uint32_t first_span_capacity = 1U << 13U;

/// The side of tiles in pixels, a power of two. It is small if many triangles lie in few pixels.
float tile_size_for(const Camera& camera, const Bounds& bounds, std::uint32_t triangles) {
    const glm::vec2 covered{
        screen_bounds(bounds, camera.clip_from_world(), camera.size, 0, 1).size()};
    const float area = std::max(covered.x * covered.y, 1.0F);
    const float good = std::sqrt(area * triangles_per_tile / static_cast<float>(triangles + 1));
    const float size =
        std::clamp(std::exp2(std::round(std::log2(good))), smallest_tile, largest_tile);
    const auto side = static_cast<float>(std::max(camera.size.x, camera.size.y));
    return std::max(size, std::exp2(std::ceil(std::log2(side / most_tiles_a_side))));
}

/// The row of a matrix that gives one coordinate.
glm::vec4 row_of(const glm::mat4& m, int row) {
    return {m[0][row], m[1][row], m[2][row], m[3][row]};
}

ExactParameters parameters_of(const SegmentTable& table, const Camera& camera, const Bounds& bounds,
                              float contact) {
    const glm::mat4 clip_from_world = camera.clip_from_world();
    glm::vec4 eye = camera.eye();
    const bool parallel = eye.w == 0;
    if (parallel) eye /= glm::length(glm::vec3{eye});
    const glm::vec4 depth = row_of(clip_from_world, parallel ? 2 : 3);
    const glm::vec3 farthest = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
    const float size = tile_size_for(camera, bounds, table.triangle_count);
    const glm::ivec2 pixels{static_cast<int>(size)};
    const std::optional<ContourTables>& contours = table.candidates.contours;
    return {.count = table.segment_count,
            .vertex_count =
                contours ? contours->vertex_count
                         : static_cast<std::uint32_t>(table.vertices.size() / (3 * sizeof(float))),
            .triangle_count = table.triangle_count,
            .clip_from_world = clip_from_world,
            .eye = eye,
            .viewport = glm::vec2{camera.size},
            .tiles = (camera.size + pixels - 1) / pixels,
            .tile_size = size,
            .contact = contact,
            .slack = place_rounding * static_cast<float>(std::max(camera.size.x, camera.size.y)),
            .depth_rate = parallel ? glm::length(glm::vec3{depth}) : 0,
            .rounding =
                sum_rounding * (glm::dot(glm::abs(glm::vec3{depth}), farthest) + std::abs(depth.w)),
            .slices = 0,
            .chunk = 0,
            .chunks = 0,
            .entry_capacity = 0,
            .group_capacity = 0,
            .span_capacity = 0,
            .beside = 0,
            .lift = contours ? 1U : 0U,
            .batched = 0,
            .keeps_hidden = 0};
}

} // namespace

void ExactVisibility::release() {
    table_.reset();
    triangles_.release();
    batches_ = {};
    lists_ = {&device_};
    for (Found* found : {&own_, &beside_, &within_}) {
        for (Table* table : {&found->kept, &found->offsets, &found->spans}) table->release();
        found->capacity = 0;
    }
    for (Table* table : {&numbers_, &seen_, &pushed_, &part_offsets_, &parts_}) table->release();
    part_capacity_ = 0;
    parameters_ = {};
}

void ExactVisibility::begin(const SegmentTable& table, const Camera& camera, const Bounds& bounds,
                            float contact) {
    has_found_ = table_.has_value();
    table_.emplace(table);
    const ExactParameters before = parameters_;
    parameters_ = parameters_of(table, camera, bounds, contact);
    using Group = std::array<float, LA_GROUP_FLOATS>;
    const std::uint32_t entries = std::clamp(table.triangle_count, least_entries, most_entries);
    const std::uint32_t groups =
        std::clamp(table.triangle_count / triangles_per_group, least_groups, most_groups);
    parameters_.entry_capacity =
        std::max(before.entry_capacity, first_capacity<Entry>(device_, entries));
    parameters_.group_capacity =
        std::max(before.group_capacity, first_capacity<Group>(device_, groups));
    own_.capacity =
        std::max(own_.capacity, first_capacity<std::array<float, 2>>(device_, first_span_capacity));

    constexpr std::uint64_t four = 4 * sizeof(float);
    lists_.screen.fit(parameters_.vertex_count * four);
    lists_.faces.fit(std::uint64_t{parameters_.triangle_count} * sizeof(ScreenFace));
    lists_.planes.fit(parameters_.triangle_count * four);
    make_room_for_segments();
    lists_.occluders.fit(std::uint64_t{tiles()} * sizeof(la_uint));
    lists_.ends.fit((std::uint64_t{tiles()} * columns() + 1) * sizeof(la_uint));
    lists_.groups.fit((std::uint64_t{tiles()} + 1) * sizeof(la_uint));
    make_lists();
    own_.make_spans();
}

void ExactVisibility::make_room_for_segments() {
    own_.kept.fit(parameters_.count * std::uint64_t{4 * sizeof(float)});
    own_.offsets.fit((std::uint64_t{parameters_.count} + 1) * sizeof(la_uint));
}

void ExactVisibility::go_on(const SegmentTable& table) {
    has_found_ = true;
    table_.emplace(table);
    parameters_.count = table.segment_count;
    make_room_for_segments();
}

void ExactVisibility::make_lists() {
    const std::uint64_t groups = parameters_.group_capacity;
    lists_.entries.fit(std::uint64_t{parameters_.entry_capacity} * sizeof(Entry));
    lists_.blocks.fit(groups * LA_GROUP_FLOATS * sizeof(float));
    lists_.boxes.fit((groups + LA_GROUP) * LA_BOX_FLOATS * sizeof(float));
}

std::uint32_t ExactVisibility::grown(std::uint32_t needed, std::size_t element) const {
    constexpr std::uint64_t uncountable = std::numeric_limits<std::uint32_t>::max();
    if (needed == uncountable) { // the value at which sums stop
        throw DeviceError(beyond_limit(purpose::exact, "over 4 billion faces in its lists",
                                       "kernels count to 4 billion"));
    }
    const std::uint64_t room = has_found_ ? room_to_grow(device_, needed, element) : needed;
    return static_cast<std::uint32_t>(std::min(room, uncountable - 1));
}

void ExactVisibility::find_beside(const ClippedTable& clipped, std::uint32_t seen,
                                  std::uint32_t ways, Found& found) {
    const std::uint64_t count = std::uint64_t{seen} * ways;
    found.capacity = std::max(found.capacity,
                              first_capacity<std::array<float, 2>>(device_, first_span_capacity));
    found.kept.make_room(count * 4 * sizeof(float));
    found.offsets.make_room((count + 1) * sizeof(la_uint));
    found.make_spans();
    Lines lines{{*pushed_, clipped.offsets, clipped.arcs}, parameters_, found, seen_.get()};
    lines.parameters.count = static_cast<std::uint32_t>(count);
    lines.parameters.beside = ways;
    find_spans(lines);
    const auto spans = read_one<la_uint>(device_, *found.offsets, count);
    if (spans <= found.capacity) return;
    found.capacity = grown(spans, 2 * sizeof(float));
    found.make_spans();
    write_spans(lines);
}

OutlineTable ExactVisibility::outline(const ClippedTable& clipped, float depth) {
    const std::uint32_t segments = parameters_.count;
    numbers_.fit((segments + 1ULL) * sizeof(la_uint));
    part_offsets_.fit((segments + 1ULL) * sizeof(la_uint));
    stages_.outline_seen(*table_, clipped, spans(), *numbers_);
    const auto seen = read_one<la_uint>(device_, *numbers_, segments);
    const std::uint64_t ways = LA_OUTLINE_WITHIN * std::uint64_t{seen};
    if (ways >= std::numeric_limits<std::uint32_t>::max()) {
        throw DeviceError(beyond_limit(purpose::exact, "over 1 billion lines with outlines",
                                       "kernels count to 4 billion"));
    }
    seen_.make_room(std::uint64_t{seen} * sizeof(la_uint));
    pushed_.make_room(ways * sizeof(ClippedSegment));
    stages_.launch_each<kernels::scan_list>(segments, {.values = *numbers_, .list = *seen_});
    constexpr float reach = 0.5F; // pixels
    const OutlineParameters outline{.count = seen,
                                    .viewport = parameters_.viewport,
                                    .reach = reach,
                                    .depth = depth,
                                    .parallel = parameters_.depth_rate > 0 ? 1U : 0U,
                                    .capacity = 0,
                                    .clip_from_world = parameters_.clip_from_world,
                                    .lift = parameters_.lift};
    const struct { Buffer &seen, &pushed; } pushed{*seen_, *pushed_};
    stages_.launch<kernels::outline_push>(seen, outline, *table_, clipped, pushed);
    find_beside(clipped, seen, LA_OUTLINE_BESIDE, beside_);
    stages_.launch<kernels::outline_push_in>(
        seen, outline, {.beside_offsets = beside_.offsets.get()}, clipped, pushed);
    find_beside(clipped, seen, LA_OUTLINE_WITHIN, within_);

    part_capacity_ = std::max(part_capacity_, beside_.capacity);
    for (bool again = true; again;) {
        parts_.fit(std::uint64_t{part_capacity_} * 2 * sizeof(float));
        stages_.outline_parts({.segment_count = segments,
                               .numbers = *numbers_,
                               .arcs = clipped.arcs,
                               .depth = depth,
                               .beside = beside_.table(),
                               .within = within_.table(),
                               .part_offsets = *part_offsets_,
                               .parts = *parts_,
                               .part_capacity = part_capacity_});
        const auto found = read_one<la_uint>(device_, *part_offsets_, segments);
        again = found > part_capacity_;
        if (again) part_capacity_ = grown(found, 2 * sizeof(float));
    }
    return {*part_offsets_, *parts_};
}

void ExactVisibility::read_sizes() {
    sizes_ = {.entries = read_one<la_uint>(device_, *lists_.ends, std::size_t{tiles()} * columns()),
              .groups = read_one<la_uint>(device_, *lists_.groups, tiles()),
              .spans = read_one<la_uint>(device_, *own_.offsets, parameters_.count)};
}

bool ExactVisibility::grow(const ClippedTable& clipped) {
    const auto [entries, groups, spans] = sizes_;
    bool again = false;
    if (entries > parameters_.entry_capacity) {
        parameters_.entry_capacity = grown(entries, sizeof(Entry));
        again = true;
    }
    if (groups > parameters_.group_capacity) {
        parameters_.group_capacity = grown(groups, LA_GROUP_FLOATS * sizeof(float));
        again = true;
    }
    if (again) {
        make_lists();
    } else if (spans > own_.capacity) {
        own_.capacity = grown(spans, 2 * sizeof(float));
        own_.make_spans();
        write_spans(lines(clipped));
    }
    return again;
}

} // namespace lineatlas::compute
