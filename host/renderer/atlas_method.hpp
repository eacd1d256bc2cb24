#pragma once

#include <optional>

#include "compute/stages/batches.hpp"
#include "compute/stages/carried_coordinates.hpp"
#include "compute/stages/silhouette_chains.hpp"
#include "depth_stage.hpp"
#include "fill_stage.hpp"
#include "frame.hpp"
#include "glpasses/atlas_pass.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/shared_table.hpp"
#include "interval_stage.hpp"
#include "item_buffer_sampler.hpp"
#include "outline_stage.hpp"
#include "stroke_stage.hpp"
#include "temporal_stage.hpp"

namespace lineatlas {

/// The segment atlas (§4): a frame from segments to strokes. Its tables grow when a frame needs
/// more.
class AtlasMethod {
  public:
    explicit AtlasMethod(const interop::Connection& connection);
    ~AtlasMethod();
    AtlasMethod(const AtlasMethod&) = delete;
    AtlasMethod& operator=(const AtlasMethod&) = delete;

    /// Gives up the tables of a line set: a large one may not fit beside another.
    void release_scene();
    /// Makes tables for another line set, and for chunks as large as those of `tables`. Call when
    /// the scene has other lines in the same tables.
    void forget_lines() {
        chains_.forget_lines();
        batches_.forget();
        carried_.forget();
        strokes_.forget_lines();
    }
    void set_scene(const SceneBuffers& scene, const SceneBuffers::Tables& tables);
    FrameStats draw(Frame& frame);
    /// See Renderer::draw_tiles().
    FrameStats draw_tiles(Frame& frame, const TileTarget& target);
    Renderer::Samples read_samples();
    std::vector<Interval> read_intervals() { return intervals_.read(order(), read_offsets()); }
    std::vector<OutlinePart> read_outlines() const { return intervals_.read_outlines(); }

  private:
    void prepare(const Frame& frame);
    /// Room for as many samples as were wanted so far, in rows for the frame's form of `atlas`.
    void make_atlas(const Frame& frame);
    void prepare_tiles(const Frame& frame);
    void make_segment_tables(std::size_t segments);
    /// Makes a chunk of the segments the current one for all stages.
    void begin_chunk(Frame& frame, std::size_t chunk);
    /// Copies the results of a chunk to the host, after all of its stages, if there are several
    /// chunks.
    void keep_chunk(Frame& frame);
    /// Finds the silhouettes of the current chunk and chains them.
    void find_silhouettes(Frame& frame);
    /// The order in which find_silhouettes() has put the chunk's segments. Waits for the device.
    TableOrder order() const { return {chains_.first(), chains_.read_origins()}; }
    /// Where the samples of each segment begin; empty if the segments are in the order of the line
    /// set.
    std::vector<std::uint32_t> read_offsets();
    void project(Frame& frame);
    /// Finds samples, intervals and runs of the current chunk.
    void find(Frame& frame);
    /// As find(), but tables may have been too small: grow() tells.
    void find_once(Frame& frame);
    /// Whether the host need not know any number of the frame before its strokes are drawn.
    bool may_be_late(const Frame& frame) const;
    /// Finds and draws such a frame, after project(). Waits once.
    void draw_late(Frame& frame);
    void sample(Frame& frame);
    void sample_tiles(Frame& frame, const TileTarget& target, const ProgressPart& progress);
    compute::AtlasArgs atlas_args(Frame& frame);
    compute::SegmentAtlas segment_atlas() {
        return {clipped_table(), alpha_.compute(), sample_capacity_};
    }
    void sample_compute(Frame& frame);
    void sample_raster(Frame& frame);
    void sample_item_buffer(Frame& frame);
    /// Carries texture coordinates of silhouettes over, if `carries_`.
    void carry(Frame& frame);
    /// Enlarges the tables that the frame's totals exceed; true if it must be sampled again.
    bool grow();
    bool grow_atlas(std::uint64_t needed);
    FrameStats stats();

    std::uint64_t rows(std::uint32_t samples) const {
        return (std::uint64_t{samples} + row_ - 1) / row_;
    }
    /// Whether the current frame's atlas has more rows than GL can draw, and kernels may compute
    /// it.
    bool leaves_raster(const Frame& frame, std::uint32_t samples) const;
    /// Whether kernels need the current frame's depth.
    bool reads_depth() const {
        return !raster_ || cull_hidden_ || keeps_intervals_ || finds_outlines_;
    }
    compute::ClippedTable clipped_table() {
        return {clipped_.compute(), offsets_.compute(), *arcs_};
    }

    compute::Stages& stages_;
    compute::Device& device_; ///< of stages_
    interop::Sharing& sharing_;
    GLint largest_side_ = 0; ///< of anything that GL draws to
    GLint largest_texture_buffer_ = 0;

    DepthStage depth_;
    FillStage fill_;
    compute::SilhouetteChains chains_; ///< of the current chunk
    compute::CarriedCoordinates carried_;
    bool carries_ = false;     ///< the current frame
    compute::Batches batches_; ///< of the current chunk's segments
    TemporalStage temporal_;
    OutlineStage outlines_;
    std::uint32_t segment_count_ = 0; ///< of the current chunk, as the frame draws it
    std::uint32_t all_segments_ = 0;  ///< of the current chunk, with all candidates
    compute::Table arcs_{device_, compute::table::arcs};
    interop::SharedTable clipped_, offsets_, alpha_;
    std::uint32_t sample_capacity_ = 0;
    std::uint64_t most_samples_ = 0; ///< the most that an atlas can hold
    std::uint32_t row_ = 1;          ///< samples of a row of the raster form
    bool keeps_intervals_ = false;   ///< the current frame
    bool finds_outlines_ = false;    ///< the current frame
    bool silhouettes_grew_ = false;  ///< tables of silhouettes grew since set_scene()
    bool raster_ = false;            ///< the current frame's form of `atlas`
    bool cull_hidden_ = false;       ///< the current frame drops segments that are hidden whole
    bool counts_come_ = false;       ///< numbers of the current frame may still be on their way

    gl::AtlasPass atlas_pass_;
    StrokeStage strokes_;
    IntervalStage intervals_;
    std::optional<ItemBufferSampler> item_buffer_; ///< made when first used
};

} // namespace lineatlas
