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
    /// LineOptions::silhouettes; none: as in the tool.
    std::optional<Silhouettes> silhouettes{};

    bool operator==(const Shown&) const = default;
};

/// The word for it in options.
inline std::string word_of(Silhouettes silhouettes) {
    return std::string{silhouettes_names.at(static_cast<std::size_t>(silhouettes))};
}

/// The choices of Shown in words, which stay valid when numbers of parts change.
struct ShownInWords {
    struct Plane {
        std::string text; ///< as in `lineatlas draw --section`
        bool on = true;
    };
    std::vector<std::string> hidden{}; ///< as in --hide
    std::vector<std::string> only{};   ///< as in --only
    std::vector<Plane> cuts{};
    std::optional<float> crease{};
    std::optional<Silhouettes> silhouettes{};
};

} // namespace lineatlas::viewer
