#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lineatlas/lines.hpp"

namespace lineatlas {

/// A small part of a model that lies far away from the rest.
struct FarPart {
    std::size_t count = 0; ///< its triangles and lines
    std::size_t total = 0; ///< those of the model
    Bounds rest;           ///< of the others
    float ratio = 1;       ///< of the extent of all to that of the others
};

/// The far part of a model. Nothing if no part is small enough and far enough away to matter.
std::optional<FarPart> find_far_part(const LineSet& lines);

/// What a camera that frames a model should show: its vertices, but for a far part that is at most
/// a thousandth of it.
std::vector<glm::vec3> points_to_frame(const LineSet& lines, const std::optional<FarPart>& far);

/// Whether it leaves the part out.
bool is_left_out(const FarPart& far);

/// A line for the user that says what was done about it.
std::string note_of(const FarPart& far);

} // namespace lineatlas
