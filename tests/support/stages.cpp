#include "stages.hpp"

#include <cmath>
#include <optional>

#include <glm/gtc/matrix_inverse.hpp>

#include "compare.hpp"
#include "core/tiles.hpp"
#include "devices.hpp"

namespace lineatlas::test {
namespace {

using compute::Buffer;
using compute::Device;

template <class T>
void set(Device& device, std::unique_ptr<Buffer>& buffer, const std::vector<T>& values) {
    device.upload(*buffer, std::as_bytes(std::span{values}));
}

} // namespace

float depth_tolerance(const Camera& camera) {
    return std::fabs(camera.projection[3][2] /
                     (camera.projection[1][1] * static_cast<float>(camera.size.y)));
}

std::uint32_t capacity_of(const FrameState& state) {
    return static_cast<std::uint32_t>(
        std::min<std::size_t>(state.offsets.back(), state.alpha.size()));
}

compute::DepthBuffer FrameStages::depth_of(Buffer& texels, glm::ivec2 size, const Camera& camera) {
    return {.texels = texels,
            .size = size,
            .scale = static_cast<float>(settings_.depth_scale),
            .tolerance = depth_tolerance(camera)};
}

FrameStages::FrameStages(std::unique_ptr<Device> device, const LineSet& lines,
                         const StageSettings& settings)
    : device_(std::move(device)), stages_(*device_), settings_(settings),
      n_(static_cast<std::uint32_t>(lines.segments.size())),
      triangle_count_(static_cast<std::uint32_t>(lines.triangles.size())),
      vertices_(to_device(*device_, lines.vertices)),
      triangles_(to_device(*device_, lines.triangles)),
      segments_(to_device(*device_, lines.segments)),
      front_(to_device(*device_, std::vector<std::uint8_t>(triangle_count_))),
      // Starts with zeros, so that whole tables can be compared.
      clipped_(to_device(*device_, std::vector<ClippedSegment>(n_))),
      offsets_(device_->allocate((n_ + 1) * sizeof(std::uint32_t))),
      arcs_(device_->allocate((n_ + 1) * sizeof(std::uint32_t))) {}

void FrameStages::pyramid(const Camera& camera, const std::vector<float>& depth,
                          FrameState& state) {
    const glm::ivec2 size = camera.size * settings_.depth_scale;
    const glm::ivec2 count = compute::tiles_for(size);
    const auto depth_buffer = to_device(*device_, depth);
    state.tiles.resize(static_cast<std::size_t>(count.x * count.y));
    tiles_ = to_device(*device_, state.tiles);
    stages_.pyramid(*depth_buffer, size, *tiles_);
    state.tiles = read_back<float>(*device_, *tiles_, state.tiles.size());
}

std::vector<std::uint32_t> FrameStages::cull(const Camera& camera,
                                             const std::vector<Cluster>& clusters) {
    const auto count = static_cast<std::uint32_t>(clusters.size());
    const auto buffer = to_device(*device_, clusters);
    const auto visible = device_->allocate(count * sizeof(la_uint));
    const glm::ivec2 depth_size = camera.size * settings_.depth_scale;
    stages_.launch<compute::kernels::cull>(
        count,
        {.count = count,
         .clip_from_world = camera.clip_from_world(),
         .depth_size = depth_size,
         .tile_count = compute::tiles_for(depth_size)},
        {.clusters = *buffer, .tiles = *tiles_, .visible = *visible});
    return read_back<std::uint32_t>(*device_, *visible, count);
}

void FrameStages::project(const Camera& camera, bool cull_hidden, FrameState& state) {
    const compute::OcclusionTest occlusion{
        .tiles = *tiles_,
        .tile_count = compute::tiles_for(camera.size * settings_.depth_scale),
        .depth_scale = static_cast<float>(settings_.depth_scale),
        .tolerance = depth_tolerance(camera)};
    const glm::mat4 clip_from_world = camera.clip_from_world();
    stages_.facing(table(), camera.eye(), *front_);
    state.front = read_back<std::uint8_t>(*device_, *front_, triangle_count_);
    compute::BatchTable batches;
    if (batches_.has_segments(table())) batches = batches_.table();
    const compute::ProjectClipArgs args{.table = table(),
                                        .front = *front_,
                                        .clip_from_world = clip_from_world,
                                        .viewport = glm::vec2{camera.size},
                                        .step = 2,
                                        .kind_mask = all_line_kinds,
                                        .occlusion = cull_hidden ? &occlusion : nullptr,
                                        .out = {*clipped_, *offsets_, *arcs_},
                                        .batches = batches};
    constexpr bool drops_hidden = false; // tests look at the lengths of hidden segments
    if (batches.count > 0) stages_.project_clip_batches(args, drops_hidden);
    stages_.project_clip(args);
    state.counts = read_back<std::uint32_t>(*device_, *offsets_, n_);
    state.lengths = read_back<std::uint32_t>(*device_, *arcs_, n_);
    state.clipped = read_back<ClippedSegment>(*device_, *clipped_, n_);
}

void FrameStages::scan(FrameState& state) {
    set(*device_, offsets_, state.counts);
    set(*device_, arcs_, state.lengths);
    stages_.scan(*offsets_, n_, compute::ScanKind::saturate);
    stages_.scan(*arcs_, n_, compute::ScanKind::wrap);
    state.offsets = read_back<std::uint32_t>(*device_, *offsets_, n_ + 1);
    state.arcs = read_back<std::uint32_t>(*device_, *arcs_, n_ + 1);
}

void FrameStages::atlas(const Camera& camera, const std::vector<float>& depth, FrameState& state) {
    set(*device_, clipped_, state.clipped);
    set(*device_, offsets_, state.offsets);
    const auto depth_buffer = to_device(*device_, depth);
    const std::uint32_t total = state.offsets.back();
    const auto alpha = to_device(*device_, std::vector<std::uint8_t>(total + 64));
    stages_.atlas({.segment_count = n_,
                   .atlas = atlas_of(*alpha, total),
                   .depth = depth_of(*depth_buffer, camera.size * settings_.depth_scale, camera),
                   .viewport = glm::vec2{camera.size},
                   .probes = settings_.probes});
    state.alpha = read_back<std::uint8_t>(*device_, *alpha, total + 64);
}

void FrameStages::tiled_atlas(const Camera& camera, const std::vector<float>& depth,
                              FrameState& state) {
    constexpr int reach = 6;
    const std::uint32_t total = state.offsets.back();
    const glm::ivec2 whole = camera.size * settings_.depth_scale;
    set(*device_, clipped_, state.clipped);
    set(*device_, offsets_, state.offsets);
    const auto alpha = to_device(*device_, std::vector<std::uint8_t>(total + 64));
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
        const auto buffer = to_device(*device_, part);
        stages_.atlas({.segment_count = n_,
                       .atlas = atlas_of(*alpha, total),
                       .depth = depth_of(*buffer, high - low, camera),
                       .viewport = glm::vec2{camera.size},
                       .probes = settings_.probes,
                       .tile = &place});
        device_->finish();
    }
    state.alpha = read_back<std::uint8_t>(*device_, *alpha, total + 64);
}

