#pragma once

#include <optional>

#include "core/tiles.hpp"
#include "depth_stage.hpp"
#include "frame.hpp"
#include "glpasses/interop/connect.hpp"
#include "glpasses/interop/shared_table.hpp"
#include "glpasses/layer_pass.hpp"

namespace lineatlas {

/// The compute form of `fill`, used if kernels draw the frame's depth: kernels colour pixels by the
/// triangles that `depth` found in them, and GL lays the pixels over the picture.
/// Backdrop::draw_fill() is the raster form.
class FillStage {
  public:
    explicit FillStage(const interop::Connection& connection);

    /// For another line set.
    void set_scene() { shaded_.release(); }
    /// Draws the fill of a whole picture that `depth` was drawn for, in either form.
    void draw(Frame& frame, DepthStage& depth);
    /// Draws the fill of the frame's tile, in either form. In the compute form it draws the tile's
    /// depth for that: depth that was drawn before is gone.
    void draw_tile(Frame& frame, DepthStage& depth);

  private:
    /// Colours the pixels of a tile by what `depth` has drawn; `low`: the first texel of its
    /// buffer in the whole picture.
    void color(Frame& frame, DepthStage& depth, const PictureTile& tile, glm::ivec2 low);
    /// Lays the coloured pixels over the picture. `at`: where the tile lies in the part of the
    /// picture that goes to the framebuffer.
    void lay(Frame& frame, glm::ivec2 at = {0, 0});
    void prepare(const Frame& frame);

    compute::Stages& stages_;
    compute::Device& device_;                                       ///< of stages_
    compute::Table shaded_{device_, compute::table::shaded_colors}; ///< per triangle
    interop::SharedTable pixels_;                                   ///< of a tile
    glm::ivec2 size_{0, 0};              ///< of the tile that was coloured last
    TexelRectangle part_;                ///< the part of the tile where the model may be
    std::optional<gl::LayerPass> layer_; ///< made when first used
};

} // namespace lineatlas
