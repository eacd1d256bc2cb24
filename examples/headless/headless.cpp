// Draws a model into a picture without a window. Usage: headless MODEL PICTURE
#include <cstdlib>
#include <iostream>
#include <vector>

#include <epoxy/gl.h>

#include <lineatlas/error.hpp>
#include <lineatlas/headless.hpp>
#include <lineatlas/io.hpp>
#include <lineatlas/renderer.hpp>
#include <lineatlas/style_files.hpp>

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

Image read_pixels() {
    const std::size_t row = static_cast<std::size_t>(size.x) * 4;
    std::vector<std::uint8_t> pixels(row * static_cast<std::size_t>(size.y));
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    Image image{.size = size, .channels = 4};
    for (auto y = pixels.end(); y != pixels.begin(); y -= static_cast<std::ptrdiff_t>(row))
        image.pixels.insert(image.pixels.end(), y - static_cast<std::ptrdiff_t>(row), y);
    return image;
}

void draw(const char* model, const char* picture) {
    const LoadedMesh loaded = load_mesh(model);
    for (const std::string& note : loaded.notes) std::cerr << note << '\n';
    const LineSet lines = extract_lines(loaded.mesh);

    HeadlessContext context;
    make_framebuffer();
    Renderer renderer;
    renderer.set_lines(lines);
    const Camera camera = make_camera(frame_points(lines.vertices, size), size, lines.bounds);
    renderer.draw(camera, default_frame_options(), bound_framebuffer);
    write_image(picture, read_pixels());
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: headless MODEL PICTURE\n";
        return 2;
    }
    try {
        draw(argv[1], argv[2]);
    } catch (const Error& error) {
        std::cerr << "headless: " << error.what() << '\n';
        return EXIT_FAILURE;
    }
}