void FrameStages::temporal(const FrameState& before, FrameState& now) {
    const std::uint32_t room = std::max(before.offsets.back(), now.offsets.back());
    const std::size_t texels = std::size_t{room} + 64;
    const auto history_alpha = to_device(*device_, std::vector<std::uint8_t>(texels));
    const auto history_offsets = to_device(*device_, std::vector<std::uint32_t>(n_ + 1));
    const auto ranges = to_device(*device_, std::vector<std::uint32_t>(n_));
    for (const FrameState* frame : {&before, static_cast<const FrameState*>(&now)}) {
        set(*device_, clipped_, frame->clipped);
        set(*device_, offsets_, frame->offsets);
        std::vector<std::uint8_t> padded = frame->alpha;
        padded.resize(texels);
        const auto alpha = to_device(*device_, padded);
        stages_.temporal({.segment_count = n_,
                          .atlas = atlas_of(*alpha, room),
                          .history = {*history_alpha, *history_offsets, *ranges},
                          .use = frame != &before ? LA_HISTORY_CAMERA : LA_HISTORY_NONE});
        if (frame == &before) continue;
        padded = read_back<std::uint8_t>(*device_, *alpha, texels);
        EXPECT_TRUE(equal(padded, read_back<std::uint8_t>(*device_, *history_alpha, texels)));
        padded.resize(now.alpha.size());
        now.alpha = padded;
    }
}

void FrameStages::compact(const Camera& camera, FrameState& state) {
    set(*device_, clipped_, state.clipped);
    set(*device_, offsets_, state.offsets);
    set(*device_, arcs_, state.arcs);
    const auto alpha = to_device(*device_, state.alpha);
    const auto runs = device_->allocate(settings_.run_capacity * sizeof(Run));
    const auto record = device_->allocate(sizeof(FrameRecord));
    stages_.compact({.table = table(),
                     .atlas = atlas_of(*alpha, capacity_of(state)),
                     .viewport = glm::vec2{camera.size},
                     .half_width = settings_.half_width,
                     .runs = {*runs, *record, settings_.run_capacity}});
    state.record = read_back<FrameRecord>(*device_, *record, 1)[0];
    state.runs = read_back<Run>(*device_, *runs, state.record.points[0]);
}

