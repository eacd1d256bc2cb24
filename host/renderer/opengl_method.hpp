#pragma once

#include "frame.hpp"
#include "glpasses/line_pass.hpp"

namespace lineatlas {

/// Plain OpenGL lines (§5 OGL), the yardstick. The target framebuffer needs a depth attachment.
class OpenGlMethod {
  public:
    FrameStats draw(Frame& frame);

  private:
    gl::LinePass line_pass_;
};

} // namespace lineatlas
