#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drawn_lines.hpp"

namespace lineatlas {

/// A drawn piece with the mesh positions of its edge (LineSource::from and to).
struct TaggedPiece {
    glm::dvec2 from, to; ///< pixels from the upper left corner, y down
    std::uint32_t p, q;
};

/// A drawing in a file of to_svg() or to_json().
struct DrawingFile {
    glm::ivec2 size{0, 0};                ///< of the picture in pixels
    std::string description{};            ///< the settings that made it
    std::vector<DrawnPiece> legs{};       ///< DrawnLines::legs
    std::vector<std::size_t> path_ends{}; ///< DrawnLines::path_ends
    std::vector<TaggedPiece> tags{};      ///< of JSON; none if it was written without
};

/// Reads a drawing without lines on hidden layers. SVG on a page is scaled back to pixels. Throws
/// FileError, also for drawings of other programs.
DrawingFile read_drawing(const std::filesystem::path& path);

/// The value of an option in the command of a description: "40" from "--fov 40" or "--fov=40".
/// Nothing if it was not given.
std::optional<std::string> described(std::string_view description, std::string_view option);
/// The values of an option that may have been given several times.
std::vector<std::string> all_described(std::string_view description, std::string_view option);

/// The drawing's lines by segments of the line set that it was drawn from.
DrawnLines find_segments(const DrawingFile& drawing, const LineSet& lines);

} // namespace lineatlas
