#include "pens.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

constexpr std::array names{
    PenName{"solid", "even and crisp"},
    PenName{"fine", "a fine nib, its ink slightly uneven"},
    PenName{"pencil", "graphite on paper grain"},
    PenName{"charcoal", "a soft stick that catches on the paper's tooth"},
    PenName{"brush", "bristles that leave streaks as they run dry"},
    PenName{"dashed", "dashes of twelve widths, gaps of three (ISO 128-2)"},
    PenName{"dotted", "round dots, a width and a half between them"},
    PenName{"chain", "dashes of 24 widths with dots between, gaps of three (ISO 128-2)"},
};

std::uint32_t hash(std::uint32_t x, std::uint32_t y) {
    std::uint32_t h = x * 0x9E3779B1U ^ y * 0x85EBCA77U;
    h ^= h >> 15U;
    h *= 0x2C1B3C6DU;
    h ^= h >> 12U;
    h *= 0x297A2D39U;
    return h ^ h >> 15U;
}

float random_unit(int x, int y) {
    return static_cast<float>(hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))) /
           4294967296.0F;
}

/// Smooth noise in [0, 1) with features of size 1, repeating after `period` along x.
float value_noise(float x, float y, int period) {
    const float fx = std::floor(x);
    const float fy = std::floor(y);
    const auto smooth = [](float t) { return t * t * (3 - 2 * t); };
    const float tx = smooth(x - fx);
    const float ty = smooth(y - fy);
    const auto at = [&](int dx, int dy) {
        const int column = (static_cast<int>(fx) + dx) % period;
        return random_unit(column < 0 ? column + period : column, static_cast<int>(fy) + dy);
    };
    return std::lerp(std::lerp(at(0, 0), at(1, 0), tx), std::lerp(at(0, 1), at(1, 1), tx), ty);
}

/// Uneven marks repeat after this many pixels; most lines of a drawing are shorter.
constexpr int repeat = 1024;

/// Noise of two octaves whose larger features are `along` by `across` pixels; `y` in pixels.
float grain(float x, float y, float along, float across, int seed) {
    const auto octave = [&](float share, int octave_seed) {
        const int cells = std::max(1, static_cast<int>(std::lround(repeat / (along * share))));
        return value_noise(x * static_cast<float>(cells) / repeat,
                           y / (across * share) + static_cast<float>(octave_seed), cells);
    };
    return (2 * octave(1, seed) + octave(0.5F, seed + 500)) / 3;
}

/// Noise along the stroke alone, for edges that wander and pressure that varies.
float wander(float x, float along, int seed) {
    return grain(x, 0, along, 1, seed);
}

float ramp(float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
    return t * t * (3 - 2 * t);
}

/// A mark of `columns` filled by coverage(x, y): pixels along the stroke, and across it from the
/// spine. One texel per pixel; more for thin strokes, whose shape would be lost.
template <class Coverage>
PenMark paint(int columns, float repeat_length, float width, Coverage&& coverage) {
    const int rows = std::clamp(static_cast<int>(std::ceil(width)), 8, 256);
    PenMark mark{.size = {columns, rows}, .coverage = {}, .repeat_length = repeat_length};
    mark.coverage.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    const float column_length = repeat_length / static_cast<float>(columns);
    for (int row = 0; row < rows; ++row) {
        const float y =
            ((static_cast<float>(row) + 0.5F) / static_cast<float>(rows) - 0.5F) * width;
        for (int column = 0; column < columns; ++column) {
            const float x = (static_cast<float>(column) + 0.5F) * column_length;
            const float c = std::clamp(coverage(x, y), 0.0F, 1.0F);
            mark.coverage.push_back(static_cast<std::uint8_t>(std::lround(255 * c)));
        }
    }
    return mark;
}

/// How far a point lies inside an edge that wanders between `narrowest` of the half-width and all
/// of it, in pixels; each side has its own edge.
float depth_inside(float x, float y, float width, float narrowest, float along, int seed) {
    const float edge = wander(x, along, y < 0 ? seed : seed + 40);
    return 0.5F * width * (narrowest + (1 - narrowest) * edge) - std::abs(y);
}

