#include "pen_textures.hpp"

#include "core/pens.hpp"
#include "glpasses/storage.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

gl::Texture2D upload(const PenMark& mark) {
    if (mark.size.x == 0) return {};
    gl::Texture2D texture = gl::Texture2D::create();
    gl::allocate(texture, GL_R8, mark.size, purpose::pen);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture.id(), 0, 0, 0, mark.size.x, mark.size.y, GL_RED, GL_UNSIGNED_BYTE,
                        mark.coverage.data());
    glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(texture.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

} // namespace

void PenTextures::set_image(const std::string& name, Image image) {
    if (!is_pen_file(name)) {
        throw UsageError("a pen from an image needs a file's name, with a / or a dot, not \"" +
                         name + "\"");
    }
    if (image.size.x < 1 || image.size.y < 1) {
        throw UsageError("the picture of the pen \"" + name + "\" is empty");
    }
    std::erase_if(pens_, [&](const auto& pen) { return pen.first.first == name; });
    images_[name] = std::move(image);
}

void PenTextures::check(std::string_view name) const {
    if (is_pen_file(name) && !images_.contains(name)) {
        throw UsageError("pen: there is no picture for the mark \"" + std::string{name} +
                         "\"; give it to Renderer::set_pen_image() first");
    }
}

gl::PenTexture PenTextures::get(std::string_view name, float width) {
    auto found = pens_.find(Less::Key{name, width});
    if (found == pens_.end()) {
        check(name);
        const auto image = images_.find(name);
        const PenMark mark = image != images_.end() ? pen_from_image(image->second, width)
                                                    : make_pen(std::string{name}, width);
        found =
            pens_
                .emplace(std::pair{std::string{name}, width}, Pen{upload(mark), mark.repeat_length})
                .first;
    }
    return {.texture = found->second.texture.id(), .repeat_length = found->second.repeat_length};
}

} // namespace lineatlas
