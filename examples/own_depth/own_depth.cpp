// Draws lines by the depth buffer of another renderer. The buffer is reversed and multisampled, its
// far plane is at infinity, and its clip space goes from 0 to 1. Usage: own_depth PICTURE.ppm
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>
#include <lineatlas/error.hpp>
#include <lineatlas/headless.hpp>
#include <lineatlas/renderer.hpp>
#include <lineatlas/scenes.hpp>

using namespace lineatlas;

namespace {

constexpr glm::ivec2 size{800, 600};

constexpr const char* vertex_shader = R"(#version 450
layout(location = 0) in vec3 position;
uniform mat4 clip_from_world;
void main() { gl_Position = clip_from_world * vec4(position, 1); })";

constexpr const char* fragment_shader = R"(#version 450
out vec4 color;
void main() { color = vec4(0.72, 0.79, 0.84, 1); })";

GLuint make_program() {
    const GLuint program = glCreateProgram();
    for (auto [type, text] : {std::pair{GL_VERTEX_SHADER, vertex_shader},
                              std::pair{GL_FRAGMENT_SHADER, fragment_shader}}) {
        const GLuint shader = glCreateShader(type);
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
    }
    glLinkProgram(program);
    return program;
}

struct Target {
    GLuint framebuffer, depth;
};

Target make_target(int samples) {
    GLuint framebuffer, textures[2];
    glCreateFramebuffers(1, &framebuffer);
    glCreateTextures(samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, 2, textures);
    const GLenum formats[]{GL_RGBA8, GL_DEPTH_COMPONENT32F};
    for (int i = 0; i < 2; ++i) {
        if (samples > 1)
            glTextureStorage2DMultisample(textures[i], samples, formats[i], size.x, size.y,
                                          GL_TRUE);
        else
            glTextureStorage2D(textures[i], 1, formats[i], size.x, size.y);
        glNamedFramebufferTexture(framebuffer, i == 0 ? GL_COLOR_ATTACHMENT0 : GL_DEPTH_ATTACHMENT,
                                  textures[i], 0);
    }
    return {framebuffer, textures[1]};
}

/// A projection with depth 1 at the near plane and 0 at infinity.
glm::mat4 reversed_projection(float fov_y, float near) {
    const float focal = 1 / std::tan(fov_y / 2);
    glm::mat4 projection(0);
    projection[0][0] = focal * static_cast<float>(size.y) / static_cast<float>(size.x);
    projection[1][1] = focal;
    projection[2][3] = -1;
    projection[3][2] = near;
    return projection;
}

void draw_triangles(const Mesh& mesh, const Camera& camera) {
    GLuint vertices, buffers[2];
    glCreateVertexArrays(1, &vertices);
    glCreateBuffers(2, buffers);
    glNamedBufferStorage(buffers[0],
                         static_cast<GLsizeiptr>(mesh.positions.size() * sizeof(glm::vec3)),
                         mesh.positions.data(), 0);
    glNamedBufferStorage(buffers[1],
                         static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(glm::uvec3)),
                         mesh.triangles.data(), 0);
    glVertexArrayVertexBuffer(vertices, 0, buffers[0], 0, sizeof(glm::vec3));
    glVertexArrayAttribFormat(vertices, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glEnableVertexArrayAttrib(vertices, 0);
    glVertexArrayElementBuffer(vertices, buffers[1]);
    glBindVertexArray(vertices);
    const GLuint program = make_program();
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "clip_from_world"), 1, GL_FALSE,
                       glm::value_ptr(camera.clip_from_world()));
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.triangles.size() * 3), GL_UNSIGNED_INT,
                   nullptr);
}

void save(const char* path) {
    std::vector<unsigned char> pixels(static_cast<std::size_t>(size.x * size.y) * 3);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << size.x << ' ' << size.y << "\n255\n";
    for (int y = size.y - 1; y >= 0; --y)
        file.write(reinterpret_cast<const char*>(&pixels[static_cast<std::size_t>(y * size.x) * 3]),
                   size.x * 3);
}

void draw(const char* picture) {
    HeadlessContext context;
    const Scene scene = make_scene("clevis");
    const View view = scene.view(0);
    Camera camera = make_camera(view, size, bounds_of(scene.mesh));
    camera.projection = reversed_projection(view.fov_y, view.near);
    camera.clip.zero_to_one = true; // set by glClipControl below

    // The program's own picture.
    const Target drawn = make_target(4);
    glBindFramebuffer(GL_FRAMEBUFFER, drawn.framebuffer);
    glViewport(0, 0, size.x, size.y);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glClearDepth(0);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_triangles(scene.mesh, camera);

    // Multisampled depth has several values per pixel, which the renderer refuses. So resolve it.
    const Target resolved = make_target(1);
    glBlitNamedFramebuffer(drawn.framebuffer, resolved.framebuffer, 0, 0, size.x, size.y, 0, 0,
                           size.x, size.y, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);

    Renderer renderer;
    renderer.set_lines(extract_lines(scene.mesh));
    FrameOptions options;
    options.style.pen.width = 2.5F;
    options.own_depth = DepthTexture{.texture = drawn.depth};
    try {
        renderer.draw(camera, options, resolved.framebuffer);
    } catch (const UsageError& error) {
        std::cout << error.what() << '\n';
    }
    options.own_depth = DepthTexture{.texture = resolved.depth};
    renderer.draw(camera, options, resolved.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, resolved.framebuffer);
    save(picture);
}

} // namespace

int main(int argc, char** argv) {
    try {
        draw(argc > 1 ? argv[1] : "own_depth.ppm");
    } catch (const Error& error) {
        std::cerr << "own_depth: " << error.what() << '\n';
        return EXIT_FAILURE;
    }
}
