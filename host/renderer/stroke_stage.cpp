#include "stroke_stage.hpp"

#include <algorithm>

#include <glm/gtc/matrix_inverse.hpp>

#include "compute/transfer.hpp"
#include "frame_forms.hpp"

namespace lineatlas {
namespace {

// A first guess; a frame that needs more makes its tables grow.
constexpr std::uint32_t first_run_capacity = 1U << 13U;

std::span<std::byte> bytes_of(FrameRecord& record) {
    return std::as_writable_bytes(std::span{&record, 1});
}

} // namespace

StrokeStage::StrokeStage(const interop::Connection& connection)
    : stages_(*connection.stages), device_(stages_.device()), sharing_(*connection.sharing),
      visible_(sharing_), hidden_(sharing_), penned_(sharing_), penned_hidden_(sharing_),
      pens_(device_), thinning_{Thinning{sharing_}, Thinning{sharing_}}, coverage_(connection) {
    make_table(visible_);
}

void StrokeStage::make_table(SharedRuns& table) {
    table.capacity = compute::first_capacity<Run>(device_, first_run_capacity);
    table.runs.fit(std::size_t{table.capacity} * sizeof(Run));
    table.record.fit(sizeof(FrameRecord));
}

void StrokeStage::read_totals(SharedRuns& table) {
    if (late_) return device_.begin_download(table.record.compute(), bytes_of(table.totals));
    device_.download(table.record.compute(), bytes_of(table.totals));
    use_totals(table);
}

void StrokeStage::use_totals(SharedRuns& table) {
    table.runs.set_size(std::size_t{table.totals.points[0]} * sizeof(Run));
}

void StrokeStage::use_all_totals() {
    use_totals(visible_);
    if (has_hidden_) use_totals(hidden_);
    for (const bool hidden : {false, true})
        if (tells_pens(hidden)) use_totals(penned(hidden));
}

void StrokeStage::prepare(const Frame& frame) {
    const Style& style = frame.options.style;
    has_hidden_ = draws_hidden(frame);
    filters_ = needs_filter(frame.options, pens_.pens(false));
    if (has_hidden_ && !hidden_.runs) make_table(hidden_);
    if (filters_) {
        raw_capacity_ =
            std::max(raw_capacity_, compute::first_capacity<Run>(device_, first_run_capacity));
        raw_record_.fit(sizeof(FrameRecord));
        raw_runs_.fit(std::uint64_t{raw_capacity_} * sizeof(Run));
        if (style.filter.halo > 0) cuts_.fit(std::uint64_t{raw_capacity_} * sizeof(RunCuts));
    }
    for (const bool hidden : {false, true}) {
        if (tells_pens(hidden) && !penned(hidden).runs) make_table(penned(hidden));
    }
    cells_ = compute::density_cells(frame.viewport());
    thinning(false).on = frame.options.draw && style.density.limit > 0;
    thinning(true).on = has_hidden_ && style.hidden_density > 0;
    for (Thinning& thinning : thinning_)
        if (thinning.on) make_room(thinning);
}

void StrokeStage::compact(Frame& frame, const compute::SegmentAtlas& input,
                          const compute::SpanTable* spans, bool hidden,
                          const compute::RunTable& runs) {
    const float half_width = 0.5F * pens_.widest(hidden);
    if (spans != nullptr) {
        return stages_.span_runs({.table = frame.scene.table(),
                                  .clipped = input.clipped,
                                  .spans = *spans,
                                  .viewport = frame.viewport(),
                                  .half_width = half_width,
                                  .hidden = hidden,
                                  .runs = runs});
    }
    stages_.compact({.table = frame.scene.table(),
                     .atlas = input,
                     .viewport = frame.viewport(),
                     .half_width = half_width,
                     .hidden = hidden,
                     .runs = runs});
}

void StrokeStage::make_runs(Frame& frame, const compute::SegmentAtlas& input,
                            const compute::SpanTable* spans, const compute::OutlineTable* outline) {
    prepare(frame);
    by_spans_ = spans != nullptr;
    const char* stage = by_spans_ ? "spans" : "compact";
    frame.clock(
        stage, [&] { compact(frame, input, spans, false, filters_ ? raw() : visible_.compute()); });
    if (has_hidden_) {
        frame.clock(stage, [&] {
            compact(frame, input, spans, true, hidden_.compute());
            read_totals(hidden_);
        });
        if (thinning(true).on) density(frame, input, true);
        carry(frame, hidden_);
        if (tells_pens(true)) tell_pens(frame, true, nullptr);
    }
    if (filters_) {
        if (frame.options.style.filter.halo > 0) halo(frame, input);
        filter(frame, input);
    }
    if (thinning(false).on) density(frame, input, false);
    carry(frame, visible_);
    if (tells_pens(false)) tell_pens(frame, false, outline);
    if (late_) {
        read_totals(visible_);
    } else if (coverage_.draws_any()) {
        // The wait for what is listed is enough for both.
        device_.begin_download(visible_.record.compute(), bytes_of(visible_.totals));
    } else {
        frame.clock(stage, [&] { read_totals(visible_); });
        // If segments come in chunks, the number of all runs is not known yet.
        if (frame.scene.chunk_count() == 1) coverage_.settle(runs_to_draw());
    }
    if (has_hidden_) list(frame, true);
    list(frame, false);
    if (!late_) use_totals(visible_);
}

void StrokeStage::carry(Frame& frame, SharedRuns& table) {
    if (carried_ == nullptr) return;
    frame.clock("carry", [&] { carried_->apply(table.compute()); });
}

void StrokeStage::halo(Frame& frame, const compute::SegmentAtlas& input) {
    frame.clock("halo", [&] {
        const Style& style = frame.options.style;
        stages_.halo({.table = frame.scene.table(),
                      .clipped = input.clipped,
                      .runs = raw(),
                      .viewport = frame.viewport(),
                      .halo = style.filter.halo,
                      .half_width = 0.5F * pens_.widest(false),
                      .tolerance = frame.depth_tolerance(),
                      .cuts = *cuts_});
    });
}

void StrokeStage::filter(Frame& frame, const compute::SegmentAtlas& input) {
    frame.clock("filter", [&] {
        const StrokeFilter& lengths = frame.options.style.filter;
        stages_.filter({.table = frame.scene.table(),
                        .atlas = input,
                        .viewport = frame.viewport(),
                        .half_width = 0.5F * pens_.widest(false),
                        .filter = lengths,
                        .runs = raw(),
                        .cuts = lengths.halo > 0 ? cuts_.get() : nullptr,
                        .filtered = visible_.compute()});
    });
}

void StrokeStage::tell_pens(Frame& frame, bool hidden, const compute::OutlineTable* outline) {
    frame.clock("pens", [&] {
        SharedRuns& told = penned(hidden);
        stages_.pens({.table = frame.scene.table(),
                      .segment_pens = pens_.of_segments(frame, hidden),
                      .outline = outline,
                      .runs = made(hidden).compute(),
                      .drawn = told.compute()});
        read_totals(told);
    });
}

void StrokeStage::list(Frame& frame, bool hidden) {
    if (!coverage_.draws()) return;
    frame.clock(hidden ? "strokes hidden" : "strokes", [&] {
        coverage_.list(frame, hidden, drawn(hidden).compute(), 0.5F * pens_.widest(hidden), late_);
    });
}

/// Capacity for `needed` runs. The first frame with lines gets exactly that, because it may be the
/// only one. Later frames get room to grow.
std::uint32_t StrokeStage::grown_capacity(std::uint32_t needed) const {
    return is_first_ ? needed : compute::capacity_for<Run>(device_, needed);
}

bool StrokeStage::grow(SharedRuns& table) {
    if (table.totals.run_total <= table.capacity) return false;
    table.runs.release(); // a larger table may not fit beside it
    table.capacity = grown_capacity(table.totals.run_total);
    table.runs.fit(std::size_t{table.capacity} * sizeof(Run));
    return true;
}

bool StrokeStage::grow() {
    bool grown = grow(visible_);
    if (has_hidden_ && grow(hidden_)) grown = true;
    for (const bool hidden : {false, true})
        if (tells_pens(hidden) && grow(penned(hidden))) grown = true;
    const std::uint32_t raw_total = visible_.totals.raw_run_total;
    if (filters_ && raw_total > raw_capacity_) {
        raw_capacity_ = grown_capacity(raw_total);
        grown = true;
    }
    return coverage_.grow() || grown;
}

std::uint64_t StrokeStage::runs_to_draw() {
    std::uint64_t sum = 0;
    for (const Kept& kept : kept_) sum += kept.visible.size() + kept.hidden.size();
    if (chunks_kept_) return sum;
    return std::uint64_t{drawn(false).totals.run_total} +
           (has_hidden_ ? drawn(true).totals.run_total : 0);
}

gl::StrokeStyle StrokeStage::stroke_style(Frame& frame, const Pen& pen, bool hidden) const {
    gl::StrokeStyle style{.join = pen.join,
                          .mitre_limit = pen.mitre_limit,
                          .cap = pen.cap,
                          .path_cap = pen.path_cap,
                          .cap_length = pen.cap_length,
                          .width_profile = pen.width_profile,
                          .opacity_profile = pen.opacity_profile,
                          .cap_grain = {},
                          .focus = std::nullopt,
                          .hidden = hidden,
                          .exact_ends = has_exact_ends(hidden)};
    if (pen.cap == Cap::texture || pen.path_cap == Cap::texture) {
        style.cap_grain = frame.pens.get("brush", pen.width);
    }
    const Focus& focus = frame.options.style.focus;
    if (focus.on) {
        const float unit = focus.in_scene ? frame.scene.diagonal() : frame.viewport().y;
        const glm::vec3 window{glm::vec2{focus.point} * frame.viewport(), 0};
        const glm::dmat4 clip_from_world{frame.camera.clip_from_world()};
        style.focus =
            gl::FocusParams{.in_scene = focus.in_scene,
                            .point = focus.in_scene ? glm::vec3{focus.point} : window,
                            .radius = focus.radius * unit,
                            .falloff = focus.falloff * unit,
                            .far_width = focus.width,
                            .far_opacity = hidden ? focus.hidden_opacity : focus.opacity,
                            .far_pen = frame.pens.get(
                                focus.mark.empty() || hidden ? pen.mark : focus.mark, pen.width),
                            .world_from_clip = glm::mat4{glm::inverse(clip_from_world)}};
    }
    return style;
}

bool StrokeStage::measures_lines(const Frame& frame) const {
    const Style& style = frame.options.style;
    return !frame.options.draw || style.hidden || style.density.limit > 0 ||
           needs_filter(frame.options, pens_.pens(false)) || has_textures(frame);
}

bool StrokeStage::has_textures(const Frame& frame) const {
    return lineatlas::has_textures(frame.options, pens_.pens(false), pens_.pens(true));
}

void StrokeStage::begin_frame(Frame& frame) {
    pens_.prepare(frame);
    is_first_ = visible_.totals.run_total == 0;
    coverage_.begin_frame(frame, pens_);
    kept_.clear();
    for (Thinning& thinning : thinning_) thinning.drawn_before.clear();
    chunks_kept_ = false;
    kept_samples_ = kept_runs_ = 0;
    late_ = false;
}

void StrokeStage::keep(const Frame& frame, interop::SharedTable& alpha, std::size_t alpha_bytes) {
    kept_samples_ += sample_total();
    kept_runs_ += visible_.totals.run_total;
    chunks_kept_ = true;
    if (!frame.options.draw) return;
    for (Thinning& thinning : thinning_) {
        if (!thinning.on) continue;
        thinning.drawn_before.resize(density_values());
        device_.download(*thinning.grid, std::as_writable_bytes(std::span{thinning.drawn_before}));
    }
    Kept& kept = kept_.emplace_back();
    kept.visible = read_runs(drawn(false));
    kept.visible_record = drawn(false).totals;
    if (has_hidden_) {
        kept.hidden = read_runs(drawn(true));
        kept.hidden_record = drawn(true).totals;
    }
    kept.alpha.resize(alpha_bytes);
    if (alpha_bytes > 0) device_.download(alpha.compute(), kept.alpha);
}

void StrokeStage::put_back(const Kept& kept, bool hidden, interop::SharedTable& alpha) {
    SharedRuns& table = drawn(hidden);
    table.totals = hidden ? kept.hidden_record : kept.visible_record;
    table.runs.upload(std::as_bytes(std::span{hidden ? kept.hidden : kept.visible}));
    table.record.upload(bytes_of(table.totals));
    alpha.upload(kept.alpha);
}

void StrokeStage::draw_by_kernels(Frame& frame, interop::SharedTable& alpha) {
    draw_coverage(frame, alpha);
    coverage_.show(frame);
}

void StrokeStage::draw_coverage(Frame& frame, interop::SharedTable& alpha) {
    coverage_.begin_drawing(frame);
    for (const bool hidden : {true, false}) {
        if (hidden && !has_hidden_) continue;
        Thinning& own = thinning(hidden);
        const auto draw = [&](bool again) {
            coverage_.draw(frame, hidden, drawn(hidden).compute(), alpha.compute(),
                           own.on ? &own.weights.compute() : nullptr, has_exact_ends(hidden),
                           again);
        };
        if (!chunks_kept_) draw(false);
        for (const Kept& kept : kept_) {
            put_back(kept, hidden, alpha);
            list(frame, hidden);
            draw(&kept != kept_.data());
        }
    }
    coverage_.pass_to_gl();
}

void StrokeStage::draw_late(Frame& frame, interop::SharedTable& alpha) {
    draw_coverage(frame, alpha);
    if (interop::is_for_one_device(sharing_.mode())) device_.finish(); // else GL had to wait
    use_all_totals();
}

void StrokeStage::draw(Frame& frame, interop::SharedTable& alpha) {
    coverage_.settle(runs_to_draw());
    if (coverage_.draws()) return draw_by_kernels(frame, alpha);
    for (const bool hidden : {true, false}) { // all hidden lines lie below all visible ones
        if (hidden && !has_hidden_) continue;
        const auto pens = static_cast<std::uint32_t>(pens_.pens(hidden).size());
        for (std::uint32_t pen = 0; pen < pens; ++pen) { // a pen draws the runs of all chunks
                                                         // before the next pen does
            if (!chunks_kept_) draw(frame, alpha, hidden, pen);
            for (const Kept& kept : kept_) {
                put_back(kept, hidden, alpha);
                draw(frame, alpha, hidden, pen);
            }
        }
    }
}

void StrokeStage::draw(Frame& frame, interop::SharedTable& alpha, bool hidden, std::uint32_t pen) {
    SharedRuns& table = drawn(hidden);
    Thinning& own = thinning(hidden);
    sharing_.to_gl({&table.runs, &table.record, &alpha, &own.weights});
    frame.clock.gl(hidden ? "strokes hidden" : "strokes", [&] {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.framebuffer);
        const gl::DensityWeights density =
            own.on ? gl::DensityWeights{own.weights.gl(), cells_,
                                        static_cast<float>(compute::density_cell(frame.viewport()))}
                   : gl::DensityWeights{};
        const gl::RunBuffers runs{
            .runs = table.runs.gl(), .record = table.record.gl(), .alpha = alpha.gl()};
        const std::vector<Pen>& pens = pens_.pens(hidden);
        gl::StrokeStyle of_pen = stroke_style(frame, pens[pen], hidden);
        if (pens.size() > 1) of_pen.only_pen = pen;
        pass_.draw(runs, frame.stroke_params(pens[pen]), of_pen, density);
    });
}

std::vector<Run> StrokeStage::read_runs(SharedRuns& table) {
    return compute::read_back<Run>(device_, table.runs.compute(), table.totals.points[0]);
}

} // namespace lineatlas
