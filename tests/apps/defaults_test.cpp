// The library's defaults are the tool's: a program that chooses nothing draws what `draw` draws.

#include <sstream>
#include <string>
#include <vector>

#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/io.hpp"
#include "lineatlas/renderer.hpp"
#include "lineatlas/scenes.hpp"
#include "lineatlas/style_files.hpp"
#include "lineatlas/vector.hpp"
#include "lineatlas/visibility.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

constexpr glm::ivec2 size{320, 240};

/// Lines of an SVG file that are paths, without what a program tells of itself.
std::vector<std::string> paths_of(const std::string& svg) {
    std::vector<std::string> paths;
    std::istringstream lines{svg};
    for (std::string line; std::getline(lines, line);)
        if (line.find("<path ") != line.npos || line.find("<g ") != line.npos)
            paths.push_back(line);
    return paths;
}

class Defaults : public Tool {
  protected:
    Scene scene_ = make_scene("clevis");
    LineSet lines_ = extract_lines(scene_.mesh);
    Camera camera_ = make_camera(scene_.view(0), size, lines_.bounds);
    std::string command_ = "draw --scene clevis --size 320x240 -o ";
};

TEST_F(Defaults, DrawThePictureOfTheTool) {
    ASSERT_EQ(run(command_ + path("a.png")).exit_code, 0);
    const gl::HeadlessContext context;
    gl::Canvas canvas{size};
    const auto draw = [&](const FrameOptions& options) {
        Renderer renderer;
        renderer.set_lines(lines_);
        canvas.clear({options.style.paper.color, 1});
        renderer.draw(camera_, options, canvas.framebuffer());
        return canvas.read();
    };
    Image picture = read_image(path("a.png"));
    ASSERT_EQ(picture.size, size);
    const std::vector<std::uint8_t> drawn = draw(default_frame_options());
    for (std::size_t pixel = 0; pixel < drawn.size() / 4; ++pixel)
        for (std::size_t channel = 0; channel < 3; ++channel)
            ASSERT_EQ(drawn[4 * pixel + channel],
                      picture.pixels[pixel * static_cast<std::size_t>(picture.channels) + channel])
                << pixel;
    EXPECT_NE(drawn, draw({})) << "the picture would be the same without";
}

TEST_F(Defaults, DrawThePathsOfTheTool) {
    ASSERT_EQ(run(command_ + path("a.svg")).exit_code, 0);
    LineVisibility visibility{lines_};
    const auto draw = [&](const Style& style) {
        const std::vector<Interval> found =
            visibility.find(camera_, {.hidden = true, .outlines = true});
        return paths_of(
            to_svg(make_vector_drawing(lines_, camera_, found, style,
                                       {.mesh = &scene_.mesh, .outlines = visibility.outlines()})));
    };
    const std::vector<std::string> tool = paths_of(read(path("a.svg")));
    EXPECT_GT(tool.size(), 40U);
    EXPECT_EQ(draw(default_style()), tool);
    EXPECT_NE(draw({}), tool) << "the paths would be the same without";
}

} // namespace
} // namespace lineatlas::test
