#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec2.hpp>

#include "core/limits.hpp"
#include "objects.hpp"

namespace lineatlas::gl {

/// Memory for GL's objects. Each function throws DeviceError if GL has no memory, or if the object
/// would be larger than the device allows. Then the object does not change. Earlier errors of GL
/// are taken off its list first, because drivers note only one.
void allocate(const Buffer& buffer, std::size_t bytes, const void* data, GLbitfield flags,
              const Purpose& purpose);
/// Gives a buffer other content, perhaps of another size.
void refill(const Buffer& buffer, std::size_t bytes, const void* data, const Purpose& purpose);
void allocate(const Texture2D& texture, GLenum format, glm::ivec2 size, const Purpose& purpose);
void allocate(const Renderbuffer& buffer, GLenum format, glm::ivec2 size, const Purpose& purpose);

/// Makes a buffer of the first `bytes` of memory that another API has exported
/// (GL_EXT_memory_object_fd). `whole`: bytes of that memory. Takes the descriptor.
void import(const Buffer& buffer, std::size_t bytes, int descriptor, std::size_t whole,
            const Purpose& purpose);

/// The first `bytes` of a buffer as host memory. Throws as above.
void* map(const Buffer& buffer, std::size_t bytes, GLbitfield access, const Purpose& purpose);

/// The longest side that can be drawn to: the smallest limit of textures, renderbuffers and
/// viewports.
int largest_side();
/// Throws UsageError for a picture that is larger.
void check_side(glm::ivec2 size, const Purpose& purpose);

/// How many rows of `row_bytes` bytes GL reads back at once. GL counts bytes in 31 bits.
int rows_at_once(std::size_t row_bytes);

/// Throws DeviceError if a texture over a buffer cannot show that many texels. GL would leave out
/// the others without an error.
void check_buffer_texture(std::uint64_t texels, const Purpose& purpose);

} // namespace lineatlas::gl
