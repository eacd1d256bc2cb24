#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/section.hpp"

namespace lineatlas {
namespace {

[[noreturn]] void refuse(std::string_view text) {
    throw UsageError(fmt::format("section \"{}\" must be an axis and a position, as in z=0.3, "
                                 "-x=50%, or a point and a normal, as in 1,2,3/0,0,1",
                                 text));
}

std::optional<double> take_coordinate(std::string_view& text) {
    const std::optional<double> value = take_number(text);
    return value && std::abs(*value) <= 1e15 ? value : std::nullopt;
}

std::optional<glm::dvec3> parse_point(std::string_view text) {
    glm::dvec3 point{0};
    for (int axis = 0; axis < 3; ++axis) {
        const std::optional<double> value = take_coordinate(text);
        if (!value) return std::nullopt;
        point[axis] = *value;
        const bool comma = text.starts_with(',');
        if (comma != (axis < 2)) return std::nullopt;
        if (comma) text.remove_prefix(1);
    }
    return text.empty() ? std::optional{point} : std::nullopt;
}

} // namespace

SectionPlane parse_section(std::string_view text, const Bounds& bounds) {
    SectionPlane plane{.name = std::string{text}};
    if (const std::size_t slash = text.find('/'); slash != std::string_view::npos) {
        const auto point = parse_point(text.substr(0, slash));
        const auto normal = parse_point(text.substr(slash + 1));
        if (!point || !normal || *normal == glm::dvec3{0}) refuse(text);
        plane.point = *point;
        plane.normal = *normal;
        return plane;
    }
    std::string_view rest = text;
    plane.side_is_given = rest.starts_with('-') || rest.starts_with('+');
    const double side = rest.starts_with('-') ? -1 : 1;
    if (plane.side_is_given) rest.remove_prefix(1);
    if (rest.size() < 3 || rest[1] != '=') refuse(text);
    const std::size_t axis = std::string_view{"xyz"}.find(rest[0]);
    if (axis == std::string_view::npos) refuse(text);
    rest.remove_prefix(2);
    std::optional<double> at = take_coordinate(rest);
    if (!at || (rest != "" && rest != "%")) refuse(text);
    const auto i = static_cast<glm::length_t>(axis);
    if (rest == "%") {
        const auto low = static_cast<double>(bounds.min[i]);
        const auto high = static_cast<double>(bounds.max[i]);
        *at = low + *at / 100 * (high - low);
    }
    plane.normal = glm::dvec3{0};
    plane.normal[i] = side;
    plane.point[i] = *at;
    return plane;
}

} // namespace lineatlas
