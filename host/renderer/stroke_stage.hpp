#pragma once

#include <memory>
#include <vector>

#include "core/atlas_layout.hpp"
#include "frame.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/handover.hpp"
#include "glpasses/stroke_pass.hpp"

namespace lineatlas {

/// From the segment atlas to strokes on the picture: visible runs, what a style changes about them
/// (§4.5), and drawing them. Its tables grow when a frame needs more.
class StrokeStage {
  public:
    explicit StrokeStage(const interop::Connection& connection);

    /// What it reads: the tables of the frame. May change the visibility of samples (`filter`).
    struct Input {
        compute::ClippedTable clipped;
        compute::Buffer& alpha;
        AtlasLayout layout;
        std::uint32_t capacity; ///< samples that `alpha` has room for
    };

    /// Whether the frame's style needs runs of hidden samples.
    static bool draws_hidden(const Frame& frame) { return frame.options.style.hidden; }

    /// Adds its tables, to be passed to compute at the start of a frame.
    void add_unread(std::vector<interop::Passed>& buffers);
    /// Makes the runs, and waits for their totals.
    void make_runs(Frame& frame, const Input& input);
    /// Whether make_runs() changed the visibility of samples.
    bool changes_samples() const { return filters_; }
    /// Enlarges the tables that the totals exceed; true if the runs must be made again.
    bool grow();
    /// Adds what GL needs, to be passed on before draw().
    void add_to_handover(std::vector<interop::Passed>& buffers);
    void draw(Frame& frame, GLuint alpha);

    std::uint32_t sample_total() const { return visible_.totals.sample_total; }
    std::uint32_t run_total() const { return visible_.totals.run_total; }
    std::uint64_t bytes() const;
    /// The visible runs of the last frame.
    std::vector<Run> read_runs();

  private:
    /// Runs on both sides, and how many there are.
    struct RunTable {
        std::unique_ptr<interop::SharedBuffer> runs, record;
        std::uint32_t capacity = 0;
        FrameRecord totals{};
    };

    void prepare(const Frame& frame);
    void make_table(RunTable& table);
    bool grow(RunTable& table);
    void compact(Frame& frame, const Input& input, bool hidden, compute::Buffer& runs,
                 std::uint32_t capacity, compute::Buffer& record);
    void halo(Frame& frame, const Input& input);
    void filter(Frame& frame, const Input& input);
    void density(Frame& frame, const Input& input);
    gl::StrokeStyle stroke_style(Frame& frame, const Pen& pen, bool hidden) const;

    compute::Backend& backend_;
    interop::SharingMode mode_;
    interop::Handover handover_;
    RunTable visible_, hidden_;
    bool has_hidden_ = false, filters_ = false; ///< the current frame's
    // Before `filter`, on the device alone.
    std::unique_ptr<compute::Buffer> raw_runs_, raw_record_, cuts_;
    std::uint32_t raw_capacity_ = 0;
    std::unique_ptr<interop::SharedBuffer> weights_; ///< of `density`
    glm::ivec2 cells_{0, 0};
    gl::StrokePass pass_;
};

} // namespace lineatlas
