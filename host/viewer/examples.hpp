#pragma once

#include <array>
#include <span>
#include <string_view>

namespace lineatlas::viewer {

/// A built-in scene that one can look at without a file.
struct Example {
    std::string_view scene; ///< name for make_scene()
    const char* label;      ///< for people
    const char* what;
};

/// The most beautiful one first.
inline std::span<const Example> all_examples() {
    static constexpr std::array<Example, 4> examples{
        {{"ship", "Ship", "A ship with its rigging: many fine lines"},
         {"house", "House", "A house with furniture"},
         {"office", "Office", "A room full of desks, seen from within"},
         {"clevis", "Clevis", "A small machine part of two pieces"}}};
    return examples;
}

} // namespace lineatlas::viewer
