#pragma once

#include <map>
#include <string>
#include <utility>

#include "glpasses/objects.hpp"
#include "glpasses/stroke_pass.hpp"
#include "lineatlas/io.hpp"

namespace lineatlas {

/// The textures of the pens in use, made when first asked for.
class PenTextures {
  public:
    /// Throws UsageError for an unknown pen.
    gl::PenTexture get(const std::string& name, float width);
    /// See Renderer::set_pen_image().
    void set_image(const std::string& name, Image image);

  private:
    struct Pen {
        gl::Texture2D texture; ///< none for a solid pen
        float repeat_length;
    };
    std::map<std::string, Image> images_;
    std::map<std::pair<std::string, float>, Pen> pens_;
};

} // namespace lineatlas
