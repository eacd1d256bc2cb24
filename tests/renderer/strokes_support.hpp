// Small drawings with known answers (§4.5) by the whole renderer: with OpenCL and plain C++, and
// with the raster and the compute atlas. A unit is a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "glpasses/canvas.hpp"
#include "glpasses/headless_context.hpp"
#include "lineatlas/renderer.hpp"

namespace lineatlas::test::strokes {

using Runs = std::vector<Run>; // testing::Test has a Run of its own
using Polyline = std::vector<glm::vec3>;

inline constexpr int side = 400;
inline constexpr float front = 50; // depth of sheets that hide lines; the lines lie at 0

inline Camera pixel_camera(glm::vec2 shift = {0, 0}) {
    Camera camera;
    camera.size = {side, side};
    camera.view = glm::lookAt(glm::vec3{shift, 200}, glm::vec3{shift, 0}, glm::vec3{0, 1, 0});
    camera.projection = glm::ortho(0.0F, float{side}, 0.0F, float{side}, 1.0F, 401.0F);
    return camera;
}

struct Scene {
    Mesh mesh;
    std::vector<Polyline> lines{};

    /// Adds a line. It is a loop if its last point is its first.
    void line(const Polyline& points) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), points.begin(), points.end());
        std::vector<std::uint32_t> indices;
        for (std::uint32_t i = 0; i < points.size(); ++i) indices.push_back(first + i);
        mesh.polylines.push_back(indices);
        lines.push_back(points);
    }
    /// Adds a sheet that faces the eye. corners: in order around it.
    void sheet(const std::array<glm::vec2, 4>& corners, float z = front) {
        const auto a = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec2 corner : corners) mesh.positions.emplace_back(corner, z);
        mesh.triangles.emplace_back(a, a + 1, a + 2);
        mesh.triangles.emplace_back(a, a + 2, a + 3);
    }
    void box(glm::vec2 low, glm::vec2 high, float z = front) {
        sheet({low, {high.x, low.y}, high, {low.x, high.y}}, z);
    }
    /// Adds so many hidden segments in a corner that the renderer culls hidden segments.
    void crowd();
};

/// A line that is hidden from x = 150.3 to 250.6.
Scene behind_a_box();

/// A span of a polyline, pixels from its start.
struct Span {
    double from, to;
};

/// A circle as a loop of `count` segments.
Polyline circle(int count, float radius);

float length_of(const Polyline& line);

/// The drawn spans of a polyline, from the places of the runs alone. Touching pieces are one span.
std::vector<Span> drawn_of(const LineSet& set, const Runs& runs, const Polyline& line);

void expect_strokes(const std::vector<Span>& seen, const std::vector<Span>& expected,
                    double tolerance = 1);

struct Drawing {
    LineSet set;
    Runs runs;
    std::vector<std::uint8_t> pixels;

    std::vector<Span> of(const Polyline& line) const { return drawn_of(set, runs, line); }
    /// The darkness of a pixel from 0 (white) to 1 (black); y from the bottom.
    double darkness(int x, int y) const {
        const auto at = (static_cast<std::size_t>(side - 1 - y) * side + std::size_t(x)) * 4;
        return 1 - pixels[at] / 255.0;
    }
    double column(int x, int low, int high) const {
        double sum = 0;
        for (int y = low; y < high; ++y) sum += darkness(x, y);
        return sum;
    }
    double row(int y, int low, int high) const {
        double sum = 0;
        for (int x = low; x < high; ++x) sum += darkness(x, y);
        return sum;
    }
};

struct Setting {
    std::string name, compute;
    StageForm form;
};

class Strokes : public testing::TestWithParam<Setting> {
  protected:
    Drawing draw(const Scene& scene, FrameOptions options, const Camera& camera = pixel_camera());
    Drawing draw(const Scene& scene, const StrokeFilter& filter) {
        return draw(scene, FrameOptions{.style = {.filter = filter}});
    }

    gl::HeadlessContext context_;
    gl::Canvas canvas_{{side, side}};
    Renderer renderer_{{.compute = GetParam().compute}};
    float chain_angle_ = 3.1F;
};

} // namespace lineatlas::test::strokes
