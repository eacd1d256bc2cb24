#pragma once

#include "outline.hpp"

namespace lineatlas {

/// Puts arcs in the place of points that lie on circles, and a circle in the place of an outline
/// that goes all around one. `outline` is in pixels and straight.
///
/// A run of points is an arc if all of them lie within 0.02 pixels of one circle, there are five at
/// least, they span 30 degrees, and neighbours are no farther apart than a mesh of something round
/// has them: 30 degrees, beyond which edges are creases. Parts of ellipses and the like are none.
/// An open path's own ends lie where the line disappears, anywhere between two points of the
/// circle, and move out to it.
Outline fit_arcs(const Outline& outline);

} // namespace lineatlas