void FrameStages::intervals(const Camera& camera, const std::vector<float>& depth, bool hidden_too,
                            FrameState& state) {
    set(*device_, clipped_, state.clipped);
    set(*device_, offsets_, state.offsets);
    set(*device_, arcs_, state.arcs);
    const auto alpha = to_device(*device_, state.alpha);
    const auto depth_buffer = to_device(*device_, depth);
    const auto table = device_->allocate(settings_.run_capacity * sizeof(Interval));
    const auto total = device_->allocate(sizeof(std::uint32_t));
    stages_.intervals(
        {.table = this->table(),
         .atlas = atlas_of(*alpha, state.offsets.back()),
         .viewport = glm::vec2{camera.size},
         .depth = depth_of(*depth_buffer, camera.size * settings_.depth_scale, camera),
         .hidden_too = hidden_too,
         .into = {*table, settings_.run_capacity, *total}});
    const std::uint32_t count = read_back<std::uint32_t>(*device_, *total, 1)[0];
    state.intervals = read_back<Interval>(*device_, *table, count);
}

void FrameStages::halo(const Camera& camera, FrameState& state) {
    set(*device_, clipped_, state.clipped);
    const auto runs = to_device(*device_, state.runs);
    const auto record = to_device(*device_, std::vector{state.record});
    const auto cuts = device_->allocate(state.runs.size() * sizeof(RunCuts));
    stages_.halo({.table = table(),
                  .clipped = {*clipped_, *offsets_, *arcs_},
                  .runs = {*runs, *record, static_cast<std::uint32_t>(state.runs.size())},
                  .viewport = glm::vec2{camera.size},
                  .halo = settings_.filter.halo,
                  .half_width = settings_.half_width,
                  .tolerance = depth_tolerance(camera),
                  .cuts = *cuts});
    state.cuts = read_back<RunCuts>(*device_, *cuts, state.runs.size());
}

void FrameStages::filter(const Camera& camera, FrameState& state) {
    set(*device_, clipped_, state.clipped);
    set(*device_, offsets_, state.offsets);
    set(*device_, arcs_, state.arcs);
    const auto alpha = to_device(*device_, state.alpha);
    const auto runs = to_device(*device_, state.runs);
    const auto record = to_device(*device_, std::vector{state.record});
    const bool has_gaps = !state.cuts.empty();
    const auto cuts = to_device(*device_, has_gaps ? state.cuts : std::vector<RunCuts>(1));
    const auto filtered = device_->allocate(settings_.run_capacity * sizeof(Run));
    const auto filtered_record = device_->allocate(sizeof(FrameRecord));
    stages_.filter({.table = table(),
                    .atlas = atlas_of(*alpha, capacity_of(state)),
                    .viewport = glm::vec2{camera.size},
                    .half_width = settings_.half_width,
                    .filter = settings_.filter,
                    .runs = {*runs, *record, static_cast<std::uint32_t>(state.runs.size())},
                    .cuts = has_gaps ? cuts.get() : nullptr,
                    .filtered = {*filtered, *filtered_record, settings_.run_capacity}});
    state.record = read_back<FrameRecord>(*device_, *filtered_record, 1)[0];
    state.runs = read_back<Run>(*device_, *filtered, state.record.points[0]);
    state.alpha = read_back<std::uint8_t>(*device_, *alpha, state.alpha.size());
}

void FrameStages::density(const Camera& camera, FrameState& state) {
    set(*device_, arcs_, state.arcs);
    const auto alpha = to_device(*device_, state.alpha);
    const auto runs = to_device(*device_, state.runs);
    const auto record = to_device(*device_, std::vector{state.record});
    const glm::vec2 viewport{camera.size};
    const glm::ivec2 cells = compute::density_cells(viewport);
    const auto count = LA_DENSITY_BINS * static_cast<std::size_t>(cells.x * cells.y);
    const auto weights = device_->allocate(count * sizeof(float));
    const auto grid = device_->allocate(count * sizeof(std::uint32_t));
    stages_.density({.table = table(),
                     .atlas = atlas_of(*alpha, state.offsets.back()),
                     .runs = {*runs, *record, static_cast<std::uint32_t>(state.runs.size())},
                     .viewport = viewport,
                     .density = settings_.density,
                     .focus = StageSettings::focus(viewport),
                     .far_limit = settings_.far_limit,
                     .grid = *grid,
                     .weights = *weights});
    state.weights = read_back<float>(*device_, *weights, count);
    state.flags.clear();
    for (const Run& run : read_back<Run>(*device_, *runs, state.runs.size())) {
        state.flags.push_back(run.flags);
    }
}

