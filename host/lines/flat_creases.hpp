#pragma once

#include <optional>
#include <span>
#include <vector>

#include "edges.hpp"
#include "lineatlas/lines.hpp"
#include "parts.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Finds creases between large flat faces that bend by less than least_crease_angle, such as the
/// hips of a flat roof. Facets of round things bend as little, but each of them has a similar bend
/// on either side. Returns for each edge whether it is such a crease; `kinds` says which edges are
/// lines so far. `normals`: face_normals(). docs/lines.md has the rules.
std::vector<bool> flat_creases(const WeldedMesh& mesh, const MeshParts& parts,
                               std::span<const MeshEdge> edges, std::span<const double> bends,
                               std::span<const glm::dvec3> normals,
                               std::span<const std::optional<LineKind>> kinds);

} // namespace lineatlas
