#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "lineatlas/vector.hpp"
#include "sheet.hpp"

namespace lineatlas {

/// A point of an outline, and how the outline goes on from there.
struct OutlinePoint {
    glm::dvec2 at{0, 0};
    /// 0: straight to the next point, or by an ellipse. Else by an arc: the tangent of a quarter of
    /// its angle, positive where that goes from the x axis towards the y axis.
    double bulge = 0;
    /// The arc with all digits, if a file or a mesh's circle gives it; `bulge` alone loses some.
    std::optional<VectorArc> arc{};
    std::optional<VectorCubic> cubic{}; ///< or by this, and `bulge` is 0

    bool is_straight() const { return bulge == 0 && !arc && !cubic; }
    bool is_elliptic() const { return arc && arc->ratio != 1; }
    /// Whether the outline goes on by a curve that polylines of DXF cannot hold.
    bool is_apart() const { return is_elliptic() || cubic; }
};

/// A path as it is written to files that know arcs. A circle or an ellipse is closed and has two
/// points.
struct Outline {
    std::vector<OutlinePoint> points;
    bool closed = false; ///< from the last point back to the first one

    /// Whether all of it is one circle, or one ellipse.
    bool is_round() const;
};

/// From a point from which the way is an arc.
VectorArc arc_between(const OutlinePoint& from, glm::dvec2 to);

/// Lengths of what is drawn, in its own units.
double length_of(const VectorArc& arc);
double length_of(const Outline& outline);

/// Which arcs are wanted.
struct ArcChoice {
    bool known = true;   ///< VectorPath::curves
    bool fitted = false; ///< where a path has none of these: fit_arcs()
};

/// The name of the layer of fills.
inline constexpr const char* fill_layer = "fill";

/// The borders of an area in the units of its sheet.
std::vector<Outline> outlines_of(const VectorFill& fill, const Sheet& sheet);

/// A path in the units of its sheet.
Outline outline_of(const VectorPath& path, const Sheet& sheet, const ArcChoice& arcs);

} // namespace lineatlas
