#include "scene_buffers.hpp"

#include <algorithm>
#include <span>
#include <string>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

template <class T>
std::span<const std::byte> bytes_of(const std::vector<T>& values) {
    return std::as_bytes(std::span{values});
}

gl::Buffer upload_gl(std::span<const std::byte> data) {
    gl::Buffer buffer = gl::Buffer::create();
    const std::byte nothing{};
    glNamedBufferStorage(buffer.id(),
                         static_cast<GLsizeiptr>(std::max<std::size_t>(data.size(), 1)),
                         data.empty() ? &nothing : data.data(), 0);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        throw DeviceError("GL has no memory for a model of " + std::to_string(data.size() >> 20U) +
                          " MiB");
    }
    return buffer;
}

std::unique_ptr<compute::Buffer> upload(compute::Backend& backend,
                                        std::span<const std::byte> data) {
    std::unique_ptr<compute::Buffer> buffer = backend.allocate(data.size());
    backend.upload(*buffer, data);
    return buffer;
}

} // namespace

SceneBuffers::SceneBuffers(compute::Backend& backend, const LineSet& lines)
    : vertices_(upload(backend, bytes_of(lines.vertices))),
      triangles_(upload(backend, bytes_of(lines.triangles))),
      segments_(upload(backend, bytes_of(lines.segments))),
      gl_vertices_(upload_gl(bytes_of(lines.vertices))),
      gl_indices_(upload_gl(bytes_of(lines.triangles))),
      triangle_count_(static_cast<std::uint32_t>(lines.triangles.size())),
      segment_count_(static_cast<std::uint32_t>(lines.segments.size())) {}

} // namespace lineatlas
