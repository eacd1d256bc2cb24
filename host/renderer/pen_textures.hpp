#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "glpasses/objects.hpp"
#include "glpasses/stroke_pass.hpp"
#include "lineatlas/image.hpp"

namespace lineatlas {

/// The textures of the pens in use, made when first asked for.
class PenTextures {
  public:
    /// Throws UsageError for a mark that is an image file and was not set.
    void check(std::string_view name) const;
    /// The texture of a mark. Throws as check() does, and for an image that is too large for the
    /// device.
    gl::PenTexture get(std::string_view name, float width);
    /// See Renderer::set_pen_image().
    void set_image(const std::string& name, Image image);

  private:
    struct Pen {
        gl::Texture2D texture; ///< none for a solid pen
        float repeat_length;
    };
    /// Finds a pen without making a string of its name.
    struct Less {
        using is_transparent = void;
        using Key = std::pair<std::string_view, float>;
        bool operator()(const Key& a, const Key& b) const { return a < b; }
    };
    std::map<std::string, Image, std::less<>> images_;
    std::map<std::pair<std::string, float>, Pen, Less> pens_;
};

} // namespace lineatlas
