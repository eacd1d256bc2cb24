#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cuts.hpp"
#include "lineatlas/lines.hpp"
#include "parts.hpp"

namespace lineatlas::viewer {

/// Which parts of a model are shown, and which of its edges are lines. If these change, lines are
/// found anew.
struct Shown {
    ShownParts parts{};
    std::vector<Cut> cuts{};       ///< at most `most_sections`
    std::optional<float> crease{}; ///< LineOptions::crease in degrees
    /// LineOptions::silhouettes; none: as the tool has them.
    std::optional<Silhouettes> silhouettes{};

    bool operator==(const Shown&) const = default;
};

/// As options have it.
inline std::string word_of(Silhouettes silhouettes) {
    return std::string{silhouettes_names.at(static_cast<std::size_t>(silhouettes))};
}

/// The same in words, which outlive the numbers of parts.
struct ShownInWords {
    struct Plane {
        std::string text; ///< as `lineatlas draw --section` has it
        bool on = true;
    };
    std::vector<std::string> hidden{}; ///< as --hide has them
    std::vector<std::string> only{};   ///< as --only has them
    std::vector<Plane> cuts{};
    std::optional<float> crease{};
    std::optional<Silhouettes> silhouettes{};
};

} // namespace lineatlas::viewer