/// Ink from a nib. It is black, but the paper soaks it up unevenly.
float fine(float x, float y, float width) {
    const float bleed = std::min(0.28F, 0.9F / width + 0.06F);
    const float inside = depth_inside(x, y, width, 1 - bleed, 11, 1);
    const float flow = 0.9F + 0.25F * wander(x, 90, 7);
    return std::min(1.0F, flow) * (0.5F + inside);
}

/// Graphite. It greys the high places of the paper and leaves the pits white; its pressure varies.
float pencil(float x, float y, float width) {
    const float half = 0.5F * width;
    const float inside = depth_inside(x, y, width, 0.8F, 9, 3);
    const float pressure = 0.68F + 0.6F * (wander(x, 70, 9) - 0.5F);
    const float core = ramp(-0.9F, std::max(0.7F, 0.75F * half), inside);
    const float tooth = grain(x, y, 1.6F, 1.6F, 11);
    const float deposit = 0.3F + 0.7F * ramp(0.5F, -0.08F, tooth - 0.5F * pressure);
    return core * deposit * std::min(0.9F, 0.56F + 0.5F * pressure);
}

/// Charcoal: black on the tooth of rough paper, dust in its pits, crumbling at the edges.
float charcoal(float x, float y, float width) {
    const float half = 0.5F * width;
    const float inside = depth_inside(x, y, width, 0.6F, 8, 13);
    // The stick leans to one side, and is pressed less here and there.
    const float pressure = 0.66F + 0.14F * y / half + 0.3F * (wander(x, 60, 15) - 0.5F) +
                           0.35F * (grain(x, y, 30, 10, 19) - 0.5F);
    const float core = ramp(-0.35F * half - 0.6F, 0.5F * half + 0.2F, inside);
    const float tooth = 0.65F * grain(x, y, 3.2F, 2.6F, 17) + 0.35F * grain(x, y, 1.5F, 1.5F, 21);
    const float deposit = ramp(-0.2F, 0.26F, pressure * core - 0.85F * tooth + 0.03F);
    const float dust = 0.3F * core * pressure;
    return std::min(0.95F, dust + (1 - dust) * deposit);
}

/// A brush. Each bristle carries its own ink and runs dry for a while, near the edges first.
float brush(float x, float y, float width) {
    const float half = 0.5F * width;
    const float inside = depth_inside(x, y, width, 0.66F, 48, 23);
    const float bristle = std::max(1.2F, width / 12);
    const float load = grain(x, y, 130, bristle, 25);
    const float ink =
        0.67F + 0.6F * (wander(x, 200, 27) - 0.5F) - 0.36F * std::pow(std::abs(y) / half, 2.0F);
    const float frayed = 0.16F * (grain(x, y, 6, bristle, 29) - 0.5F);
    const float wet = ramp(-0.07F, 0.08F, ink + frayed - load);
    // A very thin stroke does not split into bristles.
    return (0.5F + inside) * std::lerp(1.0F, wet, std::clamp(width / 6, 0.3F, 1.0F));
}

/// Paints one dash in the middle of the period. If the mark has dots, it paints a dot there, and
/// half a dash at either end: the middle of a path lies between two periods, and where centre lines
/// cross there is a dash (ISO 128-2).
PenMark paint_dashes(const DashLengths& dashes, float width) {
    const float unit = std::max(1.0F, width);
    const float period = dashes.dash + dashes.gap + (dashes.dot > 0 ? dashes.dot + dashes.gap : 0);
    const int unit_columns = std::clamp(static_cast<int>(std::ceil(width)), 8, 256);
    constexpr float rounding = 0.25F; // columns
    const int columns =
        static_cast<int>(period / unit * static_cast<float>(unit_columns) + rounding);
    return paint(columns, period, width, [&](float x, float y) {
        const float from_middle = std::abs(x - 0.5F * period);
        if (dashes.dot > 0)
            return 0.5F + std::max(0.5F * dashes.dot - from_middle,
                                   from_middle - 0.5F * (period - dashes.dash));
        if (!dashes.round) return 0.5F + 0.5F * dashes.dash - from_middle;
        return 0.5F + 0.5F * unit - std::hypot(std::max(0.0F, from_middle - 0.5F * dashes.dash), y);
    });
}

} // namespace

