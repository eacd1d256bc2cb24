#pragma once

#include <vector>

#include <glm/geometric.hpp>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// A path through these places on the screen, all at one window depth; closed if it ends where it
/// begins. Piece i is of segment i.
VectorPath path_through(LineKind kind, bool visible, const std::vector<glm::dvec2>& points,
                        double depth = 0.5);

/// Where along the way from a to b a point is, 0 to 1.
double share_along(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b);

/// Pixels between a point and that way.
double distance_to(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b);

/// Length on the screen, pixels.
double length_of(const VectorPath& path);

/// The part of a path between two lengths from its start.
VectorPath part_of(const VectorPath& path, double from, double to);

/// The same path, drawn from its other end.
void reverse(VectorPath& path);

/// The same closed path, drawn from another of its points on.
void rotate(VectorPath& path, std::size_t first);

/// Appends `next` to `path`, which ends where `next` starts. An arc that goes on there stays one.
void append(VectorPath& path, const VectorPath& next);

} // namespace lineatlas
