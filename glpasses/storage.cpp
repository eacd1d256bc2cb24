#include "storage.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "lineatlas/error.hpp"

namespace lineatlas::gl {
namespace {

constexpr const char* no_memory = "GL has no memory left for that";

GLint limit(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

void forget_errors() {
    constexpr int most = 16; // a lost context never runs out of errors
    for (int i = 0; i < most && glGetError() != GL_NO_ERROR; ++i) {
    }
}

std::string written(std::size_t bytes) {
    return written_bytes(bytes);
}
std::string written(glm::ivec2 size) {
    return written_size(size) + " texels";
}

std::string too_large(glm::ivec2 size, int largest, const Purpose& purpose) {
    return beyond_limit(purpose, written(size),
                        "GL draws up to " + std::to_string(largest) + " a side here");
}

/// Runs an action that gives an object its memory. `size`: how much, for the message.
template <class Size, class Action>
void checked(const Purpose& purpose, Size size, Action&& action) {
    forget_errors();
    action();
    if (glGetError() != GL_NO_ERROR) {
        throw OutOfMemory(purpose, written(size), no_memory);
    }
}

void check_limit(glm::ivec2 size, GLenum name, const Purpose& purpose) {
    const GLint largest = limit(name);
    if (std::max(size.x, size.y) > largest) throw DeviceError(too_large(size, largest, purpose));
}

} // namespace

void allocate(const Buffer& buffer, std::size_t bytes, const void* data, GLbitfield flags,
              const Purpose& purpose) {
    checked(purpose, bytes, [&] {
        glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(bytes), data, flags);
    });
}

void refill(const Buffer& buffer, std::size_t bytes, const void* data, const Purpose& purpose) {
    checked(purpose, bytes, [&] {
        glNamedBufferData(buffer.id(), static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
    });
}

void allocate(const Texture2D& texture, GLenum format, glm::ivec2 size, const Purpose& purpose) {
    check_limit(size, GL_MAX_TEXTURE_SIZE, purpose);
    checked(purpose, size, [&] { glTextureStorage2D(texture.id(), 1, format, size.x, size.y); });
}

void allocate(const Renderbuffer& buffer, GLenum format, glm::ivec2 size, const Purpose& purpose) {
    check_limit(size, GL_MAX_RENDERBUFFER_SIZE, purpose);
    checked(purpose, size,
            [&] { glNamedRenderbufferStorage(buffer.id(), format, size.x, size.y); });
}

void import(const Buffer& buffer, std::size_t bytes, int descriptor, std::size_t whole,
            const Purpose& purpose) {
    checked(purpose, bytes, [&] {
        GLuint memory = 0;
        glCreateMemoryObjectsEXT(1, &memory);
        glImportMemoryFdEXT(memory, whole, GL_HANDLE_TYPE_OPAQUE_FD_EXT, descriptor);
        glNamedBufferStorageMemEXT(buffer.id(), static_cast<GLsizeiptr>(bytes), memory, 0);
        glDeleteMemoryObjectsEXT(1, &memory); // the buffer holds the memory
    });
}

void* map(const Buffer& buffer, std::size_t bytes, GLbitfield access, const Purpose& purpose) {
    void* memory = glMapNamedBufferRange(buffer.id(), 0, static_cast<GLsizeiptr>(bytes), access);
    if (memory == nullptr) {
        throw DeviceError(beyond_limit(purpose, written_bytes(bytes), no_memory));
    }
    return memory;
}

int largest_side() {
    std::array<GLint, 2> viewport{};
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    return std::min(
        {limit(GL_MAX_TEXTURE_SIZE), limit(GL_MAX_RENDERBUFFER_SIZE), viewport[0], viewport[1]});
}

void check_side(glm::ivec2 size, const Purpose& purpose) {
    const int largest = largest_side();
    if (std::max(size.x, size.y) > largest) throw UsageError(too_large(size, largest, purpose));
}

int rows_at_once(std::size_t row_bytes) {
    return static_cast<int>(std::max<std::size_t>((1U << 30U) / row_bytes, 1));
}

void check_buffer_texture(std::uint64_t texels, const Purpose& purpose) {
    const auto most = static_cast<std::uint64_t>(limit(GL_MAX_TEXTURE_BUFFER_SIZE));
    if (texels <= most) return;
    throw DeviceError(beyond_limit(purpose, std::to_string(texels) + " values in GL",
                                   "a shader reads up to " + std::to_string(most) +
                                       " here (GL_MAX_TEXTURE_BUFFER_SIZE)"));
}

} // namespace lineatlas::gl
