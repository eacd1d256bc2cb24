#pragma once

#include <optional>
#include <span>

#include "frame.hpp"
#include "glpasses/canvas.hpp"
#include "glpasses/fill_pass.hpp"
#include "glpasses/layer_pass.hpp"
#include "glpasses/paper_pass.hpp"
#include "lineatlas/style.hpp"

namespace lineatlas {

/// Texels per side that a fill draws at once, however large the picture is.
inline constexpr int most_fill_texels = 4096;

/// The parts of a drawing besides its lines: colours under the lines, and the paper's grain over
/// everything.
class Backdrop {
  public:
    /// The raster form of `fill`, before the strokes: `depth_scale` by `depth_scale` texels make a
    /// pixel, as in the compute form. `seen`: the pieces of the model that may be seen
    /// (DepthStage::drawn()); a part of the picture draws those in its view.
    void draw_fill(Frame& frame, const Fill& fill, std::span<const gl::TriangleRange> seen);
    /// As above, with the whole model.
    void draw_fill(Frame& frame, const Fill& fill);
    /// Gives up the memory of fills: the frame has none.
    void forget_fill() { texels_.reset(); }
    /// Draws the paper's grain, after the strokes. The framebuffer was cleared to the paper's
    /// colour.
    void draw_paper(Frame& frame, const Paper& paper);

  private:
    /// `part`: of the frame's tile.
    void draw_part(Frame& frame, const Fill& fill, const PictureTile& part,
                   std::span<const gl::TriangleRange> seen);
    /// Where `size` texels are drawn for the framebuffer: nothing yet.
    gl::Canvas& texels(glm::ivec2 size, GLuint framebuffer);

    // Made when first used.
    std::optional<gl::FillPass> fill_pass_;
    std::optional<gl::Canvas> texels_;
    std::optional<gl::LayerPass> layer_;
    std::optional<gl::PaperPass> paper_pass_;
};

} // namespace lineatlas
