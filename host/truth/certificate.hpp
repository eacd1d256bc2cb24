#pragma once

#include <optional>
#include <span>
#include <string>

#include "drawn_lines.hpp"

namespace lineatlas {

/// The result of checking a drawing by rays.
struct Certificate {
    DrawingErrors wide;                   ///< within 1.5 pixels
    DrawingErrors narrow;                 ///< within 0.5 pixels
    std::optional<StrictErrors> strict{}; ///< of a drawing with tags
};

/// Compares all drawn legs with the truth. The result has no StrictErrors.
Certificate compare_lines(const EdgeTruth& truth, std::span<const DrawnPiece> legs);

/// A certificate as one line, for a file's metadata.
std::string certificate_line(const Certificate& certificate);

/// A certificate as a table, with the worst places: at most `places` of each kind, by the pixels of
/// line that are wrong there.
std::string certificate_table(const Certificate& certificate, std::size_t places);

} // namespace lineatlas
