#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "compute/stages/stages.hpp"
#include "lineatlas/lines.hpp"

namespace lineatlas::test {

/// A device's tables of a model that moves.
struct MovedTables {
    std::vector<glm::vec3> vertices, drawn;
    std::vector<Cluster> clusters, bounds;
    std::vector<std::uint32_t> ranges;
};

/// The tables after the stages have moved the objects. A third of the objects have jumped.
MovedTables moved_on(compute::Stages& stages, const LineSet& lines,
                     const std::vector<glm::mat4>& transforms);

} // namespace lineatlas::test
