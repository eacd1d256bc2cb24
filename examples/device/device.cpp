// Draws a built-in model on a device of its own: device PICTURE.ppm
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

#include <epoxy/gl.h>

#include <lineatlas/error.hpp>
#include <lineatlas/headless.hpp>
#include <lineatlas/renderer.hpp>
#include <lineatlas/scenes.hpp>

#include "threads_device.hpp"

using namespace lineatlas;

namespace {

constexpr glm::ivec2 size{800, 600};

/// Makes a white framebuffer and binds it.
void make_framebuffer() {
    GLuint framebuffer, color;
    glCreateFramebuffers(1, &framebuffer);
    glCreateTextures(GL_TEXTURE_2D, 1, &color);
    glTextureStorage2D(color, 1, GL_RGBA8, size.x, size.y);
    glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, color, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

void write_ppm(const char* path) {
    const auto row = static_cast<std::ptrdiff_t>(size.x) * 3;
    std::vector<char> pixels(static_cast<std::size_t>(row * size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << size.x << ' ' << size.y << "\n255\n";
    for (int y = size.y - 1; y >= 0; --y) file.write(pixels.data() + y * row, row);
    if (!file.flush()) throw FileError(std::string(path) + ": cannot be written");
}

void draw(const char* picture) {
    const Scene scene = make_scene("clevis");
    const Camera camera = make_camera(scene.view(0), size, bounds_of(scene.mesh));
    HeadlessContext context;
    make_framebuffer();

    register_threads_device();
    // For developing a device: every kernel also runs on "cpp". The first kernel whose results
    // differ is named.
    Renderer renderer({.compute = "threads", .compare_with = "cpp"});
    renderer.set_lines(extract_lines(scene.mesh));
    renderer.draw(camera, {.forms = {.atlas = StageForm::compute}}, bound_framebuffer);
    std::cout << renderer.description() << ": equal in " << renderer.comparison().kernels
              << " kernels\n";

    // For using the device.
    renderer.set_device({.compute = "threads"});
    glClear(GL_COLOR_BUFFER_BIT);
    renderer.draw(camera, {}, bound_framebuffer);
    write_ppm(picture);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: device PICTURE.ppm\n";
        return 2;
    }
    try {
        draw(argv[1]);
    } catch (const Error& error) {
        std::cerr << "device: " << error.what() << '\n';
        return EXIT_FAILURE;
    }
}
