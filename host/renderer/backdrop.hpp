#pragma once

#include <optional>
#include <span>

#include "frame.hpp"
#include "glpasses/fill_pass.hpp"
#include "glpasses/paper_pass.hpp"
#include "lineatlas/style.hpp"

namespace lineatlas {

/// The parts of a drawing besides its lines: colours under the lines, and the paper's grain over
/// everything.
class Backdrop {
  public:
    /// Throws UsageError if the framebuffer has no depth.
    static void check_fill(GLuint framebuffer);
    /// The raster form of `fill`, before the strokes. `seen`: the pieces of the model that may be
    /// seen (DepthStage::drawn()). Changes the framebuffer's depth. Throws as check_fill() does.
    void draw_fill(Frame& frame, const Fill& fill, std::span<const gl::TriangleRange> seen);
    /// As above, with the whole model.
    void draw_fill(Frame& frame, const Fill& fill);
    /// Draws the paper's grain, after the strokes. The framebuffer was cleared to the paper's
    /// colour.
    void draw_paper(Frame& frame, const Paper& paper);

  private:
    // Made when first used.
    std::optional<gl::FillPass> fill_pass_;
    std::optional<gl::PaperPass> paper_pass_;
};

} // namespace lineatlas
