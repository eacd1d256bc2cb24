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

/// A chart on white: boxes, curves in front of the boxes, and labels in front of both.
struct Drawing {
    glm::vec2 size{0};
    std::vector<Box> boxes;
    std::vector<Curve> curves;
    std::vector<Label> labels;
};

/// Writes an SVG or a PNG (2 pixels per unit), by the extension of `path`. Throws FileError, and
/// DeviceError if the font for a PNG is missing.
void write_drawing(const std::filesystem::path& path, const Drawing& drawing);

/// Throws what write_drawing() would throw, and UsageError for another extension. Call it before
/// long work, so that a bad path does not cost the results.
void check_drawing_path(const std::filesystem::path& path);

} // namespace lineatlas::bench
