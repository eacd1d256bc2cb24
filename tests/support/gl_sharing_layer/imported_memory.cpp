#include "imported_memory.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include <epoxy/gl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace lineatlas::test {
namespace {

constexpr std::array<std::uint32_t, 4> pattern{0x6C696E65, 0x61746C61, 0x73C0FFEE, 0x00C0FFEE};

/// Fills the memory by GL, which takes the descriptor.
void fill(int descriptor, std::size_t whole, std::size_t bytes) {
    GLuint memory = 0, buffer = 0;
    glCreateMemoryObjectsEXT(1, &memory);
    glImportMemoryFdEXT(memory, whole, GL_HANDLE_TYPE_OPAQUE_FD_EXT, descriptor);
    glCreateBuffers(1, &buffer);
    glNamedBufferStorageMemEXT(buffer, static_cast<GLsizeiptr>(bytes), memory, 0);
    glClearNamedBufferData(buffer, GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, pattern.data());
    glFinish();
    glDeleteBuffers(1, &buffer);
    glDeleteMemoryObjectsEXT(1, &memory);
}

} // namespace

std::shared_ptr<std::byte> import(int descriptor, std::size_t bytes) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) return nullptr;
    const auto whole = static_cast<std::size_t>(status.st_size);
    void* const start = ::mmap(nullptr, whole, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    if (start == MAP_FAILED) return nullptr;
    const std::shared_ptr<std::byte> mapped{static_cast<std::byte*>(start),
                                            [whole](std::byte* p) { ::munmap(p, whole); }};
    fill(descriptor, whole, bytes / sizeof pattern * sizeof pattern);
    const std::span memory{mapped.get(), whole};
    const auto found = std::ranges::search(memory, std::as_bytes(std::span{pattern})).begin();
    if (found == memory.end()) return nullptr;
    return {mapped, &*found};
}

} // namespace lineatlas::test
