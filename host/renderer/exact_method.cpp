#include "exact_method.hpp"

#include "backdrop.hpp"
#include "depth_stage.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {

ExactMethod::ExactMethod(const interop::Connection& connection)
    : stages_(*connection.stages), device_(stages_.device()), handover_(device_), lines_(stages_),
      alpha_(interop::make_shared_buffer(device_, connection.mode, 16, purpose::exact)),
      strokes_(connection), intervals_(stages_) {}

void ExactMethod::set_scene(const SceneBuffers& scene) {
    lines_.make_tables(scene.triangle_count(), scene.tables().most_segments());
}

void ExactMethod::find(Frame& frame) {
    strokes_.begin_frame();
    intervals_.begin_frame(frame);
    const LineView view{.camera = frame.camera,
                        .bounds = frame.scene.bounds(),
                        .diagonal = frame.scene.diagonal(),
                        .lines = frame.options.lines,
                        .step = frame.options.step};
    const std::size_t chunks = frame.scene.chunk_count();
    const auto table = [&](std::size_t chunk) {
        frame.scene.select(chunk);
        return frame.scene.table();
    };
    lines_.find(view, chunks, table, frame.clock,
                [&](std::size_t, const compute::SpanTable& spans) {
                    do {
                        intervals_.find(frame, lines_.clipped(), spans);
                        strokes_.make_runs(frame, no_samples(), &spans);
                    } while (grow());
                    if (chunks == 1) return;
                    strokes_.keep(frame, alpha_.get(), 0);
                    intervals_.keep(frame);
                });
}

bool ExactMethod::grow() {
    const bool intervals_grown = intervals_.grow();
    return strokes_.grow() || intervals_grown;
}

void ExactMethod::take_tables() {
    const auto [runs, record, hidden_runs, hidden_record, weights] = strokes_.tables();
    handover_.to_compute({alpha_.get(), runs, record, hidden_runs, hidden_record, weights});
}

void ExactMethod::pass_to_strokes(Frame& frame) {
    frame.clock.handover([&] {
        strokes_.note_written();
        const auto [runs, record, hidden_runs, hidden_record, weights] = strokes_.tables();
        handover_.to_gl({alpha_.get(), runs, record, hidden_runs, hidden_record, weights});
    });
}

FrameStats ExactMethod::draw(Frame& frame) {
    frame.clock.handover([&] { take_tables(); });
    find(frame);
    if (frame.options.draw) frame.backdrop.draw_fill(frame, frame.options.style.fill);
    pass_to_strokes(frame);
    if (frame.options.draw) strokes_.draw(frame, *alpha_);
    return stats(frame);
}

FrameStats ExactMethod::draw_tiles(Frame& frame, const TileTarget& target) {
    if (target.tile_size < 1) throw UsageError("tiles: a tile must have at least one pixel a side");
    frame.clock.handover([&] { take_tables(); });
    find(frame);
    pass_to_strokes(frame);
    for (const PictureTile& tile : make_tiles(frame.camera.size, target.tile_size)) {
        frame.tile = tile;
        target.begin(tile);
        const std::vector<gl::TriangleRange> seen =
            pieces_in_view(frame.scene, frame.clip_of_tile());
        frame.backdrop.draw_fill(frame, frame.options.style.fill, seen);
        strokes_.draw(frame, *alpha_);
        frame.backdrop.draw_paper(frame, frame.options.style.paper);
        frame.clock("output", [&] { target.end(tile); });
    }
    return stats(frame);
}

FrameStats ExactMethod::stats(Frame& frame) {
    return {.triangles = frame.scene.triangle_count(),
            .triangles_drawn = 0,
            .segments = frame.scene.segment_count(),
            .samples = 0,
            .runs = strokes_.runs_of_frame(),
            .mesh_bytes = frame.scene.mesh_bytes() + lines_.mesh_bytes(),
            .segment_bytes = frame.scene.segment_bytes() + lines_.segment_bytes(),
            .sample_bytes = alpha_->size(),
            .run_bytes = strokes_.bytes(),
            .stages = frame.clock.take()};
}

} // namespace lineatlas
