#include "gl_scene.hpp"

#include <span>

namespace lineatlas::test {
namespace {

template <class T>
gl::Buffer upload(const std::vector<T>& values) {
    gl::Buffer buffer = gl::Buffer::create();
    glNamedBufferStorage(buffer.id(), static_cast<GLsizeiptr>(std::span{values}.size_bytes()),
                         values.data(), 0);
    return buffer;
}

} // namespace

glm::vec2 planes_of(const Camera& camera) {
    const double a = camera.projection[2][2], b = camera.projection[3][2];
    return {b / (a - 1), b / (a + 1)};
}

Camera app_camera(const Camera& camera, float near, float far, const DepthSetup& setup) {
    // depth = a + b / distance, from 0 at the near plane to 1 at the far plane.
    double a = setup.infinite ? 1.0 : double{far} / (far - near);
    double b = -a * near;
    if (setup.reversed) {
        a = 1 - a;
        b = -b;
    }
    if (!setup.clip.zero_to_one) {
        a = 2 * a - 1;
        b = 2 * b;
    }
    Camera result = camera;
    result.clip = setup.clip;
    result.projection[2][2] = static_cast<float>(-a);
    result.projection[3][2] = static_cast<float>(b);
    if (setup.clip.upper_left) result.projection[1][1] *= -1;
    return result;
}

AppScene::AppScene(const LineSet& lines)
    : program_({"depth.vert", "depth.frag"}), vertex_array_(gl::VertexArray::create()),
      vertices_(upload(lines.vertices)), indices_(upload(lines.triangles)),
      framebuffer_(gl::Framebuffer::create()),
      index_count_(static_cast<GLsizei>(3 * lines.triangles.size())) {
    glEnableVertexArrayAttrib(vertex_array_.id(), 0);
    glVertexArrayAttribFormat(vertex_array_.id(), 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(vertex_array_.id(), 0, 0);
    glVertexArrayVertexBuffer(vertex_array_.id(), 0, vertices_.id(), 0, 3 * sizeof(float));
    glVertexArrayElementBuffer(vertex_array_.id(), indices_.id());
}

void AppScene::draw_depth(const Camera& camera, const DepthSetup& setup) {
    const glm::ivec2 size = camera.size * setup.scale;
    const glm::ivec2 whole = setup.origin + size;
    depth_ = gl::Texture2D::create();
    glTextureStorage2D(depth_.id(), 1, setup.format, whole.x, whole.y);
    const bool stencil =
        setup.format == GL_DEPTH24_STENCIL8 || setup.format == GL_DEPTH32F_STENCIL8;
    glNamedFramebufferTexture(framebuffer_.id(), GL_STENCIL_ATTACHMENT, 0, 0);
    glNamedFramebufferTexture(framebuffer_.id(),
                              stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                              depth_.id(), 0);
    glNamedFramebufferDrawBuffer(framebuffer_.id(), GL_NONE);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    const float far = setup.reversed ? setup.range.x : setup.range.y;
    glClearBufferfv(GL_DEPTH, 0, &far);
    glViewport(setup.origin.x, setup.origin.y, size.x, size.y);
    glDepthRange(setup.range.x, setup.range.y);
    glClipControl(setup.clip.upper_left ? GL_UPPER_LEFT : GL_LOWER_LEFT,
                  setup.clip.zero_to_one ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    const bool grows = (setup.range.x < setup.range.y) != setup.reversed;
    glDepthFunc(grows ? GL_LESS : GL_GREATER);
    program_.use();
    program_.set("clip_from_world", camera.clip_from_world());
    glBindVertexArray(vertex_array_.id());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
    glUseProgram(0);
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthRange(0, 1);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

} // namespace lineatlas::test
