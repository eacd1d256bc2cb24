#pragma once

#include <cstdint>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "segment_table.h"
#include "style_numbers.h"

namespace lineatlas::test::oracles {

struct DensityInput {
    std::span<const Segment> segments;
    std::span<const std::uint32_t> arcs;
    std::span<const std::uint8_t> alpha;
    glm::vec2 viewport; ///< pixels
    Density density;
    glm::vec4 focus; ///< centre x and y, radius and falloff in pixels; falloff 0: no focus
    float far_limit; ///< factor of the limit far from the focus
};

/// The weights of `density`, cell by cell from a plane per bin. Gives every run its bin. weights:
/// LA_DENSITY_BINS planes of density_cells(viewport).
void density(const DensityInput& input, std::span<Run> runs, std::span<float> weights);

} // namespace lineatlas::test::oracles
