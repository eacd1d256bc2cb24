#include "sheet.hpp"

#include <algorithm>
#include <cmath>

#include "core/style_lengths.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

glm::dvec2 page_size(const Page& page, glm::dvec2 picture, Unit unit) {
    const glm::dvec2 size{length_in(page.width, unit), length_in(page.height, unit)};
    const bool on_its_side = page.turns && (picture.x > picture.y) != (size.x > size.y);
    return on_its_side ? glm::dvec2{size.y, size.x} : size;
}

} // namespace

Sheet lay_out(glm::ivec2 picture, const std::optional<Page>& page, Length margin, Unit units) {
    const glm::dvec2 pixels{picture};
    const double space = length_in(margin, units);
    if (!(space >= 0) || !std::isfinite(space))
        throw UsageError("the margin must be a length of at least 0");
    const double natural = length_in({1, Unit::px}, units);
    Sheet sheet{.size = pixels * natural + 2 * space, .scale = natural, .corner = {}, .digits = 0};
    if (page) {
        sheet.size = page_size(*page, pixels, units);
        const glm::dvec2 room = sheet.size - 2 * space;
        if (!std::isfinite(room.x) || !std::isfinite(room.y))
            throw UsageError("the page must have a width and a height");
        if (!(std::min(room.x, room.y) > 0)) {
            throw UsageError("the margin leaves no room on the page");
        }
        sheet.scale = std::min(room.x / pixels.x, room.y / pixels.y);
    }
    sheet.corner = 0.5 * (sheet.size - pixels * sheet.scale);
    constexpr double precision = 0.01; // pixels
    sheet.digits =
        static_cast<int>(std::clamp(std::ceil(-std::log10(precision * sheet.scale)), 0.0, 6.0));
    return sheet;
}

Style style_on_page(const Style& style, glm::ivec2 picture, const Page& page, Length margin) {
    const Sheet sheet = lay_out(picture, page, margin, Unit::px);
    Style result = style;
    if (style.made_for > 0) multiply_lengths(result, static_cast<float>(1 / sheet.scale));
    return result;
}

} // namespace lineatlas
