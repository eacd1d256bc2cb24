#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "base/units.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/vector.hpp"
#include "page_name.hpp"

namespace lineatlas {
namespace {

struct NamedPage {
    std::string_view name;
    Page page;
};

constexpr Page sheet(double width, double height, Unit unit) {
    return {.width = {width, unit}, .height = {height, unit}, .turns = true};
}

constexpr std::array named_pages{
    NamedPage{"a0", sheet(841, 1189, Unit::mm)},  NamedPage{"a1", sheet(594, 841, Unit::mm)},
    NamedPage{"a2", sheet(420, 594, Unit::mm)},   NamedPage{"a3", sheet(297, 420, Unit::mm)},
    NamedPage{"a4", sheet(210, 297, Unit::mm)},   NamedPage{"a5", sheet(148, 210, Unit::mm)},
    NamedPage{"a6", sheet(105, 148, Unit::mm)},   NamedPage{"letter", sheet(8.5, 11, Unit::in)},
    NamedPage{"legal", sheet(8.5, 14, Unit::in)}, NamedPage{"tabloid", sheet(11, 17, Unit::in)},
};

constexpr double largest = 1e6;

/// Units stand in paper_units as in Unit.
double pixels_in(Unit unit) {
    return paper_units[static_cast<std::size_t>(unit)].pixels;
}

std::string lower(std::string_view text) {
    std::string result{text};
    std::ranges::transform(result, result.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return result;
}

std::optional<Unit> parse_small(std::string_view name) {
    const NamedUnit* found = unit_named(name);
    if (found == nullptr) return {};
    return static_cast<Unit>(found - paper_units.data());
}

std::string with_capital(std::string_view name) {
    std::string result{name};
    result.front() = static_cast<char>(result.front() - 'a' + 'A');
    return result;
}

[[noreturn]] void refuse_page(std::string_view text) {
    std::string known;
    for (const NamedPage& page : named_pages) known += std::string{page.name} + ", ";
    throw UsageError("unknown page \"" + std::string{text} + "\"; there is " + known +
                     "or width and height as in 300x200mm");
}

} // namespace

double length_in(Length length, Unit unit) {
    if (length.unit == unit) return length.value;
    return length.value * pixels_in(length.unit) / pixels_in(unit);
}

Unit parse_unit(std::string_view text) {
    const std::optional<Unit> unit = parse_small(lower(text));
    if (!unit) throw UsageError("unknown unit \"" + std::string{text} + "\"; must be px, mm or in");
    return *unit;
}

Length parse_length(std::string_view text, Unit unit) {
    const std::string word = lower(text);
    std::string_view rest = word;
    const std::optional<double> value = take_number(rest);
    const std::optional<Unit> own = rest.empty() ? unit : parse_small(rest);
    if (!value || !own || !(*value >= 0 && *value <= largest)) {
        throw UsageError("\"" + std::string{text} +
                         "\" is no length; must be a number from 0 on with px, mm or in, as in "
                         "10mm");
    }
    return {*value, *own};
}

Page parse_page(std::string_view text) {
    const std::string word = lower(text);
    for (const NamedPage& known : named_pages) {
        if (known.name == word) return known.page;
    }
    std::string_view rest = word;
    const std::optional<double> width = take_number(rest);
    if (!width || !rest.starts_with('x')) refuse_page(text);
    rest.remove_prefix(1);
    const std::optional<double> height = take_number(rest);
    const std::optional<Unit> unit = parse_small(rest);
    if (!height || !unit) refuse_page(text);
    const auto in_range = [](double value) { return value > 0 && value <= largest; };
    if (!in_range(*width) || !in_range(*height)) refuse_page(text);
    return {.width = {*width, *unit}, .height = {*height, *unit}};
}

std::string page_name(const Page& page) {
    const auto side = [](Length length) { return length_in(length, Unit::mm); };
    for (const NamedPage& known : named_pages)
        if (side(known.page.width) == side(page.width) &&
            side(known.page.height) == side(page.height))
            return with_capital(known.name);
    return fmt::format("{:.6g} x {:.6g} mm", side(page.width), side(page.height));
}

} // namespace lineatlas
