#include "atlas_method.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "backdrop.hpp"
#include "compute/transfer.hpp"
#include "frame_forms.hpp"
#include "glpasses/storage.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

// A first guess; a frame that needs more makes its tables grow.
constexpr std::uint32_t first_sample_capacity = 1U << 16U;

// The most by which a coordinate shifts, in pixels. Nobody sees less than half a pixel. Lines
// themselves move by at least as much.
constexpr float most_shift = 0.4F;

/// The most samples that a segment can have.
std::uint32_t longest_segment(const Frame& frame) {
    const float diagonal = glm::length(frame.viewport());
    return static_cast<std::uint32_t>(std::ceil(diagonal / frame.options.step)) + 1;
}

} // namespace

AtlasMethod::AtlasMethod(const interop::Connection& connection)
    : stages_(*connection.stages), device_(stages_.device()), sharing_(*connection.sharing),
      depth_(connection), fill_(connection),
      chains_(stages_, compute::SilhouetteChains::Contours::lifted), carried_(stages_),
      batches_(stages_), temporal_(stages_), outlines_(stages_),
      clipped_(sharing_, compute::table::clipped), offsets_(sharing_, compute::table::offsets),
      alpha_(sharing_, compute::table::alpha), strokes_(connection), intervals_(stages_) {
    largest_side_ = gl::largest_side();
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &largest_texture_buffer_);
}

AtlasMethod::~AtlasMethod() {
    if (counts_come_) compute::end_transfers(device_);
}

void AtlasMethod::release_scene() {
    chains_.release();
    batches_.release();
    carried_.release();
    arcs_.release();
    temporal_.release();
    clipped_.release();
    offsets_.release();
}

void AtlasMethod::set_scene(const SceneBuffers& scene, const SceneBuffers::Tables& tables) {
    release_scene();
    silhouettes_grew_ = false;
    strokes_.forget_lines();
    make_segment_tables(tables.most_fixed_segments());
    depth_.set_scene(scene);
    fill_.set_scene();
}

void AtlasMethod::make_segment_tables(std::size_t segments) {
    arcs_.release(); // others may not fit beside these
    clipped_.release();
    offsets_.release();
    const std::size_t sums = (segments + 1) * sizeof(std::uint32_t);
    clipped_.fit(segments * sizeof(ClippedSegment));
    offsets_.fit(sums);
    arcs_.fit(sums);
}

void AtlasMethod::make_atlas(const Frame& frame) {
    const std::uint64_t most_texels =
        std::min(static_cast<std::uint64_t>(largest_texture_buffer_), device_.largest_buffer());
    const auto longest_row =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(largest_side_, most_texels));
    row_ = raster_ ? gl::atlas_row(longest_segment(frame), longest_row) : 1;
    most_samples_ = most_texels / row_ * row_;
    sample_capacity_ = static_cast<std::uint32_t>(
        std::min<std::uint64_t>(std::max(sample_capacity_, first_sample_capacity), most_samples_));
    if (alpha_.room() < rows(sample_capacity_) * row_) alpha_.fit(rows(sample_capacity_) * row_);
}

void AtlasMethod::prepare(const Frame& frame) {
    check_depth_size(frame.camera.size * frame.depth_scale());
    // An item buffer counts as the raster form, because its depth is not for kernels either.
    raster_ = frame.options.method == Method::item_buffer ||
              frame.options.forms.atlas == StageForm::raster ||
              (frame.options.forms.atlas == StageForm::automatic && !frame.automatic.atlas &&
               longest_segment(frame) < static_cast<std::uint32_t>(largest_side_));
    make_atlas(frame);
    cull_hidden_ = frame.culls_hidden();
    keeps_intervals_ = IntervalStage::wanted(frame);
    // The item buffer has no depth that kernels could look at.
    finds_outlines_ = frame.options.method == Method::atlas && needs_outlines(frame.options);
}

void AtlasMethod::begin_chunk(Frame& frame, std::size_t chunk) {
    if (chunk == 0) {
        strokes_.begin_frame(frame);
        intervals_.begin_frame(frame);
    }
    frame.scene.select(chunk);
    all_segments_ = frame.scene.candidate_table().segment_count;
}

void AtlasMethod::keep_chunk(Frame& frame) {
    if (frame.scene.chunk_count() == 1) return;
    strokes_.keep(frame, alpha_, strokes_.sample_total());
    intervals_.keep(frame, order(), read_offsets());
}

void AtlasMethod::find_silhouettes(Frame& frame) {
    temporal_.begin_frame(frame);
    chains_.follow(temporal_.positions_before());
    const bool wanted = (frame.kinds() & mask_of(LineKind::silhouette)) != 0;
    frame.scene.set_order(chains_.table_of(
        frame.scene.candidate_table(), wanted,
        compute::silhouette_view(frame.camera, frame.scene.bounds()), frame.clock));
    if (chains_.has_many_more()) temporal_.forget();
    segment_count_ = frame.scene.table().segment_count;
    if (arcs_.bytes() > segment_count_ * sizeof(la_uint)) return;
    make_segment_tables(silhouettes_grew_
                            ? compute::room_to_grow(device_, segment_count_, sizeof(ClippedSegment))
                            : segment_count_);
    silhouettes_grew_ = true; // the tables fit the first frame, so only later frames make them grow
}

