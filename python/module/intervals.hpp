#pragma once

#include <cstdint>
#include <vector>

#include <pybind11/numpy.h>

#include "drawer.hpp"

namespace lineatlas::python {

/// An interval as a row of Python's array; -1 stands for none.
struct IntervalRow {
    float p[2], q[2];             ///< pixels from the upper left corner, as in pictures
    float p_depth, q_depth;       ///< window depth, 0 near to 1 far
    float p_world[3], q_world[3]; ///< points of the model
    float alpha;                  ///< mean visibility
    std::uint8_t kind;
    bool visible;
    std::int32_t segment;  ///< row in the table of segments
    std::int32_t path;     ///< path of the segment
    std::int32_t edge[2];  ///< positions of the mesh
    std::int32_t triangle; ///< triangle with the edge
    std::int32_t crossing; ///< the other triangle of an intersection
    std::int32_t group;    ///< group of `triangle`
};

std::vector<IntervalRow> interval_rows(const FoundIntervals& found, int height);

/// Registers the row as a NumPy type.
void register_interval_row();

} // namespace lineatlas::python
