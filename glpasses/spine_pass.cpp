#include "spine_pass.hpp"

#include <cstddef>

#include "segment_table.h"
#include "storage.hpp"

namespace lineatlas::gl {
namespace {

/// A vertex array with one segment per vertex.
VertexArray segment_array() {
    VertexArray array = VertexArray::create();
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glEnableVertexArrayAttrib(array.id(), attribute);
        glVertexArrayAttribBinding(array.id(), attribute, 0);
    }
    glVertexArrayAttribIFormat(array.id(), 0, 4, GL_UNSIGNED_INT, offsetof(Segment, p));
    glVertexArrayAttribIFormat(array.id(), 1, 1, GL_UNSIGNED_INT, offsetof(Segment, tag));
    return array;
}

} // namespace

SpinePass::SpinePass()
    : programs_({"spine.vert", "spine.geom", "spine.frag"}), array_(segment_array()),
      vertices_(TextureBuffer::create()), triangles_(TextureBuffer::create()),
      tiles_(TextureBuffer::create()), numbers_(TextureBuffer::create()) {}

void SpinePass::draw(const SegmentBuffers& segments, const SpineParams& spine,
                     const ProbeParams& probes, const StrokeParams& stroke) {
    for (const std::uint64_t texels :
         {std::uint64_t{segments.vertex_count}, std::uint64_t{segments.triangle_count},
          static_cast<std::uint64_t>(spine.tile_count.x) *
              static_cast<std::uint64_t>(spine.tile_count.y)}) {
        check_buffer_texture(texels, purpose::spine);
    }
    glTextureBuffer(vertices_.id(), GL_RGB32F, segments.vertices);
    glTextureBuffer(triangles_.id(), GL_RGB32UI, segments.triangles);
    if (spine.tiles != 0) glTextureBuffer(tiles_.id(), GL_R32F, spine.tiles);
    if (segments.numbers != 0) glTextureBuffer(numbers_.id(), GL_R32UI, segments.numbers);

    const Program& program = programs_.with(stroke.pen.texture != 0 ? "PEN_TEXTURE" : "");
    probes.bind(program, 0);
    stroke.bind(program, 1);
    glBindTextureUnit(2, vertices_.id());
    glBindTextureUnit(3, triangles_.id());
    if (spine.tiles != 0) glBindTextureUnit(4, tiles_.id());
    if (segments.numbers != 0) glBindTextureUnit(5, numbers_.id());
    program.use();
    program.set("face_numbers", 5);
    program.set("tiles", 4);
    program.set("tile_count", glm::vec2{spine.tile_count});
    program.set("use_tiles", spine.tiles != 0);
    program.set("vertices", 2);
    program.set("triangles", 3);
    program.set("clip_from_world", spine.clip_from_world);
    program.set("world_from_clip", spine.world_from_clip);
    program.set("eye", spine.eye);
    program.set("kind_mask", spine.kind_mask);
    program.set("probe_step", spine.step);
    glVertexArrayVertexBuffer(array_.id(), 0, segments.segments, 0, sizeof(Segment));
    glBindVertexArray(array_.id());
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(segments.segment_count));
    glDisablei(GL_BLEND, 0);
}

} // namespace lineatlas::gl
