#pragma once

#include <algorithm>
#include <cstdint>

#include "compute/stages/exact_visibility.hpp"
#include "compute/stages/silhouette_chains.hpp"
#include "core/progress.hpp"
#include "core/standard_camera.hpp"
#include "line_tables.hpp"
#include "table_order.hpp"

namespace lineatlas {

/// The view and the options by which the visible parts of a line set are found.
struct LineView {
    const Camera& camera; ///< a standard camera
    const Bounds& bounds; ///< of the model at its current places
    float contact;        ///< contact_of() the model as it was made
    LineKindMask lines;
    float step; ///< FrameOptions::step: a line of one segment that is shorter is left out
    float centre_overhang = 0; ///< Style::centre_overhang, pixels
    /// Whether anybody asks where along its path a visible part lies, or for hidden parts. If not,
    /// segments that are hidden as a whole get no length.
    bool measured = true;
    /// Finds silhouettes on known surfaces; null: all are found by normals of corners.
    const ContourTracer* tracer = nullptr;

    glm::vec2 viewport() const { return glm::vec2{camera.size}; }
};

/// The exact method, from a line set and a camera to the visible parts of each segment: cuts lines
/// against the faces before them, with neither a depth buffer nor samples. Other classes make
/// strokes or intervals of the parts.
class ExactLines {
  public:
    explicit ExactLines(compute::Stages& stages)
        : stages_(stages), device_(stages.device()),
          chains_(stages, compute::SilhouetteChains::Contours::on_surface), batches_(stages),
          visibility_(stages) {}

    /// Gives up the tables of a line set: a large one may not fit beside another.
    void release();
    /// Call when the tables hold other lines.
    void forget_lines() {
        chains_.forget_lines();
        batches_.forget();
        visibility_.forget_lines();
    }
    /// Makes tables for another line set.
    void make_tables(std::uint32_t fixed_segments);
    /// Whether the host guesses how many silhouettes the next frames have, in place of a wait. Then
    /// the last segments of use() may be none that any frame draws.
    void guess(bool on) { chains_.guess(on); }

    /// Finds the visible parts, chunk by chunk. `table(chunk)` returns the tables that kernels
    /// read. `run(name, action)` runs a stage. `use(chunk, segments, spans)` takes the visible
    /// spans of the chunk's clipped() segments, in this frame's order(). Throws Cancelled.
    template <class Table, class Run, class Use>
    void find(const LineView& view, std::size_t chunk_count, const ProgressPart& progress,
              const Table& table, Run&& run, Use&& use) {
        // The usual number of stages of a chunk. Some stages run again if a table was too small.
        constexpr float usual_stages = 12;
        float done = 0;
        const auto clock = [&](const char* name, const auto& action) {
            if (progress) {
                device_.finish(); // else progress would tell only what was submitted
                progress(done);
                const auto chunks = static_cast<float>(chunk_count);
                done += std::min((1 - done) / 2, 1 / (usual_stages * chunks));
            }
            run(name, action);
        };
        for (std::size_t chunk = 0; chunk < chunk_count; ++chunk) {
            const compute::SegmentTable candidates = table(chunk);
            const bool wanted = (view.lines & mask_of(LineKind::silhouette)) != 0;
            const bool traced =
                wanted && view.tracer != nullptr && candidates.candidates.contours.has_value();
            chains_.take({});
            const compute::SilhouetteView seen = compute::silhouette_view(view.camera, view.bounds);
            if (traced) {
                clock("contour",
                      [&] { chains_.take(view.tracer->trace(view.camera, seen.from_outside)); });
            }
            bool has_all = false;
            while (!has_all) {
                const compute::SegmentTable segments =
                    chains_.table_of(candidates, wanted, seen, clock);
                has_all = find(view, chunk, candidates, segments, clock);
                if (has_all) use(chunk, segments, visibility_.spans());
            }
        }
    }

    /// The order of the current chunk's segments. Waits for the device.
    TableOrder order() const { return {chains_.first(), chains_.read_origins()}; }
    /// The parts of the current chunk that are outline of a body at least `depth` pixels deep. Call
    /// while use() runs.
    compute::OutlineTable outline(float depth) { return visibility_.outline(clipped(), depth); }
    /// The clipped segments of the current chunk; they have no samples.
    compute::ClippedTable clipped() const { return {*clipped_, *no_offsets_, *arcs_}; }

  private:
    /// Finds the visible parts of the segments of a chunk. Waits for the device. Returns false if
    /// there was too little room for silhouettes.
    template <class Clock>
    bool find(const LineView& view, std::size_t chunk, const compute::SegmentTable& candidates,
              const compute::SegmentTable& segments, const Clock& clock) {
        make_room(segments.segment_count);
        if (chunk == 0) {
            visibility_.begin(segments, view.camera, view.bounds, view.contact);
            clock("surfaces", [&] { visibility_.surfaces(); });
        } else {
            visibility_.go_on(segments);
        }
        clock("project_clip", [&] { project_clip(view, candidates, segments); });
        clock("scan",
              [&] { stages_.scan(*arcs_, segments.segment_count, compute::ScanKind::wrap); });
        // Later chunks use the lists of tiles of the first one.
        bool by_lists = chunk > 0, has_all = true, again = true;
        while (again) {
            if (!by_lists) clock("tile_lists", [&] { visibility_.tile_lists(); });
            clock("visible", [&] {
                visibility_.visible(clipped());
                visibility_.read_sizes();
                has_all = chains_.settle();
                again = has_all && visibility_.grow(clipped());
            });
            by_lists = false;
        }
        return has_all;
    }
    void make_room(std::uint32_t segments);
    void project_clip(const LineView& view, const compute::SegmentTable& candidates,
                      const compute::SegmentTable& table);

    compute::Stages& stages_;
    compute::Device& device_; ///< of stages_
    compute::SilhouetteChains chains_;
    compute::Batches batches_; ///< of segments
    compute::ExactVisibility visibility_;
    compute::Table clipped_{device_, compute::table::clipped}, arcs_{device_, compute::table::arcs};
    compute::Table no_offsets_{device_, compute::table::no_offsets}; ///< all 0, because no segment
                                                                     ///< has samples
    bool silhouettes_grew_ = false;                                  ///< since make_tables()
};

} // namespace lineatlas
