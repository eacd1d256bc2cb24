#include "stages.hpp"

#include <cmath>

#include <glm/gtc/matrix_inverse.hpp>

#include "compare.hpp"
#include "core/tiles.hpp"
#include "devices.hpp"

namespace lineatlas::test {
namespace {

using compute::Backend;
using compute::Buffer;

/// One pixel's width in window depth, times w.
float depth_tolerance(const Camera& camera) {
    return std::fabs(camera.projection[3][2] /
                     (camera.projection[1][1] * static_cast<float>(camera.size.y)));
}

template <class T>
void set(Backend& backend, std::unique_ptr<Buffer>& buffer, const std::vector<T>& values) {
    backend.upload(*buffer, std::as_bytes(std::span{values}));
}

/// Samples that the state's atlas has room for: fewer than it needs where a test has cut it.
std::uint32_t capacity_of(const AtlasLayout& layout, const FrameState& state) {
    const bool wraps = layout.width == layout.pitch;
    const std::size_t rows = state.alpha.size() / layout.pitch;
    const std::size_t room = wraps ? state.alpha.size() : rows * layout.width;
    return static_cast<std::uint32_t>(std::min<std::size_t>(state.offsets.back(), room));
}

} // namespace

Stages::Stages(std::unique_ptr<Backend> backend, const LineSet& lines,
               const StageSettings& settings)
    : backend_(std::move(backend)), settings_(settings),
      n_(static_cast<std::uint32_t>(lines.segments.size())),
      triangle_count_(static_cast<std::uint32_t>(lines.triangles.size())),
      vertices_(to_device(*backend_, lines.vertices)),
      triangles_(to_device(*backend_, lines.triangles)),
      segments_(to_device(*backend_, lines.segments)),
      front_(to_device(*backend_, std::vector<std::uint8_t>(triangle_count_))),
      // Zeros where nothing is written, so that tables can be compared whole.
      clipped_(to_device(*backend_, std::vector<ClippedSegment>(n_))),
      offsets_(backend_->allocate((n_ + 1) * sizeof(std::uint32_t))),
      arcs_(backend_->allocate((n_ + 1) * sizeof(std::uint32_t))) {}

void Stages::pyramid(const Camera& camera, const std::vector<float>& depth, FrameState& state) {
    const glm::ivec2 size = camera.size * settings_.depth_scale;
    const glm::ivec2 count = compute::tiles_for(size);
    const auto depth_buffer = to_device(*backend_, depth);
    state.tiles.resize(static_cast<std::size_t>(count.x * count.y));
    tiles_ = to_device(*backend_, state.tiles);
    backend_->pyramid({.depth = *depth_buffer, .depth_size = size, .tiles = *tiles_});
    state.tiles = read_back<float>(*backend_, *tiles_, state.tiles.size());
}

std::vector<std::uint8_t> Stages::cull(const Camera& camera, const std::vector<Cluster>& clusters) {
    const auto count = static_cast<std::uint32_t>(clusters.size());
    const auto buffer = to_device(*backend_, clusters);
    const auto visible = backend_->allocate(count);
    backend_->cull({.clusters = *buffer,
                    .count = count,
                    .clip_from_world = camera.clip_from_world(),
                    .depth_size = camera.size * settings_.depth_scale,
                    .tiles = *tiles_,
                    .visible = *visible});
    return read_back<std::uint8_t>(*backend_, *visible, count);
}

void Stages::project(const Camera& camera, bool cull_hidden, FrameState& state) {
    const compute::OcclusionTest occlusion{
        .tiles = *tiles_,
        .tile_count = compute::tiles_for(camera.size * settings_.depth_scale),
        .depth_scale = static_cast<float>(settings_.depth_scale),
        .tolerance = depth_tolerance(camera)};
    const glm::mat4 clip_from_world = camera.clip_from_world();
    backend_->facing({.table = table(), .eye = camera.eye(), .front = *front_});
    state.front = read_back<std::uint8_t>(*backend_, *front_, triangle_count_);
    backend_->project_clip({.table = table(),
                            .front = *front_,
                            .clip_from_world = clip_from_world,
                            .world_from_clip = glm::mat4{glm::inverse(glm::dmat4{clip_from_world})},
                            .viewport = glm::vec2{camera.size},
                            .step = 2,
                            .kind_mask = all_line_kinds,
                            .occlusion = cull_hidden ? &occlusion : nullptr,
                            .out = {*clipped_, *offsets_, *arcs_}});
    state.counts = read_back<std::uint32_t>(*backend_, *offsets_, n_);
    state.lengths = read_back<std::uint32_t>(*backend_, *arcs_, n_);
    state.clipped = read_back<ClippedSegment>(*backend_, *clipped_, n_);
}

void Stages::scan(FrameState& state) {
    set(*backend_, offsets_, state.counts);
    set(*backend_, arcs_, state.lengths);
    backend_->scan(*offsets_, n_, compute::ScanKind::saturate);
    backend_->scan(*arcs_, n_, compute::ScanKind::wrap);
    state.offsets = read_back<std::uint32_t>(*backend_, *offsets_, n_ + 1);
    state.arcs = read_back<std::uint32_t>(*backend_, *arcs_, n_ + 1);
}

void Stages::atlas(const Camera& camera, const std::vector<float>& depth, const AtlasLayout& layout,
                   FrameState& state) {
    set(*backend_, clipped_, state.clipped);
    set(*backend_, offsets_, state.offsets);
    const auto depth_buffer = to_device(*backend_, depth);
    const std::uint32_t total = state.offsets.back();
    const auto alpha = to_device(*backend_, std::vector<std::uint8_t>(layout.texels(total) + 64));
    backend_->atlas({.clipped = {*clipped_, *offsets_, *arcs_},
                     .segment_count = n_,
                     .depth = *depth_buffer,
                     .depth_size = camera.size * settings_.depth_scale,
                     .viewport = glm::vec2{camera.size},
                     .depth_scale = static_cast<float>(settings_.depth_scale),
                     .probes = settings_.probes,
                     .tolerance = depth_tolerance(camera),
                     .layout = layout,
                     .capacity = total,
                     .alpha = *alpha});
    state.alpha = read_back<std::uint8_t>(*backend_, *alpha, layout.texels(total) + 64);
}

void Stages::tiled_atlas(const Camera& camera, const std::vector<float>& depth,
                         const AtlasLayout& layout, FrameState& state) {
    constexpr int reach = 6;
    const std::uint32_t total = state.offsets.back();
    const glm::ivec2 whole = camera.size * settings_.depth_scale;
    set(*backend_, clipped_, state.clipped);
    set(*backend_, offsets_, state.offsets);
    const auto alpha = to_device(*backend_, std::vector<std::uint8_t>(layout.texels(total) + 64));
    for (const PictureTile& tile : make_tiles(camera.size, settings_.tile_pixels)) {
        const glm::ivec2 low = glm::max(tile.low * settings_.depth_scale - reach, 0);
        const glm::ivec2 high =
            glm::min((tile.low + tile.size) * settings_.depth_scale + reach, whole);
        std::vector<float> part;
        for (int y = low.y; y < high.y; ++y) {
            const auto row = depth.begin() + static_cast<std::ptrdiff_t>(y) * whole.x;
            part.insert(part.end(), row + low.x, row + high.x);
        }
        // Segments end at the borders of the picture.
        const auto outer = [](int at, int border, int beyond) {
            return at == border ? beyond : at;
        };
        const glm::ivec2 core = tile.low * settings_.depth_scale;
        const glm::ivec2 core_end = (tile.low + tile.size) * settings_.depth_scale;
        const compute::DepthTile place{.origin = low,
                                       .core_low = {outer(core.x, 0, -9), outer(core.y, 0, -9)},
                                       .core_high = {outer(core_end.x, whole.x, whole.x + 9),
                                                     outer(core_end.y, whole.y, whole.y + 9)}};
        const auto buffer = to_device(*backend_, part);
        backend_->atlas({.clipped = {*clipped_, *offsets_, *arcs_},
                         .segment_count = n_,
                         .depth = *buffer,
                         .depth_size = high - low,
                         .viewport = glm::vec2{camera.size},
                         .depth_scale = static_cast<float>(settings_.depth_scale),
                         .probes = settings_.probes,
                         .tolerance = depth_tolerance(camera),
                         .layout = layout,
                         .capacity = total,
                         .alpha = *alpha,
                         .tile = &place});
        backend_->finish();
    }
    state.alpha = read_back<std::uint8_t>(*backend_, *alpha, layout.texels(total) + 64);
}

void Stages::temporal(const AtlasLayout& layout, const FrameState& before, FrameState& now) {
    const std::uint32_t room = std::max(before.offsets.back(), now.offsets.back());
    const std::size_t texels = layout.texels(room) + 64;
    const auto history_alpha = to_device(*backend_, std::vector<std::uint8_t>(texels));
    const auto history_offsets = to_device(*backend_, std::vector<std::uint32_t>(n_ + 1));
    const auto ranges = to_device(*backend_, std::vector<std::uint32_t>(n_));
    for (const FrameState* frame : {&before, static_cast<const FrameState*>(&now)}) {
        set(*backend_, clipped_, frame->clipped);
        set(*backend_, offsets_, frame->offsets);
        std::vector<std::uint8_t> padded = frame->alpha;
        padded.resize(texels);
        const auto alpha = to_device(*backend_, padded);
        backend_->temporal({.clipped = {*clipped_, *offsets_, *arcs_},
                            .segment_count = n_,
                            .layout = layout,
                            .capacity = room,
                            .alpha = *alpha,
                            .history = {*history_alpha, *history_offsets, *ranges},
                            .use_history = frame != &before});
        if (frame == &before) continue;
        padded = read_back<std::uint8_t>(*backend_, *alpha, texels);
        EXPECT_TRUE(equal(padded, read_back<std::uint8_t>(*backend_, *history_alpha, texels)));
        padded.resize(now.alpha.size());
        now.alpha = padded;
    }
}

void Stages::compact(const Camera& camera, const AtlasLayout& layout, FrameState& state) {
    set(*backend_, clipped_, state.clipped);
    set(*backend_, offsets_, state.offsets);
    set(*backend_, arcs_, state.arcs);
    const auto alpha = to_device(*backend_, state.alpha);
    const auto runs = backend_->allocate(settings_.run_capacity * sizeof(Run));
    const auto record = backend_->allocate(sizeof(FrameRecord));
    backend_->compact_runs({.table = table(),
                            .clipped = {*clipped_, *offsets_, *arcs_},
                            .alpha = *alpha,
                            .layout = layout,
                            .capacity = capacity_of(layout, state),
                            .viewport = glm::vec2{camera.size},
                            .half_width = 1,
                            .runs = *runs,
                            .run_capacity = settings_.run_capacity,
                            .record = *record});
    state.record = read_back<FrameRecord>(*backend_, *record, 1)[0];
    state.runs = read_back<Run>(*backend_, *runs, state.record.points[0]);
}

void Stages::intervals(const Camera& camera, const std::vector<float>& depth,
                       const AtlasLayout& layout, bool hidden_too, FrameState& state) {
    set(*backend_, clipped_, state.clipped);
    set(*backend_, offsets_, state.offsets);
    set(*backend_, arcs_, state.arcs);
    const auto alpha = to_device(*backend_, state.alpha);
    const auto depth_buffer = to_device(*backend_, depth);
    const auto table = backend_->allocate(settings_.run_capacity * sizeof(Interval));
    const auto total = backend_->allocate(sizeof(std::uint32_t));
    backend_->intervals({.table = this->table(),
                         .clipped = {*clipped_, *offsets_, *arcs_},
                         .alpha = *alpha,
                         .layout = layout,
                         .capacity = state.offsets.back(),
                         .viewport = glm::vec2{camera.size},
                         .depth = *depth_buffer,
                         .depth_size = camera.size * settings_.depth_scale,
                         .depth_scale = static_cast<float>(settings_.depth_scale),
                         .tolerance = depth_tolerance(camera),
                         .hidden_too = hidden_too,
                         .intervals = *table,
                         .interval_capacity = settings_.run_capacity,
                         .total = *total});
    const std::uint32_t count = read_back<std::uint32_t>(*backend_, *total, 1)[0];
    state.intervals = read_back<Interval>(*backend_, *table, count);
}

void Stages::halo(const Camera& camera, FrameState& state) {
    set(*backend_, clipped_, state.clipped);
    const auto runs = to_device(*backend_, state.runs);
    const auto record = to_device(*backend_, std::vector{state.record});
    const auto cuts = backend_->allocate(state.runs.size() * sizeof(RunCuts));
    backend_->halo({.table = table(),
                    .clipped = {*clipped_, *offsets_, *arcs_},
                    .runs = *runs,
                    .record = *record,
                    .run_capacity = static_cast<std::uint32_t>(state.runs.size()),
                    .viewport = glm::vec2{camera.size},
                    .halo = 3,
                    .half_width = 1,
                    .tolerance = depth_tolerance(camera),
                    .cuts = *cuts});
    state.cuts = read_back<RunCuts>(*backend_, *cuts, state.runs.size());
}

void Stages::filter(const Camera& camera, const AtlasLayout& layout, FrameState& state) {
    set(*backend_, clipped_, state.clipped);
    set(*backend_, offsets_, state.offsets);
    set(*backend_, arcs_, state.arcs);
    const auto alpha = to_device(*backend_, state.alpha);
    const auto runs = to_device(*backend_, state.runs);
    const auto record = to_device(*backend_, std::vector{state.record});
    const bool has_gaps = !state.cuts.empty();
    const auto cuts = to_device(*backend_, has_gaps ? state.cuts : std::vector<RunCuts>(1));
    const auto filtered = backend_->allocate(settings_.run_capacity * sizeof(Run));
    const auto filtered_record = backend_->allocate(sizeof(FrameRecord));
    backend_->filter({.table = table(),
                      .clipped = {*clipped_, *offsets_, *arcs_},
                      .alpha = *alpha,
                      .layout = layout,
                      .capacity = capacity_of(layout, state),
                      .viewport = glm::vec2{camera.size},
                      .half_width = 1,
                      .fill = 4,
                      .drop = 4,
                      .overshoot = 12,
                      .overshoot_variation = 0.3F,
                      .undershoot = 2,
                      .runs = *runs,
                      .record = *record,
                      .cuts = has_gaps ? cuts.get() : nullptr,
                      .run_capacity = static_cast<std::uint32_t>(state.runs.size()),
                      .filtered = *filtered,
                      .filtered_capacity = settings_.run_capacity,
                      .filtered_record = *filtered_record});
    state.record = read_back<FrameRecord>(*backend_, *filtered_record, 1)[0];
    state.runs = read_back<Run>(*backend_, *filtered, state.record.points[0]);
    state.alpha = read_back<std::uint8_t>(*backend_, *alpha, state.alpha.size());
}

void Stages::density(const Camera& camera, const AtlasLayout& layout, FrameState& state) {
    set(*backend_, arcs_, state.arcs);
    const auto alpha = to_device(*backend_, state.alpha);
    const auto runs = to_device(*backend_, state.runs);
    const auto record = to_device(*backend_, std::vector{state.record});
    const glm::vec2 viewport{camera.size};
    const glm::ivec2 cells = compute::density_cells(viewport);
    const auto count = LA_DENSITY_BINS * static_cast<std::size_t>(cells.x * cells.y);
    const auto weights = backend_->allocate(count * sizeof(float));
    backend_->density({.table = table(),
                       .clipped = {*clipped_, *offsets_, *arcs_},
                       .alpha = *alpha,
                       .layout = layout,
                       .runs = *runs,
                       .record = *record,
                       .run_capacity = static_cast<std::uint32_t>(state.runs.size()),
                       .viewport = viewport,
                       .limit = 0.1F,
                       .priority = {0.5F, 0.6F, 0.5F, 1, 1},
                       .focus = {0.4F * viewport.x, 0.6F * viewport.y, 30, 80},
                       .far_limit = 0.5F,
                       .weights = *weights});
    state.weights = read_back<float>(*backend_, *weights, count);
    state.flags.clear();
    for (const Run& run : read_back<Run>(*backend_, *runs, state.runs.size())) {
        state.flags.push_back(run.flags);
    }
}

std::vector<std::uint32_t> Stages::compact_samples(const FrameState& state) {
    const auto count = static_cast<std::uint32_t>(state.alpha.size());
    const auto alpha = to_device(*backend_, state.alpha);
    const auto packed = backend_->allocate(count * sizeof(std::uint32_t));
    const auto packed_count = backend_->allocate(sizeof(std::uint32_t));
    backend_->compact_samples(
        {.alpha = *alpha, .count = count, .packed = *packed, .packed_count = *packed_count});
    return read_back<std::uint32_t>(*backend_, *packed,
                                    read_back<std::uint32_t>(*backend_, *packed_count, 1)[0]);
}

} // namespace lineatlas::test
