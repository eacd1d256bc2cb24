#pragma once

#include <optional>
#include <span>
#include <vector>

#include "edges.hpp"
#include "lineatlas/lines.hpp"
#include "parts.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Finds creases that are noise of the surface and not lines that a draughtsman would draw. Scanned
/// and sculpted surfaces bend by more than any fixed angle at single edges, along zigzags of their
/// triangulation. Returns for each edge whether it is such a crease; `kinds` says which edges are
/// creases. docs/lines.md has the rules. In a model of flat faces no crease is noise.
std::vector<bool> noisy_creases(const WeldedMesh& mesh, const MeshParts& parts,
                                const std::vector<MeshEdge>& edges, std::span<const double> bends,
                                std::span<const std::optional<LineKind>> kinds);

} // namespace lineatlas
