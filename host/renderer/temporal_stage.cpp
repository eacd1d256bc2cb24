#include "temporal_stage.hpp"

#include "frame_forms.hpp"

namespace lineatlas {
namespace {

// In faster motion nobody follows a line, so sparkling is not seen.
constexpr float slow_pixels = 4;

} // namespace

void LastFrame::take(const Frame& frame) {
    camera = frame.camera;
    probes = frame.options.probes;
    depth_scale = frame.depth_scale();
    step = frame.options.step;
    transforms = frame.scene.motion().transforms(); // reuses its memory
    shape_version = frame.scene.motion().shape_version();
}

std::optional<float> LastFrame::motion_to(const Frame& frame) const {
    const SceneMotion& scene = frame.scene.motion();
    const bool has_same_samples = probes == frame.options.probes &&
                                  depth_scale == frame.depth_scale() &&
                                  step == frame.options.step && camera.size == frame.camera.size &&
                                  shape_version == scene.shape_version();
    if (!has_same_samples) return std::nullopt;
    const float motion = scene.typical_motion(camera, transforms, frame.camera);
    return motion <= slow_pixels ? std::optional{motion} : std::nullopt;
}

bool TemporalStage::wanted(const Frame& frame) {
    return wants_steadiness(frame.options) && frame.scene.chunk_count() == 1;
}

void TemporalStage::release() {
    for (compute::Table* table : {&alpha_, &offsets_, &ranges_, &positions_}) table->release();
    last_.reset();
}

void TemporalStage::begin_frame(const Frame& frame) {
    if (!wanted(frame)) last_.reset();
    motion_ = last_ ? last_->motion_to(frame) : std::nullopt;
}

void TemporalStage::make_tables(const compute::SegmentTable& table, std::size_t atlas_bytes) {
    if (!offsets_) {
        const std::size_t segments = table.segment_count;
        offsets_.fit((segments + 1) * sizeof(la_uint));
        ranges_.fit(segments * sizeof(la_uint));
        positions_.fit(table.candidates.count * sizeof(la_uint));
        device_.clear(*ranges_, segments * sizeof(la_uint));
        forget_chains(table);
    }
    if (alpha_.fit(atlas_bytes)) last_.reset();
}

void TemporalStage::forget_chains(const compute::SegmentTable& table) {
    device_.clear(*positions_, std::size_t{table.candidates.count} * sizeof(la_uint));
}

void TemporalStage::average(Frame& frame, const compute::SegmentAtlas& atlas,
                            compute::SilhouetteChains& chains) {
    if (!wanted(frame)) return;
    frame.clock("temporal", [&] {
        const compute::SegmentTable table = frame.scene.candidate_table();
        make_tables(table, atlas.alpha.size());
        std::uint32_t use = LA_HISTORY_NONE;
        if (motion_ && last_) {
            frame.scene.forget_jumps(last_->transforms, frame.camera, slow_pixels, *ranges_);
            const bool moved = last_->transforms != frame.scene.motion().transforms();
            use = moved ? LA_HISTORY_SCENE : LA_HISTORY_CAMERA;
        }
        std::optional<compute::ChainOrder> order;
        if (chains.has_order()) order.emplace(chains.order(table, *positions_));
        stages_.temporal({.segment_count = frame.scene.table().segment_count,
                          .atlas = atlas,
                          .history = {*alpha_, *offsets_, *ranges_},
                          .use = use,
                          .chains = order ? &*order : nullptr});
        if (!order) forget_chains(table);
        if (!last_) last_.emplace();
        last_->take(frame);
    });
}

} // namespace lineatlas
