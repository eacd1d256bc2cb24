#pragma once

#include "common.hpp"

namespace lineatlas::bench {

/// The wanted speed of a row at goal_size elements.
struct Goal {
    std::string name;
    std::string row;
    std::string rival; ///< another row; empty: the fastest copy on the device
    double wanted;     ///< times the rival's speed
    double seen = 0;   ///< 0: not measured
};

inline constexpr std::uint32_t goal_size = 1U << 22U;

std::vector<Goal> known_goals();

/// Runs the row and its rival in turns and sets `seen`.
void measure(Goal& goal, const Rows& rows);

/// The table of the measured goals.
std::string table(const std::vector<Goal>& goals);

} // namespace lineatlas::bench
