#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawn_lines.hpp"
#include "joints.hpp"

namespace lineatlas {

/// The result of checking a drawing by rays.
struct Certificate {
    DrawingErrors wide;                   ///< within 1.5 pixels
    DrawingErrors narrow;                 ///< within 0.5 pixels
    std::optional<StrictErrors> strict{}; ///< of a drawing with tags
    std::size_t paths = 0;                ///< visible ones
    std::vector<Gap> gaps{};              ///< gaps_of()
};

/// The certificate of all drawn lines, without StrictErrors.
Certificate compare_lines(const EdgeTruth& truth, const DrawnLines& drawn);

/// A certificate as one line, for a file's metadata.
std::string certificate_line(const Certificate& certificate);

/// A certificate as a table, with the worst places: at most `places` of each kind, by the pixels of
/// line that are wrong there.
std::string certificate_table(const Certificate& certificate, std::size_t places);

} // namespace lineatlas
