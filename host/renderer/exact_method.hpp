#pragma once

#include <vector>

#include "core/tiles.hpp"
#include "fill_stage.hpp"
#include "frame.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/shared_table.hpp"
#include "interval_stage.hpp"
#include "stroke_stage.hpp"
#include "visibility/exact_lines.hpp"

namespace lineatlas {

/// The exact method: lines cut against the faces before them, without a depth buffer and without
/// samples. Later stages are those of the segment atlas.
class ExactMethod {
  public:
    explicit ExactMethod(const interop::Connection& connection);
    ~ExactMethod();
    ExactMethod(const ExactMethod&) = delete;
    ExactMethod& operator=(const ExactMethod&) = delete;

    /// Gives up the tables of a line set: a large one may not fit beside another.
    void release_scene() { lines_.release(); }
    /// Makes tables for another line set.
    void set_scene(const SceneBuffers& scene);
    /// Call when the scene has other lines in the same tables.
    void forget_lines() {
        lines_.forget_lines();
        strokes_.forget_lines();
    }
    FrameStats draw(Frame& frame);
    /// See Renderer::draw_tiles(); only fills and strokes are drawn by tiles.
    FrameStats draw_tiles(Frame& frame, const TileTarget& target);
    std::vector<Interval> read_intervals() { return intervals_.read(lines_.order(), {}); }
    std::vector<OutlinePart> read_outlines() const { return intervals_.read_outlines(); }

  private:
    /// Finds the visible spans and makes intervals and runs of them. `whole`: the picture is not
    /// drawn by tiles. Throws Cancelled.
    void find(Frame& frame, bool whole, const ProgressPart& progress);
    /// Whether the host need not know how many silhouettes and runs a whole picture has before its
    /// strokes are drawn.
    bool may_be_late(const Frame& frame) const;
    bool grow();
    /// An atlas without samples.
    compute::SegmentAtlas no_samples() { return {lines_.clipped(), alpha_.compute(), 0}; }

    compute::Device& device_;
    ExactLines lines_;
    interop::SharedTable alpha_; ///< without samples
    DepthStage depth_;           ///< for fills; lines need no depth
    FillStage fill_;
    StrokeStage strokes_;
    IntervalStage intervals_;
    bool late_ = false; ///< numbers of the current frame come with its strokes
};

} // namespace lineatlas
