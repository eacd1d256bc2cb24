#pragma once

#include "outline.hpp"

namespace lineatlas {

/// Replaces points that lie on circles by arcs, and an outline that goes all around a circle by
/// that circle. `outline` is in pixels and straight.
///
/// Consecutive points are an arc if all of them lie within 0.02 pixels of one circle, if there are
/// at least five, if they span 30 degrees, and if neighbours are at most 30 degrees apart, as on
/// meshes of round things. Parts of ellipses and the like are no arcs. The ends of an open path lie
/// where the line disappears, anywhere between two points of the circle, and move out to the
/// circle.
Outline fit_arcs(const Outline& outline);

} // namespace lineatlas