std::span<const PenName> pen_names() {
    return names;
}

std::optional<DashLengths> dash_lengths(std::string_view name, float width) {
    const float unit = std::max(1.0F, width);
    if (name == "dashed") return DashLengths{.dash = 12 * unit, .gap = 3 * unit, .round = false};
    if (name == "dotted") return DashLengths{.dash = 0, .gap = 2.5F * unit, .round = true};
    if (name == "chain")
        return DashLengths{.dash = 24 * unit, .gap = 3 * unit, .round = false, .dot = 0.5F * unit};
    return {};
}

PenMark make_pen(std::string_view name, float width) {
    const auto uneven = [width](auto&& mark) {
        return paint(repeat, repeat, width, [&](float x, float y) { return mark(x, y, width); });
    };
    if (name == "solid") return {};
    if (name == "fine") return uneven(fine);
    if (name == "pencil") return uneven(pencil);
    if (name == "charcoal") return uneven(charcoal);
    if (name == "brush") return uneven(brush);
    // Regular marks grow with the width, so that the pattern keeps its look; below a width of 1 it
    // would close up.
    if (const std::optional<DashLengths> dashes = dash_lengths(name, width)) {
        return paint_dashes(*dashes, width);
    }
    if (is_pen_file(name)) {
        throw UsageError("the picture of the pen \"" + std::string{name} +
                         "\" has not been handed over");
    }
    std::string known;
    for (const PenName& pen : names) known += std::string{pen.name} + ", ";
    throw UsageError("unknown pen \"" + std::string{name} + "\"; there is " + known +
                     "or an image file");
}

PenMark pen_from_image(const Image& image, float width) {
    if (image.size.x < 1 || image.size.y < 1 || image.channels < 1 || image.channels > 4) {
        throw UsageError("a pen's picture has no pixels");
    }
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t count = image.pixels.size() / channels;
    const bool has_alpha = channels % 2 == 0;
    bool transparent = false;
    for (std::size_t i = 0; has_alpha && i < count; ++i) {
        transparent = transparent || image.pixels[(i + 1) * channels - 1] < 255;
    }
    const auto coverage = [&](std::size_t pixel) -> std::uint8_t {
        const std::uint8_t* p = &image.pixels[pixel * channels];
        if (transparent) return p[channels - 1];
        if (channels < 3) return static_cast<std::uint8_t>(255 - p[0]);
        return static_cast<std::uint8_t>(255 - (54 * p[0] + 183 * p[1] + 19 * p[2]) / 256);
    };
    PenMark mark{.size = image.size, .coverage = {}, .repeat_length = 1};
    mark.repeat_length =
        width * static_cast<float>(image.size.x) / static_cast<float>(image.size.y);
    mark.coverage.reserve(count);
    const auto columns = static_cast<std::size_t>(image.size.x);
    for (std::size_t row = static_cast<std::size_t>(image.size.y); row-- > 0;) {
        for (std::size_t x = 0; x < columns; ++x) {
            mark.coverage.push_back(coverage(row * columns + x));
        }
    }
    return mark;
}

Image image_of_pen(const PenMark& mark) {
    if (mark.size.x == 0)
        return {.size = {8, 8}, .channels = 1, .pixels = std::vector<std::uint8_t>(64)};
    Image image{.size = mark.size, .channels = 1, .pixels = {}};
    image.pixels.reserve(mark.coverage.size());
    const auto columns = static_cast<std::size_t>(mark.size.x);
    for (std::size_t row = static_cast<std::size_t>(mark.size.y); row-- > 0;) {
        for (std::size_t x = 0; x < columns; ++x) {
            image.pixels.push_back(
                static_cast<std::uint8_t>(255 - mark.coverage[row * columns + x]));
        }
    }
    return image;
}

} // namespace lineatlas
