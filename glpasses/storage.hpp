#pragma once

#include <cstddef>
#include <string_view>

#include <glm/vec2.hpp>

#include "objects.hpp"

namespace lineatlas::gl {

/// Memory for GL's objects. `what` it is for stands in the DeviceError that each throws where GL
/// has none; the object is as it was then. Errors of GL's from before are taken off its list:
/// drivers note only one.
void allocate(const Buffer& buffer, std::size_t bytes, const void* data, GLbitfield flags,
              std::string_view what);
void allocate(const Texture2D& texture, GLenum format, glm::ivec2 size, std::string_view what);
void allocate(const Renderbuffer& buffer, GLenum format, glm::ivec2 size, std::string_view what);

/// The first `bytes` of a buffer as host memory. Throws as above.
void* map(const Buffer& buffer, std::size_t bytes, GLbitfield access, std::string_view what);

} // namespace lineatlas::gl
