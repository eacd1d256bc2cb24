#pragma once

#include <cstddef>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "core/tiles.hpp"
#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// Strokes that kernels have drawn, on the GL side: a layer for each pen.
struct CoverageLayers {
    GLuint coverage;   ///< a byte per pixel of `part` in each layer, row by row
    GLuint shown;      ///< a uint32 per tile in each layer, 1 if the tile has strokes
    std::size_t pitch; ///< bytes from layer to layer
    PictureTile part;  ///< of the picture
    glm::ivec2 first_tile, tile_count;
};

/// `strokes`, the compute form: lays the colours of pens over the pixels that kernels found
/// covered.
class CoveragePass {
  public:
    CoveragePass();

    static constexpr std::size_t most_layers = 8;

    /// Lays all layers over the bound framebuffer, the last on top, premultiplied. `colors`: one
    /// per layer. `origin`: where in the framebuffer the part begins.
    void draw(const CoverageLayers& layers, std::span<const glm::vec4> colors, glm::ivec2 origin);

  private:
    Program program_;
    VertexArray vertex_array_;       ///< without attributes
    TextureBuffer coverage_, shown_; ///< views of the buffers of a draw
};

} // namespace lineatlas::gl
