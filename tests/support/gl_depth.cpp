#include "gl_depth.hpp"

#include <span>

#include "glpasses/depth_pass.hpp"

namespace lineatlas::test {

std::vector<float> draw_depth_by_gl(const LineSet& lines, const Camera& camera, int scale) {
    const auto upload = [](const auto& values) {
        gl::Buffer buffer = gl::Buffer::create();
        const auto bytes = std::as_bytes(std::span{values});
        glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(bytes.size()), bytes.data(), 0);
        return buffer;
    };
    const gl::Buffer vertices = upload(lines.vertices);
    const gl::Buffer indices = upload(lines.triangles);
    gl::DepthPass pass;
    pass.begin(camera.size, scale);
    pass.draw({.vertices = vertices.id(),
               .indices = indices.id(),
               .triangle_count = static_cast<std::uint32_t>(lines.triangles.size())},
              camera.clip_from_world());
    std::vector<float> depth(static_cast<std::size_t>(pass.size().x) *
                             static_cast<std::size_t>(pass.size().y));
    glGetTextureImage(pass.texture(), 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                      static_cast<GLsizei>(depth.size() * sizeof(float)), depth.data());
    return depth;
}

} // namespace lineatlas::test
