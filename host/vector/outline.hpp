#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"
#include "sheet.hpp"

namespace lineatlas {

/// A point of an outline, and how it goes on.
struct OutlinePoint {
    glm::dvec2 at{0, 0};
    /// 0: straight to the next point. Else by an arc: the tangent of a quarter of its angle,
    /// positive where that goes from the x axis towards the y axis.
    double bulge = 0;
};

/// A path as it is written to files that know arcs. A circle is closed and has two points.
struct Outline {
    std::vector<OutlinePoint> points;
    bool closed = false; ///< from the last point back to the first one

    bool is_circle() const;
};

/// The circle that an arc is a part of.
struct Arc {
    glm::dvec2 center;
    double radius;
    double from;  ///< angle of its start, radians from the x axis towards the y axis
    double sweep; ///< negative: towards smaller angles
};

/// From a point that has a bulge.
Arc arc_between(const OutlinePoint& from, glm::dvec2 to);

/// A path in the units of its sheet, with arcs if they are wanted.
Outline outline_of(const VectorPath& path, const Sheet& sheet, bool fit_arcs);

} // namespace lineatlas
