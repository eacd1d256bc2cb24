#pragma once

#include <optional>
#include <span>

#include "exact_intervals.hpp"
#include "lineatlas/pick.hpp"

namespace lineatlas {

/// Throws UsageError for arguments that Renderer::pick() does not take.
void check_pick(glm::vec2 position, float radius);

/// The line or face that is seen at a position of the picture, see Renderer::pick(). Looks only at
/// the part of the picture around the position, by `found`. Throws as Renderer::pick() does.
std::optional<Pick> pick(ExactIntervals& found, compute::Device& device, const PlacedLines& lines,
                         std::span<const LineObject> objects, const LineView& view,
                         glm::vec2 position, float radius);

} // namespace lineatlas
