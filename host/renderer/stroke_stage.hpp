#pragma once

#include <memory>
#include <vector>

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

    /// Whether runs of hidden samples are drawn.
    static bool draws_hidden(const Frame& frame) {
        return frame.options.draw && frame.options.style.hidden;
    }

    /// Adds its tables, to be passed to compute at the start of a frame.
    void add_unread(std::vector<interop::Passed>& buffers);
    /// Makes the runs, and waits for their totals. May change the visibility of samples (`filter`).
    void make_runs(Frame& frame, const SegmentAtlas& input);
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
    /// What density control left of lines in the last frame; empty without it.
    std::vector<float> read_density();

  private:
    /// Runs on both sides, and how many there are.
    struct RunTable {
        std::unique_ptr<interop::SharedBuffer> runs, record;
        std::uint32_t capacity = 0;
        FrameRecord totals{};
    };

    void prepare(const Frame& frame);
    void make_table(RunTable& table);
    void make_room(std::unique_ptr<compute::Buffer>& buffer, std::size_t bytes,
                   const Purpose& purpose);
    bool grow(RunTable& table);
    void compact(Frame& frame, const SegmentAtlas& input, bool hidden, compute::Buffer& runs,
                 std::uint32_t capacity, compute::Buffer& record);
    void halo(Frame& frame, const SegmentAtlas& input);
    void filter(Frame& frame, const SegmentAtlas& input);
    void density(Frame& frame, const SegmentAtlas& input);
    gl::StrokeStyle stroke_style(Frame& frame, const Pen& pen, bool hidden) const;

    compute::Backend& backend_;
    interop::SharingMode mode_;
    interop::Handover handover_;
    RunTable visible_, hidden_;
    bool has_hidden_ = false, filters_ = false, limits_density_ = false; ///< the current frame's
    // Before `filter`, on the device alone.
    std::unique_ptr<compute::Buffer> raw_runs_, raw_record_, cuts_;
    std::uint32_t raw_capacity_ = 0;
    std::unique_ptr<interop::SharedBuffer> weights_; ///< of `density`
    glm::ivec2 cells_{0, 0};
    gl::StrokePass pass_;
};

} // namespace lineatlas
