#pragma once

#include <array>
#include <vector>

#include "compute/stages/carried_coordinates.hpp"
#include "frame.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/shared_table.hpp"
#include "glpasses/stroke_pass.hpp"
#include "run_pens.hpp"
#include "stroke_coverage.hpp"

namespace lineatlas {

/// From the segment atlas to strokes on the picture: makes visible runs, changes them by the style
/// (§4.5), and draws them. Its tables grow when a frame needs more.
class StrokeStage {
  public:
    explicit StrokeStage(const interop::Connection& connection);

    /// Whether runs of hidden samples are drawn.
    static bool draws_hidden(const Frame& frame) {
        return frame.options.draw && frame.options.style.hidden;
    }

    /// Call when the scene has other lines.
    void forget_lines() { pens_.forget(); }
    /// Call before the first make_runs() of a frame.
    void begin_frame(Frame& frame);
    /// Whether the drawing depends on where along its path a run lies, or on which lines are
    /// hidden. Call after begin_frame().
    bool measures_lines(const Frame& frame) const;
    /// Whether any pen that draws has a texture along its strokes: dashes, grain, dry ends.
    bool has_textures(const Frame& frame) const;
    /// Sets the coordinates that silhouettes get in the current frame; null: those along their
    /// paths.
    void carry(compute::CarriedCoordinates* carried) { carried_ = carried; }
    /// Whether make_runs() needs to know outlines.
    static bool wants_outlines(const Frame& frame) {
        return frame.options.draw && tells_outlines(frame.options.style);
    }
    /// Whether kernels draw the frame's strokes, however many there are. Call after begin_frame().
    bool draws_any_by_kernels() const { return coverage_.draws_any(); }
    /// Lets make_runs() return without its totals, for a frame of which draws_any_by_kernels().
    void begin_late() { late_ = true; }
    /// Makes the runs, and waits for their totals unless begin_late() was called. May change the
    /// visibility of samples (`filter`). `spans`: visible spans in place of samples; then the atlas
    /// has no samples. `outline`: needed if wants_outlines(), else null.
    void make_runs(Frame& frame, const compute::SegmentAtlas& input,
                   const compute::SpanTable* spans, const compute::OutlineTable* outline);
    /// Whether make_runs() changed the visibility of samples.
    bool changes_samples() const { return filters_; }
    /// Enlarges the tables that the totals exceed; true if the runs must be made again.
    bool grow();
    /// Keeps the runs of the current chunk, and the first `alpha_bytes` of its samples, on the host
    /// until they are drawn. Call if segments come in chunks.
    void keep(const Frame& frame, interop::SharedTable& alpha, std::size_t alpha_bytes);
    /// Draws the runs, or those of all chunks that were kept.
    void draw(Frame& frame, interop::SharedTable& alpha);
    /// After begin_late(): draws the runs as coverage, for show(), and waits for that and for the
    /// totals.
    void draw_late(Frame& frame, interop::SharedTable& alpha);
    /// Shows what draw_late() has drawn. GL gets no command before.
    void show(Frame& frame) { coverage_.show(frame); }

    /// The samples of the last make_runs().
    std::uint32_t sample_total() const { return visible_.totals.sample_total; }
    std::uint32_t samples_of_frame() const { return kept_samples_ + unkept(sample_total()); }
    std::uint32_t runs_of_frame() const { return kept_runs_ + unkept(visible_.totals.run_total); }
    /// The visible runs of the last frame.
    std::vector<Run> read_runs() { return read_runs(visible_); }
    /// The weights that density control gave lines in the last frame; empty without density
    /// control.
    std::vector<float> read_density();

  private:
    /// Runs that GL and compute share, and how many there are.
    struct SharedRuns {
        explicit SharedRuns(interop::Sharing& sharing)
            : runs(sharing, compute::table::runs), record(sharing, compute::table::records) {}

        interop::SharedTable runs, record;
        std::uint32_t capacity = 0;
        FrameRecord totals{};

        compute::RunTable compute() { return {runs.compute(), record.compute(), capacity}; }
    };

    /// The strokes of a chunk of the segments.
    struct Kept {
        std::vector<Run> visible, hidden;
        FrameRecord visible_record, hidden_record;
        std::vector<std::byte> alpha;
    };

    /// The tables of `density`.
    struct Thinning {
        explicit Thinning(interop::Sharing& sharing)
            : weights(sharing, compute::table::density_weights),
              grid(sharing.device(), compute::table::density_grid) {}

