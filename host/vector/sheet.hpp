#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// The place of the picture on its page, in the page's units.
struct Sheet {
    glm::dvec2 size;   ///< of the page
    double scale;      ///< units per pixel of the picture
    glm::dvec2 corner; ///< where the picture's upper left corner lies
    int digits;        ///< after the point, for a hundredth of a pixel

    glm::dvec2 place(glm::dvec2 pixels) const { return corner + pixels * scale; }
};

/// Places a picture on its page. `page`: none: the page is the picture and the margin. Throws
/// UsageError if the margin leaves no room.
Sheet lay_out(glm::ivec2 picture, const std::optional<Page>& page, Length margin, Unit units);

inline Sheet lay_out(glm::ivec2 picture, const SvgOptions& options) {
    return lay_out(picture, options.page, options.margin, options.units);
}

} // namespace lineatlas
