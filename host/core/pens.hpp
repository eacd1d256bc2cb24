#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/image.hpp"

namespace lineatlas {

/// A pen's mark: coverage from 0 to 255, rows across the stroke from its right side to its left,
/// columns along it; repeats along.
struct PenMark {
    glm::ivec2 size{0, 0}; ///< 0: a solid mark
    std::vector<std::uint8_t> coverage;
    float repeat_length = 1; ///< pixels on the screen that one repeat covers
};

/// A built-in mark, for lists and help.
struct PenName {
    std::string_view name;
    std::string_view description;
};
std::span<const PenName> pen_names();

/// The mark of a built-in pen for strokes of `width` pixels, the same every time. The size of the
/// grain on the screen does not depend on the width. Throws UsageError for an unknown name.
PenMark make_pen(std::string_view name, float width);

/// What a mark of dashes or dots consists of, in pixels along the stroke.
struct DashLengths {
    float dash, gap; ///< a round dash reaches beyond both of its ends by half the stroke's width
    bool round;
    float dot = 0; ///< above 0: a short dash between two gaps
};

/// The lengths of a built-in mark that is dashed; nothing for every other name.
std::optional<DashLengths> dash_lengths(std::string_view name, float width);

/// True if a mark's name is that of an image file, because it holds a '/' or a '.'. The caller
/// reads it and makes a mark with `pen_from_image`.
inline bool is_pen_file(std::string_view name) {
    return name.find_first_of("./") != std::string_view::npos;
}

/// A mark from a picture, as a stroke from left to right looks; one repeat keeps its proportions.
/// Coverage is the alpha channel, or darkness if there is none or it is opaque all over.
/// Throws UsageError for an empty picture.
PenMark pen_from_image(const Image& image, float width);

/// The picture `pen_from_image` makes `mark` of: grey, dark where the mark covers.
Image image_of_pen(const PenMark& mark);

} // namespace lineatlas