        bool on = false;                         ///< in the current frame
        interop::SharedTable weights;            ///< share of lines that is drawn, 0 to 1, per bin
                                                 ///< and cell
        compute::Table grid;                     ///< drawn length per bin and cell
        std::vector<std::uint32_t> drawn_before; ///< `grid` of the chunks that are kept
    };
    Thinning& thinning(bool hidden) { return thinning_[hidden ? 1 : 0]; }
    /// Values in each table of `density`.
    std::size_t density_values() const {
        return std::size_t{LA_DENSITY_BINS} * static_cast<std::size_t>(cells_.x * cells_.y);
    }

    std::uint32_t unkept(std::uint32_t total) const { return chunks_kept_ ? 0 : total; }
    void draw(Frame& frame, interop::SharedTable& alpha, bool hidden, std::uint32_t pen);
    /// The compute form of draw().
    void draw_by_kernels(Frame& frame, interop::SharedTable& alpha);
    /// Draws everything as coverage, and passes it to GL.
    void draw_coverage(Frame& frame, interop::SharedTable& alpha);
    /// Finds where the runs lie in the picture, for draw_by_kernels().
    void list(Frame& frame, bool hidden);
    /// The number of runs of all pens, hidden lines included, once they are made.
    std::uint64_t runs_to_draw();
    /// Puts runs and samples back where they were.
    void put_back(const Kept& kept, bool hidden, interop::SharedTable& alpha);
    void prepare(const Frame& frame);
    /// Reads how many runs of the table mean something. Waits for the device unless `late_`.
    void read_totals(SharedRuns& table);
    /// After table.totals have come.
    static void use_totals(SharedRuns& table);
    void use_all_totals();
    void make_table(SharedRuns& table);
    std::vector<Run> read_runs(SharedRuns& table);
    std::uint32_t grown_capacity(std::uint32_t needed) const;
    bool grow(SharedRuns& table);
    void compact(Frame& frame, const compute::SegmentAtlas& input, const compute::SpanTable* spans,
                 bool hidden, const compute::RunTable& runs);
    void halo(Frame& frame, const compute::SegmentAtlas& input);
    void filter(Frame& frame, const compute::SegmentAtlas& input);
    void make_room(Thinning& thinning);
    void density(Frame& frame, const compute::SegmentAtlas& input, bool hidden);
    void carry(Frame& frame, SharedRuns& table);
    void tell_pens(Frame& frame, bool hidden, const compute::OutlineTable* outline);
    /// The runs of visible or hidden lines.
    SharedRuns& made(bool hidden) { return hidden ? hidden_ : visible_; }
    /// The runs divided by pens, if there are several pens.
    SharedRuns& penned(bool hidden) { return hidden ? penned_hidden_ : penned_; }
    /// The runs that are drawn.
    SharedRuns& drawn(bool hidden) { return pens_.several(hidden) ? penned(hidden) : made(hidden); }
    /// Whether runs are divided by pens.
    bool tells_pens(bool hidden) const { return pens_.several(hidden) && (!hidden || has_hidden_); }
    /// Whether runs end exactly where visibility does. Some such runs have no samples.
    bool has_exact_ends(bool hidden) const { return by_spans_ || (filters_ && !hidden); }
    gl::StrokeStyle stroke_style(Frame& frame, const Pen& pen, bool hidden) const;

    compute::Stages& stages_;
    compute::Device& device_; ///< of stages_
    interop::Sharing& sharing_;
    SharedRuns visible_, hidden_;
    SharedRuns penned_, penned_hidden_;
    RunPens pens_;
    compute::CarriedCoordinates* carried_ = nullptr;
    // Of the current frame.
    bool has_hidden_ = false, filters_ = false, by_spans_ = false;
    bool late_ = false; ///< totals come when the strokes are drawn
    compute::RunTable raw() const { return {*raw_runs_, *raw_record_, raw_capacity_}; }
    // The input of `filter`, on the device alone.
    compute::Table raw_runs_{device_, compute::table::raw_runs},
        raw_record_{device_, compute::table::records}, cuts_{device_, compute::table::halo_cuts};
    std::uint32_t raw_capacity_ = 0;
    bool is_first_ = true;             ///< no frame has had a line yet
    std::array<Thinning, 2> thinning_; ///< of visible lines and of hidden ones
    glm::ivec2 cells_{0, 0};
    std::vector<Kept> kept_; ///< of the frame's chunks, if it is drawn
    bool chunks_kept_ = false;
    std::uint32_t kept_samples_ = 0, kept_runs_ = 0;
    StrokeCoverage coverage_; ///< the compute form
    gl::StrokePass pass_;
};

} // namespace lineatlas