std::vector<std::uint32_t> AtlasMethod::read_offsets() {
    if (!chains_.has_order()) return {};
    return compute::read_back<std::uint32_t>(device_, offsets_.compute(),
                                             std::size_t{segment_count_} + 1);
}

void AtlasMethod::project(Frame& frame) {
    find_silhouettes(frame);
    const compute::OcclusionTest occlusion{
        .tiles = cull_hidden_ ? depth_.tiles().compute() : *arcs_, // without culling it is not
                                                                   // read, and any buffer will do
        .tile_count = compute::tiles_for(depth_.size()),
        .depth_scale = static_cast<float>(frame.depth_scale()),
        .tolerance = frame.depth_tolerance(),
        .keep_clipped = StrokeStage::draws_hidden(frame) || IntervalStage::wants_hidden(frame)};
    frame.clock("project_clip", [&] {
        compute::BatchTable batches;
        if (batches_.has_segments(frame.scene.candidate_table())) batches = batches_.table();
        const compute::ProjectClipArgs args{
            .table = frame.scene.table(),
            .front = chains_.front(),
            .clip_from_world = frame.camera.clip_from_world(),
            .viewport = frame.viewport(),
            .step = frame.options.step,
            .kind_mask = frame.kinds(),
            .occlusion = cull_hidden_ ? &occlusion : nullptr,
            .out = clipped_table(),
            .numbers = frame.knows_surfaces() ? &frame.scene.surfaces().numbers : nullptr,
            .batches = batches,
            .centre_overhang = frame.options.style.centre_overhang};
        if (batches.count > 0) {
            const bool drops_hidden = cull_hidden_ && frame.knows_surfaces() && !keeps_intervals_ &&
                                      !strokes_.measures_lines(frame);
            stages_.project_clip_batches(args, drops_hidden);
        }
        stages_.project_clip(args);
    });
    frame.clock("scan", [&] {
        stages_.scan(offsets_.compute(), segment_count_, compute::ScanKind::saturate);
        stages_.scan(*arcs_, segment_count_, compute::ScanKind::wrap);
    });
    carry(frame);
}

void AtlasMethod::carry(Frame& frame) {
    const bool carries = carries_ && chains_.has_order();
    strokes_.carry(carries ? &carried_ : nullptr);
    if (!carries || !temporal_.motion()) carried_.forget();
    if (!carries) return;
    frame.clock("carry", [&] {
        carried_.find(frame.scene.table(), chains_.first(), clipped_table(), frame.viewport(),
                      std::min(temporal_.motion().value_or(0), most_shift));
    });
}

void AtlasMethod::sample(Frame& frame) {
    if (frame.options.method == Method::item_buffer) return sample_item_buffer(frame);
    if (raster_) return sample_raster(frame);
    sample_compute(frame);
}

void AtlasMethod::sample_compute(Frame& frame) {
    frame.clock("atlas", [&] { stages_.atlas(atlas_args(frame)); });
}

bool AtlasMethod::leaves_raster(const Frame& frame, std::uint32_t samples) const {
    return frame.options.forms.atlas == StageForm::automatic &&
           rows(samples) > static_cast<std::uint32_t>(largest_side_);
}

compute::AtlasArgs AtlasMethod::atlas_args(Frame& frame) {
    return {.segment_count = segment_count_,
            .atlas = segment_atlas(),
            .depth = depth_.probed(frame),
            .viewport = frame.viewport(),
            .probes = frame.probes_per_axis()};
}

void AtlasMethod::sample_raster(Frame& frame) {
    if (reads_depth()) depth_.fill_texture(frame);
    sharing_.to_gl({&clipped_, &offsets_, &alpha_});
    // The total decides how many rows are drawn and read, so the host needs it here.
    std::uint32_t total = 0;
    frame.clock.gl("atlas", [&] {
        glGetNamedBufferSubData(offsets_.gl(),
                                static_cast<GLintptr>(segment_count_ * sizeof(total)),
                                sizeof(total), &total);
        if (total > sample_capacity_) return; // grow() sees to it
        if (leaves_raster(frame, total)) return;
        alpha_.set_size(total);
        atlas_pass_.draw(
            {.clipped = clipped_.gl(), .offsets = offsets_.gl(), .segment_count = segment_count_},
            depth_.probed_by_gl(frame), row_, total, alpha_.gl_to_write());
    });
    if (total > sample_capacity_ || !leaves_raster(frame, total)) return;
    if (!reads_depth()) depth_.draw_for_compute(frame);
    raster_ = false;
    sample_compute(frame);
}

