#include "dxf_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "outline.hpp"

namespace lineatlas {
namespace {

/// ISO 128-20, hundredths of a millimetre.
constexpr std::array line_weights{13, 18, 25, 35, 50, 70, 100, 140, 200};

constexpr double usual_width = 0.25; ///< millimetres, of a layer whose entities say their own

/// A colour of AutoCAD's index: 10 to 249 are 24 hues, each in five lightnesses, full and half.
glm::dvec3 indexed_color(int index) {
    constexpr std::array<glm::dvec3, 9> first{{{0, 0, 0},
                                               {1, 0, 0},
                                               {1, 1, 0},
                                               {0, 1, 0},
                                               {0, 1, 1},
                                               {0, 0, 1},
                                               {1, 0, 1},
                                               {0, 0, 0}, // black on white paper
                                               {0.5, 0.5, 0.5}}};
    constexpr std::array greys{0.2, 0.31, 0.41, 0.51, 0.75, 1.0};
    constexpr std::array lightness{1.0, 0.65, 0.5, 0.3, 0.15};
    if (index < 9) return first[static_cast<std::size_t>(index)];
    if (index == 9) return glm::dvec3{0.75};
    if (index >= 250) return glm::dvec3{greys[static_cast<std::size_t>(index - 250)]};
    const double hue = (index - 10) / 10 * 0.25; // sixths of the circle
    const auto channel = [&](double offset) {
        return glm::clamp(std::abs(std::fmod(hue + offset, 6.0) - 3) - 1, 0.0, 1.0);
    };
    glm::dvec3 color{channel(0), channel(4), channel(2)};
    if (index % 2 == 1) color = 0.5 * color + 0.5;
    return color * lightness[static_cast<std::size_t>(index % 10 / 2)];
}

/// The scales of a sheet's views differ by rounding.
bool is_same_length(double a, double b) {
    return std::abs(a - b) <= 1e-6 * a;
}

/// "DASHED" for the first pattern; "CENTER" of those with dots, as other programs call them.
const std::string& linetype_of(const std::vector<double>& dashes, std::vector<DxfLinetype>& known) {
    for (const DxfLinetype& type : known)
        if (std::ranges::equal(type.dashes, dashes, is_same_length)) return type.name;
    const std::string number = known.empty() ? "" : std::to_string(known.size() + 1);
    known.push_back({(dashes.size() > 2 ? "CENTER" : "DASHED") + number, dashes});
    return known.back().name;
}

} // namespace

int nearest_index(glm::vec3 color) {
    const double brightest = static_cast<double>(std::max({color.x, color.y, color.z}));
    if (brightest < 0.1) return 7; // black on white paper, white on black: what one can see
    int nearest = 7;
    for (int index = 1; index < 256; ++index) {
        const auto far = [&](int i) { return glm::distance(indexed_color(i), glm::dvec3{color}); };
        if (far(index) < far(nearest) - 1e-6) nearest = index;
    }
    return nearest;
}

int whole_color(glm::vec3 color) {
    const glm::ivec3 bytes{glm::round(255.0F * glm::clamp(color, 0.0F, 1.0F))};
    return bytes.x << 16 | bytes.y << 8 | bytes.z;
}

int nearest_weight(double millimetres) {
    return *std::ranges::min_element(line_weights, {}, [&](int weight) {
        return std::abs(std::log(weight / (100 * millimetres)));
    });
}

DxfLayer own_layer(const std::string& name, const Pen& pen) {
    return {.name = name,
            .linetype = "CONTINUOUS",
            .color_index = nearest_index(pen.color),
            .color = whole_color(pen.color),
            .line_weight = nearest_weight(usual_width)};
}

void add_fill_layer(DxfLayers& to, const VectorDrawing& drawing, const std::string& prefix) {
    if (!drawing.fills.empty())
        to.layers.push_back(own_layer(prefix + fill_layer, drawing.style.pen));
}

void add_layers(DxfLayers& found, std::span<const LineGroup> groups, const Sheet& sheet,
                const std::string& prefix) {
    for (const LineGroup& group : groups) {
        const PenStroke stroke = pen_stroke(group.pen, sheet);
        found.layers.push_back({.name = prefix + group.name(),
                                .linetype = stroke.dashes.empty()
                                                ? "CONTINUOUS"
                                                : linetype_of(stroke.dashes, found.linetypes),
                                .color_index = nearest_index(stroke.color),
                                .color = whole_color(stroke.color),
                                .line_weight = nearest_weight(stroke.width),
                                .shown = !group.thinned});
    }
}

} // namespace lineatlas
