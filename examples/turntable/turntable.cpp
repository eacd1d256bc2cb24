// Draws a sequence. It prints its progress and stops on Ctrl-C, even in the middle of a frame.
// Usage: turntable FRAMES
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include <lineatlas/camera_path.hpp>
#include <lineatlas/progress.hpp>
#include <lineatlas/scenes.hpp>
#include <lineatlas/style_files.hpp>
#include <lineatlas/vector.hpp>
#include <lineatlas/visibility.hpp>

using namespace lineatlas;

namespace {

volatile std::sig_atomic_t stopped = 0;

void draw_turn(int frames) {
    const glm::ivec2 size{640, 480};
    const LineSet lines = extract_lines(make_scene("clevis").mesh);
    const Axis axis{.point = 0.5F * (lines.bounds.min + lines.bounds.max)};
    const View first = frame_points(swept(lines.vertices, axis), size);
    LineVisibility visibility{lines};
    for (int frame = 0; frame < frames; ++frame) {
        const auto progress = [&](float done) {
            std::cerr << "\r" << 100 * (frame + double{done}) / frames << " %  ";
            return stopped == 0;
        };
        const View view = turned(first, axis, static_cast<double>(frame) / frames);
        const Camera camera = make_camera(view, size, lines.bounds);
        const std::vector<Interval> found =
            visibility.find(camera, {.hidden = true, .outlines = true}, progress);
        std::ofstream{"turn." + std::to_string(frame) + ".svg"} << to_svg(make_vector_drawing(
            lines, camera, found, default_style(), {.outlines = visibility.outlines()}));
    }
}

} // namespace

int main(int count, char** words) {
    std::signal(SIGINT, [](int) { stopped = 1; });
    try {
        draw_turn(count > 1 ? std::atoi(words[1]) : 36);
    } catch (const Cancelled&) {
        std::cerr << "\nstopped; the drawings so far are whole\n";
        return EXIT_FAILURE;
    } catch (const Error& error) {
        std::cerr << "turntable: " << error.what() << '\n';
        return EXIT_FAILURE;
    }
}
