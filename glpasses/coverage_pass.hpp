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
    GLuint coverage;   ///< bytes: per layer one for every pixel of `part`, row by row
    GLuint shown;      ///< uint32: per layer one for every tile, 1 if it has strokes
    std::size_t pitch; ///< bytes from layer to layer
    PictureTile part;  ///< of the picture
    glm::ivec2 first_tile, tile_count;
};

/// `strokes`, the compute form: puts the colours of pens where kernels have found their strokes.
class CoveragePass {
  public:
    CoveragePass();

    static constexpr std::size_t most_layers = 8;

    /// All layers over the bound framebuffer, the last on top, premultiplied. `colors`: theirs.
    /// `origin`: where in it the part begins.
    void draw(const CoverageLayers& layers, std::span<const glm::vec4> colors, glm::ivec2 origin);

  private:
    Program program_;
    VertexArray vertex_array_;       ///< without attributes
    TextureBuffer coverage_, shown_; ///< views of the buffers of a draw
};

} // namespace lineatlas::gl
