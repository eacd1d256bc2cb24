// Checks that a picture of the built-in scene clevis has its lines at the right places. Usage:
// check_lines PICTURE.ppm T. T is the camera's place on its path. Any program may have drawn the
// picture, with dark lines on a bright ground.

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lineatlas/error.hpp"
#include "lineatlas/headless.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"

namespace lineatlas {
namespace {

constexpr int dark = 100;       ///< every channel of a dark pixel is lower
constexpr int reach = 4;        ///< dark pixels may be this many pixels from a visible line
constexpr float end_margin = 3; ///< pixels at either end of a visible line that need not be dark
constexpr double least_drawn = 0.99;
constexpr double most_stray = 0.0002;

struct Picture {
    glm::ivec2 size{0, 0};
    std::vector<std::uint8_t> rgb; ///< rows from the top

    bool contains(glm::ivec2 at) const {
        return at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
    }
    std::size_t index(glm::ivec2 at) const { // y up
        return static_cast<std::size_t>((size.y - 1 - at.y) * size.x + at.x);
    }
    bool is_dark(glm::ivec2 at) const {
        const std::uint8_t* pixel = &rgb[3 * index(at)];
        return pixel[0] < dark && pixel[1] < dark && pixel[2] < dark;
    }
};

Picture read_ppm(const char* path) {
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    int most = 0;
    Picture picture;
    file >> magic >> picture.size.x >> picture.size.y >> most;
    file.get();
    if (!file || magic != "P6" || most != 255) throw FileError(std::string(path) + ": no PPM file");
    picture.rgb.resize(static_cast<std::size_t>(picture.size.x * picture.size.y) * 3);
    file.read(reinterpret_cast<char*>(picture.rgb.data()),
              static_cast<std::streamsize>(picture.rgb.size()));
    if (!file) throw FileError(std::string(path) + ": too short");
    return picture;
}

std::vector<Interval> visible_lines(float t, glm::ivec2 size) {
    const HeadlessContext context;
    const Scene scene = make_scene("clevis");
    Renderer renderer;
    renderer.set_lines(extract_lines(scene.mesh));
    renderer.draw(make_camera(scene.view(t), size, bounds_of(scene.mesh)),
                  {.intervals = KeptIntervals::visible, .draw = false}, 0);
    return renderer.read_intervals();
}

/// Calls `visit` with every pixel along a line, `margin` from its ends.
template <class Visit>
void walk(const Interval& line, float margin, Visit visit) {
    const glm::vec2 start{line.start[0], line.start[1]}, end{line.end[0], line.end[1]};
    const float length = glm::distance(start, end);
    for (float at = margin; at <= length - margin; ++at)
        visit(glm::ivec2(glm::floor(glm::mix(start, end, at / length))));
}

bool check(const Picture& picture, const std::vector<Interval>& lines) {
    std::uint64_t asked = 0, drawn = 0, beside = 0, stray = 0;
    std::vector<bool> near(picture.rgb.size() / 3);
    for (const Interval& line : lines) {
        walk(line, end_margin, [&](glm::ivec2 at) {
            if (!picture.contains(at)) return;
            ++asked;
            drawn += picture.is_dark(at) ? 1U : 0U;
        });
        walk(line, 0, [&](glm::ivec2 at) {
            for (int y = -reach; y <= reach; ++y)
                for (int x = -reach; x <= reach; ++x)
                    if (const glm::ivec2 other = at + glm::ivec2(x, y); picture.contains(other))
                        near[picture.index(other)] = true;
        });
    }
    for (int y = 0; y < picture.size.y; ++y) {
        for (int x = 0; x < picture.size.x; ++x) {
            if (near[picture.index({x, y})]) continue;
            ++beside;
            stray += picture.is_dark({x, y}) ? 1U : 0U;
        }
    }
    const double drawn_share = static_cast<double>(drawn) / static_cast<double>(asked);
    const double stray_share = static_cast<double>(stray) / static_cast<double>(beside);
    std::cout << drawn_share << " of the visible lines are drawn (at least " << least_drawn << "), "
              << stray_share << " of the rest is dark (at most " << most_stray << ")\n";
    return asked > 1000 && drawn_share >= least_drawn && stray_share <= most_stray;
}

} // namespace
} // namespace lineatlas

int main(int argc, char** argv) {
    if (argc != 3) {
        std::cerr << "usage: check_lines PICTURE.ppm T\n";
        return 2;
    }
    try {
        const lineatlas::Picture picture = lineatlas::read_ppm(argv[1]);
        const auto lines = lineatlas::visible_lines(std::strtof(argv[2], nullptr), picture.size);
        return lineatlas::check(picture, lines) ? EXIT_SUCCESS : EXIT_FAILURE;
    } catch (const lineatlas::Error& error) {
        std::cerr << "check_lines: " << error.what() << '\n';
        return 2;
    }
}
