#include "exact_method.hpp"

#include <glm/gtc/matrix_inverse.hpp>

#include "backdrop.hpp"
#include "depth_stage.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {

ExactMethod::ExactMethod(const interop::Connection& connection)
    : stages_(*connection.stages), device_(stages_.device()), handover_(device_),
      visibility_(stages_),
      alpha_(interop::make_shared_buffer(device_, connection.mode, 16, purpose::exact)),
      strokes_(connection), intervals_(stages_) {}

void ExactMethod::release_scene() {
    visibility_.release();
    front_.reset();
    clipped_.reset();
    arcs_.reset();
    no_offsets_.reset();
}

void ExactMethod::set_scene(const SceneBuffers& scene) {
    release_scene();
    const std::size_t segments = scene.tables().most_segments();
    const std::size_t sums = (segments + 1) * sizeof(la_uint);
    front_ = compute::allocate(device_, scene.triangle_count(), purpose::model);
    clipped_ = compute::allocate(device_, segments * sizeof(ClippedSegment), purpose::segments);
    arcs_ = compute::allocate(device_, sums, purpose::segments);
    no_offsets_ = compute::allocate(device_, sums, purpose::segments);
    device_.clear(*no_offsets_, sums);
}

void ExactMethod::project(Frame& frame) {
    const glm::mat4 clip_from_world = frame.camera.clip_from_world();
    if ((frame.options.lines & mask_of(LineKind::silhouette)) != 0) {
        frame.clock("facing", [&] {
            stages_.facing(
                {.table = frame.scene.table(), .eye = frame.camera.eye(), .front = *front_});
        });
    }
    frame.clock("project_clip", [&] {
        stages_.project_clip(
            {.table = frame.scene.table(),
             .front = *front_,
             .clip_from_world = clip_from_world,
             .world_from_clip = glm::mat4{glm::inverse(glm::dmat4{clip_from_world})},
             .viewport = frame.viewport(),
             .step = frame.options.step,
             .kind_mask = frame.options.lines,
             .occlusion = nullptr,
             .out = clipped_table(visibility_.counts())});
    });
    frame.clock("scan", [&] { stages_.scan(*arcs_, segment_count_, compute::ScanKind::wrap); });
}

void ExactMethod::begin_chunk(Frame& frame, std::size_t chunk) {
    frame.scene.select(chunk);
    const compute::SegmentTable table = frame.scene.table();
    segment_count_ = table.segment_count;
    if (chunk > 0) return visibility_.go_on(table);
    strokes_.begin_frame();
    intervals_.begin_frame();
    visibility_.begin(table, frame.camera, frame.scene.bounds(), frame.scene.diagonal());
}

void ExactMethod::cut(Frame& frame, bool by_lists) {
    const compute::ClippedTable clipped = clipped_table(*no_offsets_);
    for (bool again = true; again; by_lists = false) {
        if (!by_lists) frame.clock("tile_lists", [&] { visibility_.tile_lists(clipped); });
        frame.clock("visible", [&] {
            visibility_.visible(clipped);
            again = visibility_.grow();
        });
    }
}

void ExactMethod::find(Frame& frame) {
    const compute::ClippedTable clipped = clipped_table(*no_offsets_);
    const std::size_t chunks = frame.scene.chunk_count();
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        begin_chunk(frame, chunk);
        project(frame);
        if (chunk == 0) frame.clock("surfaces", [&] { visibility_.surfaces(clipped); });
        cut(frame, chunk > 0);
        const compute::SpanTable spans = visibility_.spans();
        do {
            intervals_.find(frame, clipped, spans);
            strokes_.make_runs(frame, no_samples(), &spans);
        } while (grow());
        if (chunks == 1) return;
        strokes_.keep(frame, alpha_.get(), 0);
        intervals_.keep(frame);
    }
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
            .mesh_bytes = frame.scene.mesh_bytes() + front_->size(),
            .segment_bytes = frame.scene.segment_bytes() + clipped_->size() + arcs_->size() +
                             no_offsets_->size() + visibility_.bytes(),
            .sample_bytes = alpha_->size(),
            .run_bytes = strokes_.bytes(),
            .stages = frame.clock.take()};
}

} // namespace lineatlas
