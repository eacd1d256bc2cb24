#include "paper_pass.hpp"

#include "storage.hpp"
#include "viewport.hpp"

namespace lineatlas::gl {

PaperPass::PaperPass(const PaperTile& tile)
    : program_({"paper.vert", "paper.frag"}), vertex_array_(VertexArray::create()),
      tile_(Texture2D::create()) {
    allocate(tile_, GL_R8, {PaperTile::size, PaperTile::size}, purpose::paper);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(tile_.id(), 0, 0, 0, PaperTile::size, PaperTile::size, GL_RED,
                        GL_UNSIGNED_BYTE, tile.depth.data());
    glTextureParameteri(tile_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(tile_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void PaperPass::draw(const PictureTile& tile, float grain, GLuint framebuffer, glm::ivec2 origin) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    set_viewport(origin, tile.size);
    glDisable(GL_DEPTH_TEST);
    glEnablei(GL_BLEND, 0);
    glBlendEquationi(0, GL_FUNC_ADD);
    glBlendFuncSeparatei(0, GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    glBindTextureUnit(0, tile_.id());
    program_.use();
    program_.set("depth", 0);
    program_.set("grain", grain);
    program_.set("corner", glm::vec2{tile.low - origin});
    glBindVertexArray(vertex_array_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisablei(GL_BLEND, 0);
}

} // namespace lineatlas::gl
