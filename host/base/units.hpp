#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace lineatlas {

/// A unit of length on paper, with its length in CSS pixels, 96 to an inch.
struct NamedUnit {
    std::string_view name;
    double pixels;
};
inline constexpr std::array paper_units{NamedUnit{"px", 1}, NamedUnit{"mm", 96 / 25.4},
                                        NamedUnit{"in", 96}};

/// The unit with this name, which is in small letters; null if there is none.
constexpr const NamedUnit* unit_named(std::string_view name) {
    for (const NamedUnit& unit : paper_units)
        if (unit.name == name) return &unit;
    return nullptr;
}

} // namespace lineatlas
