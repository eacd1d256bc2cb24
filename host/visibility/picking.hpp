#pragma once

#include <optional>
#include <span>

#include "exact_intervals.hpp"
#include "lineatlas/pick.hpp"

namespace lineatlas {

/// Throws UsageError for arguments that Renderer::pick() does not take.
void check_pick(glm::vec2 position, float radius);

/// What is seen at a position of the picture of `view`, see Renderer::pick(). Only the part of the
/// picture around it is looked at; `found` is what does that. Throws as that does.
std::optional<Pick> pick(ExactIntervals& found, compute::Device& device, const PlacedLines& lines,
                         std::span<const LineObject> objects, const LineView& view,
                         glm::vec2 position, float radius);

} // namespace lineatlas
