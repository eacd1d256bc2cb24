#pragma once

#include <cstdint>
#include <vector>

#include <pybind11/numpy.h>

#include "drawer.hpp"

namespace lineatlas::python {

/// An interval as a row of the array that Python gets; -1 stands for none.
struct IntervalRow {
    float p[2], q[2];             ///< pixels from the upper left corner, as in pictures
    float p_depth, q_depth;       ///< window depth, 0 near to 1 far
    float p_world[3], q_world[3]; ///< points of the model
    float alpha;                  ///< mean visibility
    std::uint8_t kind;
    bool visible;
    std::int32_t segment;  ///< along the table of lines
    std::int32_t path;     ///< that the segment belongs to
    std::int32_t edge[2];  ///< positions of the mesh
    std::int32_t triangle; ///< that has the edge
    std::int32_t crossing; ///< of an intersection the other triangle
    std::int32_t group;    ///< of that triangle
};

std::vector<IntervalRow> interval_rows(const FoundIntervals& found, int height);

/// Makes the row known to NumPy.
void register_interval_row();

} // namespace lineatlas::python