void AtlasMethod::sample_item_buffer(Frame& frame) {
    frame.clock("item_buffer", [&] {
        if (!item_buffer_) item_buffer_.emplace();
        ItemBufferSampler::Lines& lines = item_buffer_->lines();
        compute::read_into(lines.offsets, device_, offsets_.compute(),
                           std::size_t{segment_count_} + 1);
        if (lines.offsets.back() > sample_capacity_) return; // grow() sees to it
        compute::read_into(lines.clipped, device_, clipped_.compute(), segment_count_);
        alpha_.upload(std::as_bytes(item_buffer_->sample(frame)));
    });
}

bool AtlasMethod::grow_atlas(std::uint64_t needed) {
    if (needed <= sample_capacity_) return false;
    if (needed > most_samples_) {
        const bool uncountable = needed == 0xFFFFFFFFU;
        throw DeviceError(beyond_limit(
            purpose::atlas, (uncountable ? "over 4 billion" : std::to_string(needed)) + " samples",
            "this device's atlas holds " + std::to_string(most_samples_)));
    }
    alpha_.release(); // makes room for another
    sample_capacity_ =
        static_cast<std::uint32_t>(std::min(compute::room_to_grow(device_, needed), most_samples_));
    alpha_.fit(rows(sample_capacity_) * row_);
    return true;
}

bool AtlasMethod::grow() {
    const bool atlas_grown = grow_atlas(strokes_.sample_total());
    const bool intervals_grown = intervals_.grow();
    return strokes_.grow() || intervals_grown || atlas_grown;
}

void AtlasMethod::find_once(Frame& frame) {
    sample(frame);
    temporal_.average(frame, segment_atlas(), chains_);
    std::optional<compute::OutlineTable> outline;
    if (finds_outlines_) outline.emplace(outlines_.find(frame, segment_atlas(), depth_));
    intervals_.find(frame, segment_atlas(), depth_);
    strokes_.make_runs(frame, segment_atlas(), nullptr, outline ? &*outline : nullptr);
}

void AtlasMethod::find(Frame& frame) {
    do {
        find_once(frame);
    } while (grow());
    depth_.device_is_done(); // the number of runs was waited for
    alpha_.set_size(strokes_.sample_total());
    if (finds_outlines_ && keeps_intervals_)
        intervals_.add_outlines(frame, outlines_.found(), order());
    keep_chunk(frame);
}

bool AtlasMethod::may_be_late(const Frame& frame) const {
    return frame.options.draw && !frame.automatic.waits_freely && !raster_ && !keeps_intervals_ &&
           frame.options.method == Method::atlas && frame.scene.chunk_count() == 1 &&
           strokes_.draws_any_by_kernels();
}

void AtlasMethod::draw_late(Frame& frame) {
    strokes_.begin_late();
    for (bool again = true; again;) {
        find_once(frame);
        strokes_.draw_late(frame, alpha_);
        if (chains_.settle()) {
            again = grow();
            continue;
        }
        temporal_.forget(); // it has taken a frame with gaps for the last one
        project(frame);
    }
    counts_come_ = false;
    segment_count_ = chains_.first() + chains_.count();
    depth_.device_is_done();
    alpha_.set_size(strokes_.sample_total());
    fill_.draw(frame, depth_);
    strokes_.show(frame);
}

FrameStats AtlasMethod::draw(Frame& frame) {
    prepare(frame);
    begin_chunk(frame, 0);
    counts_come_ = may_be_late(frame);
    chains_.guess(counts_come_);
    carries_ = TemporalStage::wanted(frame) && strokes_.has_textures(frame);
    // Projection needs nothing of depth but the pyramid. Without the pyramid both run at the same
    // time.
    if (!cull_hidden_) {
        project(frame);
        device_.flush();
    }
    if (reads_depth())
        depth_.draw_for_compute(frame);
    else if (frame.options.method != Method::item_buffer)
        depth_.draw_texture(frame);
    if (cull_hidden_) project(frame);
    if (counts_come_) {
        draw_late(frame);
        return stats();
    }
    find(frame);
    for (std::size_t chunk = 1; chunk < frame.scene.chunk_count(); ++chunk) {
        begin_chunk(frame, chunk);
        project(frame);
        find(frame);
    }
    if (frame.options.draw) {
        if (frame.options.method == Method::item_buffer)
            frame.backdrop.draw_fill(frame, frame.options.style.fill);
        else
            fill_.draw(frame, depth_);
        strokes_.draw(frame, alpha_);
    }
    return stats();
}

FrameStats AtlasMethod::stats() {
    return {.triangles_drawn = depth_.triangles_drawn(),
            .samples = strokes_.samples_of_frame(),
            .runs = strokes_.runs_of_frame(),
            .stages = {}};
}

Renderer::Samples AtlasMethod::read_samples() {
    Renderer::Samples result{.offsets = compute::read_back<std::uint32_t>(
                                 device_, offsets_.compute(), std::size_t{segment_count_} + 1),
                             .alpha = compute::read_back<std::uint8_t>(device_, alpha_.compute(),
                                                                       strokes_.sample_total()),
                             .runs = strokes_.read_runs(),
                             .density = strokes_.read_density()};
    const TableOrder in_chains = order();
    in_chains.restore(all_segments_, result.offsets, result.alpha);
    in_chains.restore(result.runs);
    return result;
}

} // namespace lineatlas
