#include "style_lengths.hpp"

namespace lineatlas {

void multiply_lengths(Style& style, float factor) {
    const auto multiply = [&](auto&... lengths) { ((lengths *= factor), ...); };
    multiply(style.pen.width, style.pen.cap_length, style.hidden_pen.width,
             style.hidden_pen.cap_length, style.centre_overhang);
    for_each_length(style.filter, multiply);
    style.density.limit /= factor; // as many lines in fewer pixels
    style.hidden_density /= factor;
    for (PenRule& rule : style.pens) {
        if (rule.width) *rule.width *= factor;
        if (rule.cap_length) *rule.cap_length *= factor;
    }
    style.made_for = 0;
}

Style about_origin(Style style, glm::dvec3 origin) {
    if (style.focus.in_scene) style.focus.point -= origin;
    return style;
}

} // namespace lineatlas
