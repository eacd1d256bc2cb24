#pragma once

#include <glm/vec2.hpp>

#include "core/paper.hpp"
#include "objects.hpp"
#include "program.hpp"

namespace lineatlas::gl {

/// `paper`: darkens the picture where the paper's surface lies low.
class PaperPass {
  public:
    explicit PaperPass(const PaperTile& tile);

    /// `grain`: how strongly, 0 to 1. Alpha stays as it is.
    void draw(glm::ivec2 viewport, float grain, GLuint framebuffer);

  private:
    Program program_;
    VertexArray vertex_array_; ///< without attributes
    Texture2D tile_;
};

} // namespace lineatlas::gl
