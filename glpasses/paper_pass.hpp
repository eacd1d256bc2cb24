#pragma once

#include "core/paper.hpp"
#include "core/tiles.hpp"
#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// `paper`: darkens the picture where the paper's surface lies low.
class PaperPass {
  public:
    explicit PaperPass(const PaperTile& tile);

    /// Draws the grain over `tile` of the picture. `grain`: its strength, 0 to 1. Alpha stays as it
    /// is. `origin`: where the viewport begins in the framebuffer.
    void draw(const PictureTile& tile, float grain, GLuint framebuffer, glm::ivec2 origin);

  private:
    Program program_;
    VertexArray vertex_array_; ///< without attributes
    Texture2D tile_;
};

} // namespace lineatlas::gl
