#include "chart.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace lineatlas::bench {
namespace {

// In units of the drawing; whole numbers, so that bars end on pixels.
constexpr float margin = 24;
constexpr float header = 64;
constexpr float footer = 54;
constexpr float label_column = 42;
constexpr float bar_column = 210;
constexpr float value_column = 56;
constexpr std::size_t longest_label = 5; // longer labels get a smaller font
constexpr float gap = 28;
constexpr float panel_width = label_column + bar_column + value_column;
constexpr float title_height = 42;
constexpr float bar_pitch = 20;
constexpr float bar_height = 14;
constexpr std::size_t most_columns = 3;

constexpr Rgb grey{110, 110, 110};
constexpr Rgb mark_color{0, 0, 0};

/// One hue per method, dark for its better quality.
Rgb bar_color(std::string_view method) {
    const bool high = method.find("hi") != method.npos;
    if (method.starts_with("IB")) return high ? Rgb{194, 110, 20} : Rgb{236, 178, 108};
    if (method.starts_with("ST")) return high ? Rgb{40, 110, 175} : Rgb{135, 184, 222};
    if (method.starts_with("SA")) return high ? Rgb{22, 128, 84} : Rgb{122, 196, 160};
    return {140, 140, 140};
}

std::string fps_text(double fps) {
    if (fps >= 99.95) return fmt::format("{:.0f}", fps);
    if (fps >= 9.995) return fmt::format("{:.1f}", fps);
    return fmt::format("{:.2f}", fps);
}

std::string grouped(std::uint32_t value) {
    if (value < 1000) return fmt::format("{}", value);
    return fmt::format("{} {:03}", grouped(value / 1000), value % 1000);
}

/// The frame rate that the paper's ratio to OGL predicts for a method on this machine; 0 if the
/// paper has no ratio or OGL was not measured.
double paper_mark(const Report& report, const SceneResult& scene, const Measured& measured) {
    const auto ratio = paper_to_opengl(scene.name, measured.name);
    const Measured* opengl = report.opengl_for(scene.name);
    if (!ratio || opengl == nullptr || measured.name == "OGL") return 0;
    return *ratio * opengl->fps();
}

void add_panel(const Report& report, const SceneResult& scene, glm::vec2 corner, Drawing& drawing) {
    drawing.labels.push_back({corner + glm::vec2{0, 14}, scene.name, 15, Anchor::start, true});
    drawing.labels.push_back({corner + glm::vec2{0, 31},
                              fmt::format("{} triangles, {} segments", grouped(scene.triangles),
                                          grouped(scene.segments)),
                              10, Anchor::start, false, grey});
    double largest = 0;
    for (const Measured& measured : scene.methods) {
        if (!measured.valid()) continue;
        largest = std::max({largest, measured.fps(), paper_mark(report, scene, measured)});
    }
    if (largest == 0) return;
    const auto length = [&](double fps) { return static_cast<float>(fps / largest) * bar_column; };
    const glm::vec2 origin = corner + glm::vec2{label_column, title_height};
    const auto rows = static_cast<float>(scene.methods.size());
    drawing.boxes.push_back({origin - glm::vec2{1, 2}, {1, rows * bar_pitch}, grey});
    glm::vec2 at = origin;
    for (const Measured& measured : scene.methods) {
        const float baseline = at.y + bar_height - 3;
        const float size = measured.name.size() > longest_label ? 8 : 11;
        drawing.labels.push_back({{at.x - 6, baseline}, measured.name, size, Anchor::end});
        const double fps = measured.valid() ? measured.fps() : 0;
        const double mark = measured.valid() ? paper_mark(report, scene, measured) : 0;
        if (fps > 0) {
            drawing.boxes.push_back({at, {length(fps), bar_height}, bar_color(measured.name)});
        }
        if (mark > 0) {
            const float x = std::round(at.x + length(mark));
            drawing.boxes.push_back({{x - 1, at.y - 2}, {2, bar_height + 4}, mark_color});
        }
        // The label stands beside the bar, or beyond the mark if the mark is in the way.
        const bool in_the_way = mark > fps && length(mark) < length(fps) + value_column;
        drawing.labels.push_back({{at.x + length(in_the_way ? mark : fps) + 6, baseline},
                                  fps > 0 ? fps_text(fps) : "failed",
                                  11});
        at.y += bar_pitch;
    }
}

} // namespace

Drawing chart(const Report& report) {
    std::vector<const SceneResult*> panels;
    std::size_t most_bars = 0;
    for (const SceneResult& scene : report.scenes) {
        if (!scene.is_of_table() || scene.methods.empty()) continue;
        panels.push_back(&scene);
        most_bars = std::max(most_bars, scene.methods.size());
    }
    const std::size_t columns = std::clamp<std::size_t>(panels.size(), 2, most_columns);
    const std::size_t rows = (panels.size() + columns - 1) / columns;
    const float panel_height = title_height + static_cast<float>(most_bars) * bar_pitch;

    Drawing drawing;
    drawing.size = {2 * margin + static_cast<float>(columns) * (panel_width + gap) - gap,
                    header + static_cast<float>(rows) * (panel_height + gap) + footer};
    drawing.labels.push_back(
        {{margin, 34}, "Frames per second, more is better", 18, Anchor::start, true});
    drawing.labels.push_back({{margin, 52},
                              fmt::format("{}x{}, median over the camera path; each panel has a "
                                          "scale of its own",
                                          report.size.x, report.size.y),
                              11,
                              Anchor::start,
                              false,
                              grey});
    bool any_mark = false;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const glm::vec2 place{static_cast<float>(i % columns), static_cast<float>(i / columns)};
        add_panel(
            report, *panels[i],
            {margin + place.x * (panel_width + gap), header + 8 + place.y * (panel_height + gap)},
            drawing);
        for (const Measured& measured : panels[i]->methods) {
            any_mark =
                any_mark || (measured.valid() && paper_mark(report, *panels[i], measured) > 0);
        }
    }
    float y = drawing.size.y - 44;
    if (any_mark) {
        drawing.boxes.push_back({{margin + 4, y - 11}, {2, 14}, mark_color});
        drawing.labels.push_back(
            {{margin + 14, y}, "OGL here times the paper's ratio of that method to OGL", 11});
    }
    for (const std::string& line : {report.device, report.gl}) {
        y += 15;
        drawing.labels.push_back({{margin, y}, line, 9, Anchor::start, false, grey});
    }
    return drawing;
}

} // namespace lineatlas::bench
