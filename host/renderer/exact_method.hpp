#pragma once

#include <memory>
#include <vector>

#include "compute/stages/exact_visibility.hpp"
#include "core/tiles.hpp"
#include "frame.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/handover.hpp"
#include "interval_stage.hpp"
#include "stroke_stage.hpp"

namespace lineatlas {

/// The exact method: lines cut against the faces before them, with neither a depth buffer nor
/// samples. From there on strokes are those of the segment atlas.
class ExactMethod {
  public:
    explicit ExactMethod(const interop::Connection& connection);

    /// Gives up the tables of a line set: a large one may not fit beside another.
    void release_scene();
    /// Makes tables for another line set.
    void set_scene(const SceneBuffers& scene);
    FrameStats draw(Frame& frame);
    /// See Renderer::draw_tiles(); only strokes are drawn by tiles.
    FrameStats draw_tiles(Frame& frame, const TileTarget& target);
    std::vector<Interval> read_intervals() { return intervals_.read(); }

  private:
    /// From here on stages are those of this chunk of the segments.
    void begin_chunk(Frame& frame, std::size_t chunk);
    void project(Frame& frame);
    /// What is visible of the current chunk. `by_lists`: tiles have their lists of faces already.
    void cut(Frame& frame, bool by_lists);
    /// Finds what is visible, and makes intervals and runs of it.
    void find(Frame& frame);
    bool grow();
    /// Takes its tables from GL.
    void take_tables();
    /// Hands what strokes are drawn from to GL.
    void pass_to_strokes(Frame& frame);
    /// `offsets`: what project_clip counts, or what later stages read.
    compute::ClippedTable clipped_table(compute::Buffer& offsets) {
        return {*clipped_, offsets, *arcs_};
    }
    /// An atlas without samples.
    compute::SegmentAtlas no_samples() {
        return {clipped_table(*no_offsets_), alpha_->compute(), {1, 1}, 0};
    }
    FrameStats stats(Frame& frame);

    compute::Stages& stages_;
    compute::Device& device_; ///< of stages_
    interop::Handover handover_;
    compute::ExactVisibility visibility_;
    std::uint32_t segment_count_ = 0; ///< of the current chunk
    std::unique_ptr<compute::Buffer> front_, clipped_, arcs_;
    std::unique_ptr<compute::Buffer> no_offsets_;  ///< all 0: no segment has samples
    std::unique_ptr<interop::SharedBuffer> alpha_; ///< of no samples
    StrokeStage strokes_;
    IntervalStage intervals_;
};

} // namespace lineatlas
