#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "frame.hpp"
#include "glpasses/coverage_pass.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/shared_table.hpp"
#include "run_pens.hpp"

namespace lineatlas {

/// `strokes` by kernels: each pen's runs as coverage of the picture's pixels, over which GL then
/// lays the pen's colour. gl::StrokePass draws what kernels can't draw.
class StrokeCoverage {
  public:
    explicit StrokeCoverage(const interop::Connection& connection);

    /// Chooses the frame's form. Call first.
    void begin_frame(Frame& frame, const RunPens& pens);
    /// Whether kernels draw the frame's strokes.
    bool draws() const { return draws_; }
    /// Whether they do so however many runs there are.
    bool draws_any() const { return can_draw_ && fewest_runs_ == 0; }

    /// Leaves few runs to GL, unless kernels were asked for. Call when the number of runs is known,
    /// and again after a table was too small.
    void settle(std::uint64_t runs) { draws_ = can_draw_ && runs >= fewest_runs_; }

    /// Finds where runs lie in the picture. `half_width`: that of their widest pen. Waits for the
    /// device, unless its results are read `late`: they have come when the device is next done.
    void list(const Frame& frame, bool hidden, const compute::RunTable& runs, float half_width,
              bool late);
    /// Enlarges tables that were too small for list(), whose results must have come. Returns true
    /// if the runs must be listed again.
    bool grow();
    /// Call before the strokes of a picture, or of a tile of it.
    void begin_drawing(Frame& frame);
    /// Draws the listed runs of all pens, of hidden lines or of visible ones. `again`: draws over
    /// runs drawn before. `weights`: those of `density`, or null.
    void draw(Frame& frame, bool hidden, const compute::RunTable& runs, compute::Buffer& alpha,
              compute::Buffer* weights, bool exact_ends, bool again);
    /// Passes everything drawn to GL. Waits for the device.
    void pass_to_gl();
    /// Lays everything drawn over the frame's picture.
    void show(Frame& frame);

  private:
    /// Values along a mark that is the same all across. On the device the last value also stands
    /// before the first, and the first behind the last.
    struct Mark {
        compute::Table values;
        std::uint32_t length = 0;
        float repeat_length = 1;
    };
    struct Lists {
        explicit Lists(compute::Device& device)
            : ends(device, compute::table::stroke_ends),
              entries(device, compute::table::stroke_entries),
              total_on_device(device, compute::table::stroke_total) {}

        compute::Table ends, entries, total_on_device;
        std::uint32_t capacity = 0, total = 0;
    };

    bool wants(const Frame& frame) const;
    Lists& lists(bool hidden) { return lists_[hidden ? 1 : 0]; }
    compute::StrokeLists tables(bool hidden) {
        Lists& own = lists(hidden);
        return {*own.ends, *own.entries, *own.total_on_device, own.capacity};
    }
    /// The number of layers of hidden lines, which come before those of visible lines.
    std::uint32_t hidden_layers() const;
    const Mark& mark(const Pen& pen);

    compute::Stages& stages_;
    compute::Device& device_; ///< of stages_
    interop::Sharing& sharing_;
    std::array<Lists, 2> lists_; ///< of visible lines, and of hidden ones
    std::map<std::pair<std::string, float>, Mark, std::less<>> marks_; ///< by name and width
    interop::SharedTable coverage_, shown_;
    gl::CoveragePass pass_;
    // Of the current frame.
    const RunPens* pens_ = nullptr;
    bool can_draw_ = false, draws_ = false, has_hidden_ = false;
    std::uint64_t fewest_runs_ = 0;
    gl::CoverageLayers layers_{};
};

} // namespace lineatlas
