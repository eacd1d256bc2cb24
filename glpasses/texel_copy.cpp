#include "texel_copy.hpp"

#include <algorithm>
#include <cstdint>

#include "storage.hpp"

namespace lineatlas::gl {
namespace {

constexpr int group = 16; // local size of copy_texels.comp

/// Keeps the first storage buffer of the program around, and binds it again at the end.
class StorageBinding {
  public:
    explicit StorageBinding(GLuint buffer) {
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, 0, &before_);
        glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_START, 0, &start_);
        glGetInteger64i_v(GL_SHADER_STORAGE_BUFFER_SIZE, 0, &size_);
        glGetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &general_);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
    }
    ~StorageBinding() {
        const auto before = static_cast<GLuint>(before_);
        if (size_ > 0)
            glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, before, start_, size_);
        else
            glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, before);
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(general_));
    }
    StorageBinding(const StorageBinding&) = delete;
    StorageBinding& operator=(const StorageBinding&) = delete;

  private:
    GLint before_ = 0, general_ = 0;
    GLint64 start_ = 0, size_ = 0;
};

std::size_t bytes_of(glm::ivec2 size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
           sizeof(std::uint32_t);
}

std::size_t largest_storage() {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return static_cast<std::size_t>(bytes);
}

void copy_by_driver(GLuint texture, GLenum format, GLenum type, glm::ivec2 whole,
                    const TexelRectangle& part, GLuint buffer) {
    const glm::ivec2 size = part.size();
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_PACK_ROW_LENGTH, whole.x);
    const std::size_t row = static_cast<std::size_t>(whole.x) * sizeof(float);
    const std::size_t left = static_cast<std::size_t>(part.low.x) * sizeof(float);
    const int most_rows = rows_at_once(row);
    for (int low = part.low.y; low < part.high.y; low += most_rows) {
        const int rows = std::min(part.high.y - low, most_rows);
        glGetTextureSubImage(texture, 0, part.low.x, low, 0, size.x, rows, 1, format, type,
                             static_cast<GLsizei>(row * static_cast<std::size_t>(rows) - left),
                             reinterpret_cast<void*>(row * static_cast<std::size_t>(low) + left));
    }
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

} // namespace

TexelCopy::TexelCopy(bool by_shader) : by_shader_(by_shader) {}

void TexelCopy::copy(GLuint texture, GLenum format, GLenum type, glm::ivec2 size,
                     const TexelRectangle& part, GLuint buffer) {
    if (part.size().x <= 0 || part.size().y <= 0) return;
    if (by_shader_ && bytes_of(size) <= largest_storage())
        copy_by_shader(texture, format, size, part, buffer);
    else
        copy_by_driver(texture, format, type, size, part, buffer);
}

void TexelCopy::copy_by_shader(GLuint texture, GLenum format, glm::ivec2 size,
                               const TexelRectangle& part, GLuint buffer) {
    const StorageBinding binding{buffer};
    const Program& program = programs_.with(format == GL_RED_INTEGER ? "NUMBERS" : "");
    program.use();
    program.set("texels", 0);
    program.set("part", glm::ivec4{part.low, part.size()});
    program.set("row", size.x);
    glBindTextureUnit(0, texture);
    glBindSampler(0, 0);
    const glm::uvec2 groups{(part.size() + (group - 1)) / group};
    glDispatchCompute(groups.x, groups.y, 1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

} // namespace lineatlas::gl
