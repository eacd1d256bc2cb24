#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace lineatlas::bench {

using Rgb = glm::u8vec3;

struct Box {
    glm::vec2 corner, size; ///< upper left; in units of the drawing, y down
    Rgb color;
};

enum class Anchor { start, end };

struct Label {
    glm::vec2 at; ///< on the baseline
    std::string text;
    float size;
    Anchor anchor = Anchor::start;
    bool bold = false;
    Rgb color{32, 32, 32};
};

/// A line through points.
struct Curve {
    std::vector<glm::vec2> points;
    float width;
    Rgb color;
};

/// Boxes, curves above them and labels above those, on white: all that a chart needs.
struct Drawing {
    glm::vec2 size{0};
    std::vector<Box> boxes;
    std::vector<Curve> curves;
    std::vector<Label> labels;
};

/// Writes an SVG or a PNG (2 pixels per unit), by extension. Throws FileError, and DeviceError
/// where the font for a PNG is missing.
void write_drawing(const std::filesystem::path& path, const Drawing& drawing);

/// Throws what `write_drawing` would; called before long work, so that it is not lost. UsageError
/// for another extension.
void check_drawing_path(const std::filesystem::path& path);

} // namespace lineatlas::bench
