#include "strokes_support.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace lineatlas::test::strokes {

void Scene::crowd() {
    box({2, 2}, {40, 40});
    Polyline points;
    for (int y = 0; y < 105; ++y) {
        for (int x = 0; x < 105; ++x) {
            const int turned = y % 2 == 0 ? x : 104 - x;
            points.emplace_back(8 + 0.25F * static_cast<float>(turned),
                                8 + 0.25F * static_cast<float>(y), 0);
        }
    }
    line(points);
}

Scene behind_a_box() {
    Scene scene;
    scene.line({{60.2F, 200.4F, 0}, {340.7F, 200.4F, 0}});
    scene.box({150.3F, 100}, {250.6F, 300});
    return scene;
}

Polyline circle(int count, float radius) {
    Polyline points;
    for (int i = 0; i < count; ++i) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / count;
        points.emplace_back(200.3F + radius * std::cos(angle), 200.1F + radius * std::sin(angle),
                            0);
    }
    points.push_back(points.front());
    return points;
}

float length_of(const Polyline& line) {
    float length = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) length += glm::distance(line[i], line[i + 1]);
    return length;
}

std::vector<Span> drawn_of(const LineSet& set, const Runs& runs, const Polyline& line) {
    std::vector<Span> pieces;
    for (const Run& run : runs) {
        const glm::vec3 p = set.vertices[set.segments[run.segment].p];
        const glm::vec3 q = set.vertices[set.segments[run.segment].q];
        float arc = 0;
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const bool same = p == line[i] && q == line[i + 1];
            if (same || (q == line[i] && p == line[i + 1])) {
                const glm::vec2 along = glm::normalize(glm::vec2{line[i + 1] - line[i]});
                const glm::vec2 from = glm::vec2{run.start[0], run.start[1]} - glm::vec2{line[i]};
                const glm::vec2 to = glm::vec2{run.end[0], run.end[1]} - glm::vec2{line[i]};
                EXPECT_NEAR(along.x * from.y - along.y * from.x, 0, 0.1);
                const double a = arc + glm::dot(from, along), b = arc + glm::dot(to, along);
                pieces.push_back({std::min(a, b), std::max(a, b)});
            }
            arc += glm::distance(line[i], line[i + 1]);
        }
    }
    std::ranges::sort(pieces, {}, &Span::from);
    std::vector<Span> strokes;
    for (const Span& piece : pieces) {
        if (!strokes.empty() && piece.from - strokes.back().to < 0.1)
            strokes.back().to = std::max(strokes.back().to, piece.to);
        else
            strokes.push_back(piece);
    }
    // The first and the last piece of a loop may be one piece.
    if (line.front() == line.back() && strokes.size() > 1 && strokes.front().from < 0.1 &&
        strokes.back().to > length_of(line) - 0.1) {
        strokes.back().to += strokes.front().to;
        strokes.erase(strokes.begin());
    }
    return strokes;
}

void expect_strokes(const std::vector<Span>& seen, const std::vector<Span>& expected,
                    double tolerance) {
    std::string all;
    for (const Span& s : seen) {
        all.append(" ").append(std::to_string(s.from)).append("..").append(std::to_string(s.to));
    }
    ASSERT_EQ(seen.size(), expected.size()) << all;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        EXPECT_NEAR(seen[i].from, expected[i].from, tolerance) << all;
        EXPECT_NEAR(seen[i].to, expected[i].to, tolerance) << all;
    }
}

Drawing Strokes::draw(const Scene& scene, FrameOptions options, const Camera& camera) {
    // Paths go on around every turn.
    Drawing drawing{extract_lines(scene.mesh, {.chain_angle = chain_angle_}), {}, {}};
    renderer_.set_lines(drawing.set);
    canvas_.clear(glm::vec4{1});
    options.forms.atlas = GetParam().form;
    if (!options.lines) options.lines = mask_of(LineKind::file);
    renderer_.draw(camera, options, canvas_.framebuffer());
    drawing.runs = renderer_.read_samples().runs;
    drawing.pixels = canvas_.read();
    for (const lineatlas::Run& run : drawing.runs) EXPECT_LE(run.start_arc, run.end_arc);
    return drawing;
}

INSTANTIATE_TEST_SUITE_P(All, Strokes,
                         testing::Values(Setting{"OpenclRaster", "opencl", StageForm::raster},
                                         Setting{"OpenclCompute", "opencl", StageForm::compute},
                                         Setting{"CppRaster", "cpp", StageForm::raster},
                                         Setting{"CppCompute", "cpp", StageForm::compute}),
                         [](const auto& info) { return info.param.name; });

} // namespace lineatlas::test::strokes
