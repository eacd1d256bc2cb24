// A program with its own window, shading and depth buffer draws lines over its picture.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include <GLFW/glfw3.h>
#include <glm/gtc/type_ptr.hpp>
#include <lineatlas/error.hpp>
#include <lineatlas/renderer.hpp>
#include <lineatlas/scenes.hpp>

using namespace lineatlas;

namespace {

constexpr glm::ivec2 size{800, 600};

constexpr const char* vertex_shader = R"(#version 450
layout(location = 0) in vec3 position;
uniform mat4 clip_from_world, eye_from_world;
out vec3 eye_position;
void main() {
    eye_position = vec3(eye_from_world * vec4(position, 1));
    gl_Position = clip_from_world * vec4(position, 1);
})";

constexpr const char* fragment_shader = R"(#version 450
in vec3 eye_position;
out vec4 color;
void main() {
    vec3 normal = normalize(cross(dFdx(eye_position), dFdy(eye_position)));
    color = vec4(mix(vec3(0.55, 0.62, 0.72), vec3(1, 0.97, 0.9), abs(normal.z)), 1);
})";

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

void load_triangles(const Mesh& mesh) { // into the vertex array that is bound
    GLuint buffers[2];
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.positions.size() * sizeof(glm::vec3)),
                 mesh.positions.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(glm::uvec3)),
                 mesh.triangles.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
}

GLuint make_texture(GLenum format) {
    GLuint texture;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, format, size.x, size.y);
    return texture;
}

void save(const char* path) {
    std::vector<unsigned char> pixels(static_cast<std::size_t>(size.x * size.y) * 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << size.x << ' ' << size.y << "\n255\n";
    for (int y = size.y - 1; y >= 0; --y)
        file.write(reinterpret_cast<const char*>(&pixels[static_cast<std::size_t>(y * size.x) * 3]),
                   size.x * 3);
}

void run(GLFWwindow* window, int most_frames, const char* screenshot) {
    const Scene scene = make_scene("clevis"); // stands for your program's own model
    const GLuint program = make_program();
    GLuint vertices, framebuffer;
    glGenVertexArrays(1, &vertices);
    glBindVertexArray(vertices);
    load_triangles(scene.mesh);

    const GLuint depth = make_texture(GL_DEPTH_COMPONENT24);
    glCreateFramebuffers(1, &framebuffer);
    glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, make_texture(GL_RGBA8), 0);
    glNamedFramebufferTexture(framebuffer, GL_DEPTH_ATTACHMENT, depth, 0);

    Renderer renderer;
    renderer.set_lines(extract_lines(scene.mesh));
    FrameOptions options;
    options.own_depth = DepthTexture{.texture = depth};
    options.style.pen.width = 2.5F;

    const Bounds bounds = bounds_of(scene.mesh);
    for (int frame = 0; !glfwWindowShouldClose(window) && frame != most_frames; ++frame) {
        const Camera camera =
            make_camera(scene.view(static_cast<float>(frame % 500) / 500), size, bounds);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glViewport(0, 0, size.x, size.y);
        glClearColor(0.97F, 0.96F, 0.93F, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);
        glUseProgram(program);
        glUniformMatrix4fv(glGetUniformLocation(program, "clip_from_world"), 1, GL_FALSE,
                           glm::value_ptr(camera.clip_from_world()));
        glUniformMatrix4fv(glGetUniformLocation(program, "eye_from_world"), 1, GL_FALSE,
                           glm::value_ptr(camera.view));
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(scene.mesh.triangles.size() * 3),
                       GL_UNSIGNED_INT, nullptr);

        renderer.draw(camera, options, bound_framebuffer);

        glBlitNamedFramebuffer(framebuffer, 0, 0, 0, size.x, size.y, 0, 0, size.x, size.y,
                               GL_COLOR_BUFFER_BIT, GL_NEAREST);
        if (screenshot != nullptr && frame + 1 == most_frames) {
            glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
            save(screenshot);
        }
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
}

} // namespace

int main(int argc, char** argv) { // for its test: window FRAMES SCREENSHOT.ppm
    if (glfwInit() == GLFW_FALSE) return EXIT_FAILURE;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
    GLFWwindow* window = glfwCreateWindow(size.x, size.y, "lineatlas", nullptr, nullptr);
    if (window == nullptr) return EXIT_FAILURE;
    glfwMakeContextCurrent(window);
    int status = EXIT_SUCCESS;
    try {
        run(window, argc > 1 ? std::atoi(argv[1]) : -1, argc > 2 ? argv[2] : nullptr);
    } catch (const Error& error) {
        std::cerr << "window: " << error.what() << '\n';
        status = EXIT_FAILURE;
    }
    glfwTerminate();
    return status;
}
