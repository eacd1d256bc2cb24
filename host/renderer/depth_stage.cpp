#include "depth_stage.hpp"

#include <algorithm>
#include <cmath>

namespace lineatlas {
namespace {

std::size_t area(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

} // namespace

DepthStage::DepthStage(const interop::Connection& connection)
    : backend_(*connection.backend), mode_(connection.mode), handover_(backend_) {}

void DepthStage::set_scene(const SceneBuffers& scene) {
    seen_.assign(scene.clusters().size(), 1); // nothing is known yet: the first frame draws all
    appeared_.resize(seen_.size());
    visible_ = backend_.allocate(seen_.size());
}

void DepthStage::prepare(const Frame& frame) {
    const glm::ivec2 size = frame.camera.size * frame.options.depth_scale;
    const std::size_t depth_bytes = area(size) * sizeof(float);
    if (!depth_ || depth_->size() < depth_bytes) {
        depth_ = interop::make_shared_buffer(backend_, mode_, depth_bytes);
    }
    const std::size_t tile_bytes = area(compute::tiles_for(size)) * sizeof(float);
    if (!tiles_ || tiles_->size() < tile_bytes) {
        tiles_ = interop::make_shared_buffer(backend_, mode_, tile_bytes);
    }
}

void DepthStage::draw_texture(Frame& frame) {
    frame.clock("depth", [&] {
        pass_.begin(frame.camera.size, frame.options.depth_scale);
        pass_.draw(frame.scene.gl_triangles(), frame.camera.clip_from_world());
        triangles_drawn_ = frame.scene.triangle_count();
        ranges_.assign(1, {0, triangles_drawn_});
    });
}

void DepthStage::draw_for_compute(Frame& frame) {
    prepare(frame);
    if (!frame.culls_hidden() || seen_.empty()) {
        draw_texture(frame);
        return build_pyramid(frame);
    }
    triangles_drawn_ = 0;
    ranges_.clear();
    frame.clock("depth", [&] { pass_.begin(frame.camera.size, frame.options.depth_scale); });
    draw_clusters(frame, seen_);
    build_pyramid(frame);
    const std::vector<std::uint8_t>& visible = appeared_;
    cull(frame, appeared_);
    bool any = false;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        const bool appears = visible[i] != 0 && seen_[i] == 0;
        any = any || appears;
        seen_[i] = visible[i];
        appeared_[i] = appears ? 1 : 0;
    }
    if (!any) return;
    handover_.to_gl({{*depth_, 0}, {*tiles_, 0}});
    draw_clusters(frame, appeared_);
    build_pyramid(frame);
}

void DepthStage::take_back() {
    const std::size_t tile_bytes = area(compute::tiles_for(pass_.size())) * sizeof(float);
    handover_.to_gl({{*depth_, 0}, {*tiles_, tile_bytes}});
}

void DepthStage::build_pyramid(Frame& frame) {
    // Whole tiles with all that a probe may reach: beside them, what the buffer holds is never
    // read.
    const int reach =
        static_cast<int>(std::ceil(LA_PROBE_REACH(static_cast<float>(frame.options.depth_scale))));
    const TexelRectangle covered = screen_bounds(
        frame.scene.bounds(), frame.camera.clip_from_world(), pass_.size(), reach + 1, LA_TILE);
    frame.clock("depth", [&] { pass_.copy_to(depth_->gl(), covered); });
    frame.clock("handover", [&] {
        handover_.to_compute({{*depth_, area(pass_.size()) * sizeof(float)}, {*tiles_, 0}});
    });
    if (!frame.culls_hidden()) return;
    frame.clock("pyramid", [&] {
        backend_.pyramid(
            {.depth = depth_->compute(), .depth_size = pass_.size(), .tiles = tiles_->compute()});
    });
}

void DepthStage::draw_clusters(Frame& frame, const std::vector<std::uint8_t>& selected) {
    frame.clock("depth", [&] {
        const std::span<const Cluster> clusters = frame.scene.clusters();
        const std::size_t drawn_before = ranges_.size();
        for (std::size_t i = 0; i < clusters.size(); ++i) {
            if (selected[i] == 0) continue;
            triangles_drawn_ += clusters[i].count;
            const bool follows = i > 0 && selected[i - 1] != 0;
            if (follows)
                ranges_.back().count += clusters[i].count;
            else
                ranges_.push_back({clusters[i].first, clusters[i].count});
        }
        pass_.draw_ranges(frame.scene.gl_triangles(), frame.camera.clip_from_world(),
                          std::span{ranges_}.subspan(drawn_before));
    });
}

void DepthStage::cull(Frame& frame, std::vector<std::uint8_t>& visible) {
    frame.clock("cull", [&] {
        backend_.cull({.clusters = frame.scene.cluster_buffer(),
                       .count = static_cast<std::uint32_t>(visible.size()),
                       .clip_from_world = frame.camera.clip_from_world(),
                       .depth_size = pass_.size(),
                       .tiles = tiles_->compute(),
                       .visible = *visible_});
        backend_.download(*visible_, std::as_writable_bytes(std::span{visible}));
    });
}

} // namespace lineatlas
