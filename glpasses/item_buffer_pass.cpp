#include "item_buffer_pass.hpp"

#include <algorithm>

#include "storage.hpp"
#include "viewport.hpp"

namespace lineatlas::gl {
namespace {

// Offset beyond half the width of a line, for rounding of depths and of places on the raster.
constexpr float offset_units = 4;

std::size_t bytes_of(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
           sizeof(std::uint32_t);
}

Texture2D make_texture(GLenum format, glm::ivec2 size) {
    Texture2D texture = Texture2D::create();
    allocate(texture, format, size, purpose::item_buffer);
    glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

/// The width of the widest lines. A forward compatible context draws only the thinnest.
int widest_line() {
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    if ((flags & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) != 0) return 1;
    std::array<GLfloat, 2> range{1, 1};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range.data());
    return std::max(1, static_cast<int>(range[1]));
}

void draw_depth_alone(GLuint framebuffer) {
    glNamedFramebufferDrawBuffer(framebuffer, GL_NONE);
    glNamedFramebufferReadBuffer(framebuffer, GL_NONE);
}

} // namespace

ItemBufferPass::ItemBufferPass()
    : polygon_program_({"depth.vert", "depth.frag"}),
      line_program_({"item_buffer.vert", "item_buffer.frag"}),
      polygon_array_(VertexArray::create()), line_array_(VertexArray::create()),
      polygon_framebuffer_(Framebuffer::create()), widest_line_(widest_line()) {
    glEnableVertexArrayAttrib(polygon_array_.id(), 0);
    glVertexArrayAttribFormat(polygon_array_.id(), 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(polygon_array_.id(), 0, 0);
    glEnableVertexArrayAttrib(line_array_.id(), 0);
    glVertexArrayAttribFormat(line_array_.id(), 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(line_array_.id(), 0, 0);
    draw_depth_alone(polygon_framebuffer_.id());
    line_program_.set("first_layer", 0);
    line_program_.set("second_layer", 1);
    for (Layer& layer : layers_) layer.framebuffer = Framebuffer::create();
}

std::span<ItemLine> ItemBufferPass::map_lines(std::uint32_t count) {
    line_count_ = count;
    if (count == 0) return {};
    if (count > line_capacity_) {
        constexpr std::uint32_t most = (1U << 31U) / 2 - 1; // glDrawArrays counts ends of lines
        const auto capacity = static_cast<std::uint32_t>(with_room_to_grow(count, most));
        line_capacity_ = 0; // until the buffer is made
        lines_ = Buffer::create();
        allocate(lines_, std::size_t{capacity} * sizeof(ItemLine), nullptr, GL_MAP_WRITE_BIT,
                 purpose::item_buffer);
        line_capacity_ = capacity;
        glVertexArrayVertexBuffer(line_array_.id(), 0, lines_.id(), 0, sizeof(glm::vec3));
    }
    void* memory = map(lines_, std::size_t{count} * sizeof(ItemLine),
                       GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT, purpose::item_buffer);
    return {static_cast<ItemLine*>(memory), count};
}

void ItemBufferPass::resize(const ItemBufferShape& shape) {
    if (shape == shape_) return;
    const glm::ivec2 size = shape.size();
    check_side(size, purpose::item_buffer);
    shape_ = {{0, 0}, 1, 0}; // until all textures are made
    polygon_depth_ = make_texture(GL_DEPTH_COMPONENT32F, size);
    line_depth_ = shape.layers > 1 ? make_texture(GL_DEPTH_COMPONENT32F, size) : Texture2D{};
    glNamedFramebufferTexture(polygon_framebuffer_.id(), GL_DEPTH_ATTACHMENT, polygon_depth_.id(),
                              0);
    for (std::uint32_t i = 0; i < max_layers; ++i) {
        Layer& layer = layers_[i];
        layer.ids = {};
        layer.readback = {};
        if (i >= shape.layers) continue;
        layer.ids = make_texture(GL_R32UI, size);
        layer.readback = Buffer::create();
        allocate(layer.readback, bytes_of(size), nullptr, GL_MAP_READ_BIT | GL_CLIENT_STORAGE_BIT,
                 purpose::item_buffer);
        // The last layer may change the polygons' depth. All layers before it need a copy.
        const bool last = i + 1 == shape.layers;
        glNamedFramebufferTexture(layer.framebuffer.id(), GL_COLOR_ATTACHMENT0, layer.ids.id(), 0);
        glNamedFramebufferTexture(layer.framebuffer.id(), GL_DEPTH_ATTACHMENT,
                                  last ? polygon_depth_.id() : line_depth_.id(), 0);
    }
    shape_ = shape;
}

void ItemBufferPass::draw_polygons(const TriangleBuffers& triangles,
                                   const glm::mat4& clip_from_world) {
    glBindFramebuffer(GL_FRAMEBUFFER, polygon_framebuffer_.id());
    const float far = 1.0F;
    glClearBufferfv(GL_DEPTH, 0, &far);
    if (triangles.triangle_count == 0) return;
    // A fragment's centre lies up to half the width of the line and half a texel from the spine.
    const auto width = static_cast<float>(std::min(shape_.scale, widest_line_));
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0.5F * width + 0.5F, offset_units);
    glVertexArrayVertexBuffer(polygon_array_.id(), 0, triangles.vertices, 0, 3 * sizeof(float));
    glVertexArrayElementBuffer(polygon_array_.id(), triangles.indices);
    glBindVertexArray(polygon_array_.id());
    polygon_program_.use();
    polygon_program_.set("clip_from_world", clip_from_world);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles.triangle_count * 3),
                   GL_UNSIGNED_INT, nullptr);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

void ItemBufferPass::draw_layer(std::uint32_t i) {
    const Layer& layer = layers_[i];
    const glm::ivec2 size = shape_.size();
    if (i + 1 < shape_.layers) {
        glCopyImageSubData(polygon_depth_.id(), GL_TEXTURE_2D, 0, 0, 0, 0, line_depth_.id(),
                           GL_TEXTURE_2D, 0, 0, 0, 0, size.x, size.y, 1);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer.id());
    const std::array<GLuint, 4> nothing{};
    glClearBufferuiv(GL_COLOR, 0, nothing.data());
    for (std::uint32_t before = 0; before < i; ++before) {
        glBindTextureUnit(before, layers_[before].ids.id());
    }
    line_program_.set("layer", static_cast<int>(i));
    glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(line_count_ * 2));
    glBindBuffer(GL_PIXEL_PACK_BUFFER, layer.readback.id());
    glReadPixels(0, 0, size.x, size.y, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

ItemImages ItemBufferPass::draw(const TriangleBuffers& triangles, const glm::mat4& clip_from_world,
                                const ItemBufferShape& shape) {
    if (line_count_ > 0) glUnmapNamedBuffer(lines_.id());
    resize(shape);
    const glm::ivec2 size = shape.size();
    set_viewport({0, 0}, size);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisablei(GL_BLEND, 0);
    glDisable(GL_CULL_FACE);
    draw_polygons(triangles, clip_from_world);

    ItemImages images{.texels = {},
                      .layers = shape.layers,
                      .size = size,
                      .line_width = std::min(shape.scale, widest_line_)};
    glBindVertexArray(line_array_.id());
    glLineWidth(static_cast<float>(images.line_width));
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    line_program_.use();
    for (std::uint32_t i = 0; i < shape.layers; ++i) draw_layer(i);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glLineWidth(1.0F);
    glDisable(GL_DEPTH_TEST);

    for (std::uint32_t i = 0; i < shape.layers; ++i) {
        images.texels[i] = static_cast<const std::uint32_t*>(
            map(layers_[i].readback, bytes_of(size), GL_MAP_READ_BIT, purpose::item_buffer));
    }
    return images;
}

void ItemBufferPass::unmap_images() {
    for (std::uint32_t i = 0; i < shape_.layers; ++i) glUnmapNamedBuffer(layers_[i].readback.id());
}

} // namespace lineatlas::gl
