#include "coverage_pass.hpp"

#include "viewport.hpp"

namespace lineatlas::gl {

CoveragePass::CoveragePass()
    : program_({"coverage.vert", "coverage.frag"}), vertex_array_(VertexArray::create()),
      coverage_(TextureBuffer::create()), shown_(TextureBuffer::create()) {}

void CoveragePass::draw(const CoverageLayers& layers, std::span<const glm::vec4> colors,
                        glm::ivec2 origin) {
    set_viewport(origin, layers.part.size);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnablei(GL_BLEND, 0);
    glBlendEquationi(0, GL_FUNC_ADD);
    glBlendFunci(0, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glTextureBuffer(coverage_.id(), GL_R8, layers.coverage);
    glTextureBuffer(shown_.id(), GL_R32UI, layers.shown);
    glBindTextureUnit(0, coverage_.id());
    glBindTextureUnit(1, shown_.id());
    const int tiles = layers.tile_count.x * layers.tile_count.y;
    program_.use();
    program_.set("coverage", 0);
    program_.set("shown", 1);
    program_.set("layers", static_cast<int>(colors.size()));
    program_.set("pitch", static_cast<int>(layers.pitch));
    program_.set("tiles", glm::ivec4{layers.first_tile, layers.tile_count});
    program_.set("part", glm::ivec4{layers.part.low, layers.part.size});
    program_.set("origin", origin);
    program_.set("row", layers.part.size.x);
    program_.set("colors", colors);
    glBindVertexArray(vertex_array_.id());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, tiles);
    glDisablei(GL_BLEND, 0);
}

} // namespace lineatlas::gl
