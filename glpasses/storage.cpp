#include "storage.hpp"

#include <string>

#include "lineatlas/error.hpp"

namespace lineatlas::gl {
namespace {

DeviceError no_memory(std::string_view what, const std::string& size) {
    return DeviceError("GL has no memory for " + std::string{what} + " (" + size +
                       "); choose a smaller --size or --depth-scale, or fewer --lines kinds");
}

std::string written(std::size_t bytes) {
    return std::to_string((bytes + 1023) >> 10U) + " KiB";
}
std::string written(glm::ivec2 size) {
    return std::to_string(size.x) + "x" + std::to_string(size.y);
}

void forget_errors() {
    constexpr int most = 16; // a lost context never runs out of them
    for (int i = 0; i < most && glGetError() != GL_NO_ERROR; ++i) {
    }
}

/// Runs what gives an object its memory; `size`: how much.
template <class Size, class Action>
void checked(std::string_view what, Size size, Action&& action) {
    forget_errors();
    action();
    if (glGetError() != GL_NO_ERROR) throw no_memory(what, written(size));
}

} // namespace

void allocate(const Buffer& buffer, std::size_t bytes, const void* data, GLbitfield flags,
              std::string_view what) {
    checked(what, bytes, [&] {
        glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(bytes), data, flags);
    });
}

void allocate(const Texture2D& texture, GLenum format, glm::ivec2 size, std::string_view what) {
    checked(what, size, [&] { glTextureStorage2D(texture.id(), 1, format, size.x, size.y); });
}

void allocate(const Renderbuffer& buffer, GLenum format, glm::ivec2 size, std::string_view what) {
    checked(what, size, [&] { glNamedRenderbufferStorage(buffer.id(), format, size.x, size.y); });
}

void* map(const Buffer& buffer, std::size_t bytes, GLbitfield access, std::string_view what) {
    void* memory = glMapNamedBufferRange(buffer.id(), 0, static_cast<GLsizeiptr>(bytes), access);
    if (memory == nullptr) throw no_memory(what, written(bytes));
    return memory;
}

} // namespace lineatlas::gl
