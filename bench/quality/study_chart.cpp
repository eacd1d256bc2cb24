#include "study_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

namespace lineatlas::bench {
namespace {

// In units of the drawing.
constexpr float margin = 24;
constexpr float header = 78;
constexpr float axis_column = 48;
constexpr float plot_width = 230;
constexpr float plot_height = 110;
constexpr float row_pitch = plot_height + 62;
constexpr float column_pitch = axis_column + plot_width + 34;

constexpr Rgb grey{110, 110, 110};
constexpr Rgb light{225, 225, 225};
// One colour per depth scale, lighter for a coarser depth buffer.
constexpr std::array<Rgb, 4> colors{Rgb{158, 202, 225}, Rgb{66, 146, 198}, Rgb{8, 81, 156},
                                    Rgb{5, 30, 70}};

struct Quantity {
    const char* title;
    double (*value)(const StudyPoint&);
};

constexpr std::array<Quantity, 3> quantities{{
    {"mean error", [](const StudyPoint& p) { return p.errors.mean_error(); }},
    {"wrong samples, %",
     [](const StudyPoint& p) { return 100 * p.errors.share(p.errors.wrong()); }},
    {"sparkle", [](const StudyPoint& p) { return p.motion.sparkle().value_or(0); }},
}};

/// The end of an axis, chosen so that its half is a round number.
double axis_end(double largest) {
    if (!(largest > 0)) return 1;
    const double power = std::pow(10, std::floor(std::log10(largest)));
    for (const double factor : {1.0, 2.0, 3.0, 4.0, 6.0}) {
        if (largest <= factor * power) return factor * power;
    }
    return 10 * power;
}

void add_panel(const StudyReport& study, const Quantity& quantity, glm::vec2 corner,
               Drawing& drawing) {
    drawing.labels.push_back({corner + glm::vec2{0, -8},
                              fmt::format("{}: {}", study.name, quantity.title), 12, Anchor::start,
                              true});
    double largest = 0;
    for (const StudyPoint& point : study.points) {
        largest = std::max(largest, quantity.value(point));
    }
    const double end = axis_end(largest);
    const glm::vec2 origin = corner + glm::vec2{axis_column, plot_height};
    for (int i = 0; i <= 2; ++i) {
        const float y = origin.y - plot_height * static_cast<float>(i) / 2;
        drawing.boxes.push_back({{origin.x, y}, {plot_width, 1}, i == 0 ? grey : light});
        drawing.labels.push_back(
            {{origin.x - 6, y + 4}, fmt::format("{:g}", end * i / 2), 10, Anchor::end});
    }
    // The axis has even steps of probes per axis of the sample's box.
    const auto place = [&](const StudyPoint& point) {
        const double axis = std::sqrt(point.probes);
        const double x = (axis - 0.5) / 4;
        const double y = quantity.value(point) / end;
        return origin + glm::vec2{x * plot_width, -y * plot_height};
    };
    for (std::size_t scale = 1; scale <= colors.size(); ++scale) {
        Curve curve{{}, 2, colors[scale - 1]};
        for (const StudyPoint& point : study.points) {
            if (static_cast<std::size_t>(point.depth_scale) != scale) continue;
            curve.points.push_back(place(point));
            drawing.boxes.push_back(
                {curve.points.back() - glm::vec2{3}, glm::vec2{6}, colors[scale - 1]});
            if (scale > 1) continue;
            drawing.labels.push_back(
                {{curve.points.back().x - 5, origin.y + 15}, fmt::format("{}", point.probes), 10});
        }
        drawing.curves.push_back(curve);
    }
    drawing.labels.push_back(
        {{origin.x, origin.y + 29}, "probes per sample", 10, Anchor::start, false, grey});
}

} // namespace

Drawing study_chart(const std::vector<StudyReport>& study) {
    Drawing drawing;
    drawing.size = {2 * margin + static_cast<float>(quantities.size()) * column_pitch - 34,
                    header + row_pitch * static_cast<float>(study.size())};
    drawing.labels.push_back({{margin, 32},
                              "Segment atlas: what probes and depth scale are worth",
                              17,
                              Anchor::start,
                              true});
    glm::vec2 at{margin, 52};
    for (std::size_t scale = 1; scale <= colors.size(); ++scale) {
        drawing.boxes.push_back({at + glm::vec2{0, -5}, {18, 3}, colors[scale - 1]});
        drawing.labels.push_back({at + glm::vec2{24, 0}, fmt::format("depth {}x", scale), 11});
        at.x += 96;
    }
    for (std::size_t row = 0; row < study.size(); ++row) {
        for (std::size_t column = 0; column < quantities.size(); ++column) {
            const glm::vec2 corner{margin + static_cast<float>(column) * column_pitch,
                                   header + 12 + static_cast<float>(row) * row_pitch};
            add_panel(study[row], quantities[column], corner, drawing);
        }
    }
    return drawing;
}

} // namespace lineatlas::bench
