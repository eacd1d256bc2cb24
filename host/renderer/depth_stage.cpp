#include "depth_stage.hpp"

#include <cmath>

#include "compute/transfer.hpp"
#include "frame_forms.hpp"
#include "picture_limits.hpp"

namespace lineatlas {
namespace {

std::size_t area(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

} // namespace

std::vector<gl::TriangleRange> pieces_in_view(SceneBuffers& scene,
                                              const glm::mat4& clip_from_world) {
    if (scene.clusters().empty()) return {{0, scene.triangle_count()}};
    constexpr int steps = 1 << 12; // any grid will do
    std::vector<gl::TriangleRange> ranges;
    for (const Cluster& cluster : scene.boxes()) {
        const Bounds box{{cluster.low[0], cluster.low[1], cluster.low[2]},
                         {cluster.high[0], cluster.high[1], cluster.high[2]}};
        const TexelRectangle covered = screen_bounds(box, clip_from_world, {steps, steps}, 1, 1);
        if (covered.size().x == 0 || covered.size().y == 0) continue;
        const bool follows =
            !ranges.empty() && ranges.back().first + ranges.back().count == cluster.first;
        if (follows)
            ranges.back().count += cluster.count;
        else
            ranges.push_back({cluster.first, cluster.count});
    }
    return ranges;
}

DepthStage::DepthStage(const interop::Connection& connection)
    : stages_(*connection.stages), device_(stages_.device()), surfaces_(connection),
      depth_(*connection.sharing, compute::table::depth_texels),
      tiles_(*connection.sharing, compute::table::pyramid) {}

DepthStage::~DepthStage() {
    if (copy_of_seen_ == Copy::begun) compute::end_transfers(device_);
}

void DepthStage::set_scene(const SceneBuffers& scene) {
    surfaces_.set_scene();
    // Nothing is known yet, so the first frame draws all clusters.
    const bool culls = scene.triangle_count() >= fewest_culled_triangles();
    seen_.assign(culls ? scene.clusters().size() : 0, 1);
    clusters_ = scene.all_clusters();
    appeared_.resize(clusters_.size());
    ranges_.reserve(clusters_.size()); // frames allocate nothing
    visible_.release();
    visible_.fit(clusters_.size() * sizeof(la_uint));
}

void DepthStage::choose_form(const Frame& frame) {
    imported_ = frame.options.own_depth.has_value();
    by_kernels_ = wants_kernels(frame);
    // GL overwrites what kernels drew, or replaces the buffers.
    if (!by_kernels_) blank_of_.reset();
}

void DepthStage::prepare(const Frame& frame) {
    const glm::ivec2 texels = frame.camera.size * frame.depth_scale();
    // Kernels draw the numbers of triangles, and nobody reads their depth.
    if (!by_kernels_) depth_.fit(area(texels) * sizeof(float));
    tiles_.fit(area(compute::tiles_for(texels)) * sizeof(float));
}

compute::DepthTile DepthStage::draw_tile(Frame& frame, const PictureTile& tile) {
    const int scale = frame.depth_scale();
    const glm::ivec2 whole = frame.camera.size * scale;
    const int reach = probe_margin(frame.options.step, scale);
    const glm::ivec2 low = glm::max(tile.low * scale - reach, 0);
    const glm::ivec2 size = glm::min((tile.low + tile.size) * scale + reach, whole) - low;
    check_depth_size(size);
    choose_form(frame);
    imported_ = false;
    if (by_kernels_) {
        draw_by_kernels(frame, whole, {low, low + size}, {{0, 0}, size});
    } else {
        draw_tile_by_gl(frame, whole, {low, low + size});
    }
    // Lines end at the picture's borders, or a rounding beyond, so tiles at a border reach far.
    constexpr int far = 1 << 30;
    const glm::ivec2 core = tile.low * scale;
    const glm::ivec2 core_end = (tile.low + tile.size) * scale;
    return {.origin = low,
            .core_low = {core.x == 0 ? -far : core.x, core.y == 0 ? -far : core.y},
            .core_high = {core_end.x == whole.x ? far : core_end.x,
                          core_end.y == whole.y ? far : core_end.y}};
}

void DepthStage::draw_tile_by_gl(Frame& frame, glm::ivec2 whole, const TexelRectangle& part) {
    const glm::ivec2 low = part.low, size = part.size();
    depth_.fit(area(size) * sizeof(float));
    surfaces_.begin(frame, size);
    frame.clock.gl("depth", [&] {
        const glm::mat4 clip = frame.camera.clip_from_world();
        ranges_ = pieces_in_view(frame.scene, tile_projection(clip, {low, size}, whole));
        pass_.begin(size, 1, surfaces_.known());
        pass_.draw_ranges(frame.scene.gl_triangles(), clip, ranges_,
                          tile_transform({low, size}, whole));
        pass_.copy_to(depth_.gl_to_write(), {{0, 0}, size});
    });
    for (const gl::TriangleRange& range : ranges_) triangles_drawn_ += range.count;
    copy_surfaces(frame, {{0, 0}, size});
}

bool DepthStage::wants_kernels(const Frame& frame) const {
    return wants_depth_kernels(frame.options, frame.automatic);
}

compute::Buffer& DepthStage::blank_tiles() {
    const std::size_t words = compute::divide_up(compute::count_of_tiles(size_), sizeof(la_uint));
    if (blank_of_ == size_) return *blank_;
    blank_of_.reset();
    blank_.fit(words * sizeof(la_uint));
    device_.clear(*blank_, words * sizeof(la_uint));
    blank_of_ = size_;
    return *blank_;
}

void DepthStage::draw_by_kernels(Frame& frame, glm::ivec2 whole, const TexelRectangle& part,
                                 const TexelRectangle& covered) {
    size_ = part.size();
    drawn_texels_ = covered;
    tiles_.fit(area(compute::tiles_for(size_)) * sizeof(float));
    surfaces_.begin(frame, size_);
    frame.clock("depth", [&] {
        stages_.depth({.model = frame.scene.meshlets(),
                       .vertices = frame.scene.candidate_table().vertices,
                       .clip_from_world = frame.camera.clip_from_world(),
                       .whole_size = whole,
                       .origin = part.low,
                       .size = size_,
                       .covered = covered,
                       .tiles = tiles_.compute(),
                       .seen = *visible_,
                       .numbers = &surfaces_.numbers()->compute(),
                       .blank = &blank_tiles()});
    });
    surfaces_.find_planes(frame, visible_.get());
    drawn_is_known_ = false;
    copy_of_seen_ = Copy::none;
}

void DepthStage::draw_by_kernels(Frame& frame) {
    const glm::ivec2 texels = frame.camera.size * frame.depth_scale();
    triangles_drawn_ = 0;
    draw_by_kernels(frame, texels, {{0, 0}, texels}, covered(frame));
    device_.begin_download(*visible_, std::as_writable_bytes(std::span{appeared_}));
    copy_of_seen_ = Copy::begun;
}

void DepthStage::find_drawn() {
    if (drawn_is_known_) return;
    drawn_is_known_ = true;
    if (copy_of_seen_ == Copy::none)
        device_.download(*visible_, std::as_writable_bytes(std::span{appeared_}));
    if (copy_of_seen_ == Copy::begun) device_.finish();
    copy_of_seen_ = Copy::done;
    ranges_.clear();
    add_drawn(clusters_, appeared_);
}

void DepthStage::fill_texture(Frame& frame) {
    if (!by_kernels_) return;
    frame.clock.gl("depth",
                   [&] { pass_.load_numbers(surfaces_.numbers()->gl(), size_, covered(frame)); });
}

TexelRectangle DepthStage::covered(const Frame& frame) const {
    const int reach =
        static_cast<int>(std::ceil(LA_PROBE_REACH(static_cast<float>(frame.depth_scale()))));
    return screen_bounds(frame.scene.bounds(), frame.camera.clip_from_world(),
                         frame.camera.size * frame.depth_scale(), reach + 1, LA_TILE);
}

void DepthStage::import_depth(Frame& frame) {
    if (!import_) import_.emplace();
    frame.clock.gl("depth", [&] {
        const DepthTexture& own = *frame.options.own_depth;
        import_->draw(own.texture, own.origin, frame.camera.size * own.scale, covered(frame),
                      frame.depth_mapping);
    });
    triangles_drawn_ = 0;
    ranges_.assign(1, {0, frame.scene.triangle_count()});
}

void DepthStage::draw_texture(Frame& frame) {
    choose_form(frame);
    if (by_kernels_) {
        prepare(frame);
        draw_by_kernels(frame);
        return fill_texture(frame);
    }
    drawn_is_known_ = true;
    draw_raster(frame);
    surfaces_.find_planes(frame, nullptr);
}

void DepthStage::draw_raster(Frame& frame) {
    surfaces_.begin(frame, frame.camera.size * frame.depth_scale());
    if (imported_) return import_depth(frame);
    frame.clock.gl("depth", [&] {
        pass_.begin(frame.camera.size, frame.depth_scale(), surfaces_.known());
        pass_.draw(frame.scene.gl_triangles(), frame.camera.clip_from_world());
        triangles_drawn_ = frame.scene.triangle_count();
        ranges_.assign(1, {0, triangles_drawn_});
    });
}

void DepthStage::draw_for_compute(Frame& frame) {
    choose_form(frame);
    prepare(frame);
    if (by_kernels_) return draw_by_kernels(frame);
    drawn_is_known_ = true;
    if (imported_ || !frame.culls_hidden() || seen_.empty()) {
        draw_raster(frame);
        build_pyramid(frame);
        return copy_surfaces(frame, covered(frame));
    }
    surfaces_.begin(frame, frame.camera.size * frame.depth_scale());
    triangles_drawn_ = 0;
    ranges_.clear();
    frame.clock.gl("depth",
                   [&] { pass_.begin(frame.camera.size, frame.depth_scale(), surfaces_.known()); });
    draw_clusters(frame, seen_);
    build_pyramid(frame);
    const std::vector<std::uint32_t>& visible = appeared_;
    cull(frame, appeared_);
    bool any = false;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        const bool appears = visible[i] != 0 && seen_[i] == 0;
        any = any || appears;
        seen_[i] = visible[i];
        appeared_[i] = appears ? 1 : 0;
    }
    if (any) {
        draw_clusters(frame, appeared_);
        build_pyramid(frame);
    }
    copy_surfaces(frame, covered(frame));
}

void DepthStage::copy_surfaces(Frame& frame, const TexelRectangle& part) {
    if (!surfaces_.known()) return;
    frame.clock.gl("depth",
                   [&] { pass_.copy_numbers_to(surfaces_.numbers()->gl_to_write(), part); });
    surfaces_.find_planes(frame, nullptr);
}

compute::DepthBuffer DepthStage::probed(Frame& frame) {
    return {.texels = by_kernels_ ? surfaces_.numbers()->compute() : depth_.compute(),
            .size = size(),
            .scale = static_cast<float>(frame.depth_scale()),
            .tolerance = frame.depth_tolerance(),
            .surfaces = surfaces_.tables(frame)};
}

gl::ProbeParams DepthStage::probed_by_gl(Frame& frame) {
    gl::ProbeParams params = frame.probe_params(texture());
    params.surfaces = surfaces_.textures(frame, pass_.numbers());
    return params;
}

void DepthStage::build_pyramid(Frame& frame) {
    frame.clock.gl("depth", [&] {
        if (imported_)
            import_->copy_to(depth_.gl_to_write(), covered(frame));
        else
            pass_.copy_to(depth_.gl_to_write(), covered(frame));
    });
    if (!frame.culls_hidden()) return;
    frame.clock("pyramid", [&] { stages_.pyramid(depth_.compute(), size(), tiles_.compute()); });
}

void DepthStage::draw_clusters(Frame& frame, const std::vector<std::uint32_t>& selected) {
    frame.clock.gl("depth", [&] {
        const std::size_t drawn_before = ranges_.size();
        add_drawn(frame.scene.clusters(), selected);
        pass_.draw_ranges(frame.scene.gl_triangles(), frame.camera.clip_from_world(),
                          std::span{ranges_}.subspan(drawn_before));
    });
}

void DepthStage::add_drawn(std::span<const Cluster> clusters,
                           const std::vector<std::uint32_t>& selected) {
    for (std::size_t i = 0; i < clusters.size(); ++i) {
        if (selected[i] == 0) continue;
        triangles_drawn_ += clusters[i].count;
        const bool follows = i > 0 && selected[i - 1] != 0 &&
                             clusters[i - 1].first + clusters[i - 1].count == clusters[i].first;
        if (follows)
            ranges_.back().count += clusters[i].count;
        else
            ranges_.push_back({clusters[i].first, clusters[i].count});
    }
}

void DepthStage::cull(Frame& frame, std::vector<std::uint32_t>& visible) {
    frame.clock("cull", [&] {
        const auto count = static_cast<std::uint32_t>(visible.size());
        stages_.launch<compute::kernels::cull>(count,
                                               {.count = count,
                                                .clip_from_world = frame.camera.clip_from_world(),
                                                .depth_size = size(),
                                                .tile_count = compute::tiles_for(size())},
                                               {.clusters = frame.scene.cluster_buffer(),
                                                .tiles = tiles_.compute(),
                                                .visible = *visible_});
        device_.download(*visible_, std::as_writable_bytes(std::span{visible}));
    });
}

} // namespace lineatlas
