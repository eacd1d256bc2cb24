#include "exact_method.hpp"

#include "compute/transfer.hpp"
#include "core/progress.hpp"
#include "depth_stage.hpp"
#include "tile_loop.hpp"

namespace lineatlas {

ExactMethod::ExactMethod(const interop::Connection& connection)
    : device_(connection.stages->device()), lines_(*connection.stages),
      alpha_(*connection.sharing, compute::table::no_alpha), depth_(connection), fill_(connection),
      strokes_(connection), intervals_(*connection.stages) {
    alpha_.fit(16);
}

void ExactMethod::set_scene(const SceneBuffers& scene) {
    strokes_.forget_lines();
    depth_.set_scene(scene);
    fill_.set_scene();
    lines_.make_tables(scene.tables().most_fixed_segments());
}

ExactMethod::~ExactMethod() {
    if (late_) compute::end_transfers(device_);
}

bool ExactMethod::may_be_late(const Frame& frame) const {
    return frame.options.draw && !frame.automatic.waits_freely && !IntervalStage::wanted(frame) &&
           frame.scene.chunk_count() == 1 && strokes_.draws_any_by_kernels();
}

void ExactMethod::find(Frame& frame, bool whole, const ProgressPart& progress) {
    strokes_.begin_frame(frame);
    intervals_.begin_frame(frame);
    late_ = whole && may_be_late(frame);
    if (late_) strokes_.begin_late();
    lines_.guess(late_);
    const LineView view{.camera = frame.camera,
                        .bounds = frame.scene.bounds(),
                        .contact = frame.scene.contact(),
                        .lines = frame.kinds(),
                        .step = frame.options.step,
                        .centre_overhang = frame.options.style.centre_overhang,
                        .measured = IntervalStage::wanted(frame) || strokes_.measures_lines(frame),
                        .tracer = frame.scene.tables().moving ? nullptr
                                                              : frame.scene.tables().tracer.get()};
    const std::size_t chunks = frame.scene.chunk_count();
    const auto table = [&](std::size_t chunk) {
        frame.scene.select(chunk);
        return frame.scene.candidate_table();
    };
    const bool of_intervals = IntervalStage::wants_outlines(frame);
    const bool of_strokes = StrokeStage::wants_outlines(frame);
    const float depth = outline_depth(frame.options.style, frame.camera.size);
    lines_.find(
        view, chunks, progress, table, frame.clock,
        [&](std::size_t, const compute::SegmentTable& segments, const compute::SpanTable& spans) {
            frame.scene.set_order(segments);
            std::optional<compute::OutlineTable> outline;
            if (of_intervals || of_strokes)
                frame.clock("outline", [&] { outline.emplace(lines_.outline(depth)); });
            do {
                intervals_.find(frame, lines_.clipped(), spans);
                strokes_.make_runs(frame, no_samples(), &spans, outline ? &*outline : nullptr);
                if (late_) strokes_.draw_late(frame, alpha_);
            } while (grow());
            if (of_intervals) intervals_.add_outlines(frame, *outline, lines_.order());
            if (chunks == 1) return;
            strokes_.keep(frame, alpha_, 0);
            intervals_.keep(frame, lines_.order(), {});
        });
}

bool ExactMethod::grow() {
    const bool intervals_grown = intervals_.grow();
    return strokes_.grow() || intervals_grown;
}

FrameStats ExactMethod::draw(Frame& frame) {
    find(frame, true, ProgressPart::none());
    if (frame.options.draw) {
        fill_.draw_tile(frame, depth_);
        if (late_)
            strokes_.show(frame);
        else
            strokes_.draw(frame, alpha_);
    }
    return {.runs = strokes_.runs_of_frame(), .stages = {}};
}

FrameStats ExactMethod::draw_tiles(Frame& frame, const TileTarget& target) {
    const ProgressPart progress{target.progress, "drawing tiles"};
    const ProgressPart drawing = progress.part(0.5F, 1);
    progress(0);
    find(frame, false, progress.part(0, 0.5F));
    draw_by_tiles(frame, target, drawing, [&] {
        fill_.draw_tile(frame, depth_);
        strokes_.draw(frame, alpha_);
    });
    return {.runs = strokes_.runs_of_frame(), .stages = {}};
}

} // namespace lineatlas
