#pragma once

#include <optional>
#include <span>
#include <vector>

#include "edges.hpp"
#include "lineatlas/lines.hpp"
#include "parts.hpp"
#include "weld.hpp"

namespace lineatlas {

/// Which creases are noise of the surface and no lines a draughtsman would draw: scanned and
/// sculpted surfaces bend by more than any fixed angle at single edges, here and there, as zigzags
/// of their triangulation. Per edge whether it is such a crease; `kinds` says which are creases at
/// all. The rules are in docs/lines.md; where a model is made of flat faces, none is noise.
std::vector<bool> noisy_creases(const WeldedMesh& mesh, const MeshParts& parts,
                                const std::vector<MeshEdge>& edges, std::span<const double> bends,
                                std::span<const std::optional<LineKind>> kinds);

} // namespace lineatlas