std::vector<Run> FrameStages::pens(const Camera& camera, const std::vector<float>& depth,
                                   const FrameState& state) {
    set(*device_, clipped_, state.clipped);
    set(*device_, offsets_, state.offsets);
    set(*device_, arcs_, state.arcs);
    const auto depth_buffer = to_device(*device_, depth);
    const auto part_offsets = device_->allocate((std::size_t{n_} + 1) * sizeof(la_uint));
    const std::uint32_t parts_at_most = 2 * state.offsets.back() + 1;
    const auto parts = device_->allocate(parts_at_most * sizeof(glm::vec2));
    stages_.outline_samples(
        {.table = table(),
         .clipped = {*clipped_, *offsets_, *arcs_},
         .sample_capacity = state.offsets.back(),
         .depth = depth_of(*depth_buffer, camera.size * settings_.depth_scale, camera),
         .viewport = glm::vec2{camera.size},
         .body = 2,
         .part_offsets = *part_offsets,
         .parts = *parts,
         .part_capacity = parts_at_most});
    const compute::OutlineTable outline{*part_offsets, *parts};
    const auto segment_pens = to_device(*device_, std::vector<la_uint>(n_, 1U << 16U));
    const auto runs = to_device(*device_, state.runs);
    const auto record = to_device(*device_, std::vector{state.record});
    const auto count = static_cast<std::uint32_t>(state.runs.size());
    const auto drawn = device_->allocate(8 * state.runs.size() * sizeof(Run));
    const auto drawn_record = device_->allocate(sizeof(FrameRecord));
    stages_.pens({.table = table(),
                  .segment_pens = *segment_pens,
                  .outline = &outline,
                  .runs = {*runs, *record, count},
                  .drawn = {*drawn, *drawn_record, 8 * count}});
    const std::uint32_t pieces = read_back<FrameRecord>(*device_, *drawn_record, 1)[0].points[0];
    return read_back<Run>(*device_, *drawn, pieces);
}

std::vector<std::uint8_t> FrameStages::strokes(const Camera& camera, const FrameState& state) {
    const glm::vec2 viewport{camera.size};
    const PictureTile whole{{0, 0}, camera.size};
    const glm::ivec2 tiles = compute::part_tiles(whole).count;
    const auto pixels = static_cast<std::uint32_t>(camera.size.x * camera.size.y);
    const auto count = static_cast<std::uint32_t>(state.runs.size());
    const std::uint32_t capacity = count * static_cast<std::uint32_t>(tiles.x * tiles.y);
    const auto runs = to_device(*device_, state.runs);
    const auto record = to_device(*device_, std::vector{state.record});
    const auto alpha = to_device(*device_, state.alpha);
    const auto mark = to_device(*device_, std::vector<float>{0, 1, 1, 0, 1});
    const auto weights = to_device(*device_, state.weights);
    const auto ends =
        device_->allocate(compute::stroke_ends(device_->tuning(), viewport) * sizeof(la_uint));
    const auto entries = device_->allocate(capacity * sizeof(la_uint));
    const auto coverage = device_->allocate(pixels);
    const auto shown = device_->allocate(capacity * sizeof(la_uint));
    const auto total = device_->allocate(sizeof(la_uint));
    const compute::StrokeLists lists{*ends, *entries, *total, capacity};
    const compute::RunTable table{*runs, *record, count};
    for (const bool again : {false, true}) {
        stages_.list_strokes({table, viewport, settings_.half_width, lists});
        stages_.draw_strokes({.runs = table,
                              .lists = lists,
                              .alpha = *alpha,
                              .viewport = viewport,
                              .part = whole,
                              .half_width = settings_.half_width,
                              .opacity = 0.7F,
                              .end_kinds = LA_STROKES_ROUND_PATHS | LA_STROKES_EXACT_ENDS,
                              .mark = mark.get(),
                              .mark_length = 3,
                              .repeat_length = 5,
                              .weights = weights.get(),
                              .again = again,
                              .coverage = *coverage,
                              .shown = *shown,
                              .layer = 0,
                              .pitch = pixels});
    }
    // The stage does not write tiles in which nothing shows.
    std::vector<std::uint8_t> result = read_back<std::uint8_t>(*device_, *coverage, pixels);
    const auto shows = read_back<la_uint>(*device_, *shown, tiles.x * tiles.y);
    for (std::uint32_t i = 0; i < pixels; ++i) {
        const int x = static_cast<int>(i) % camera.size.x, y = static_cast<int>(i) / camera.size.x;
        if (shows[y / LA_STROKE_TILE * tiles.x + x / LA_STROKE_TILE] == 0) result[i] = 0;
    }
    return result;
}

} // namespace lineatlas::test
