#pragma once

#include <span>
#include <string>
#include <vector>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Paths of one kind, all visible or all hidden: a layer of the drawing.
struct LineGroup {
    LineKind kind;
    bool visible;
    std::span<const VectorPath> paths;

    /// "crease", "crease-hidden".
    std::string name() const;
    const Pen& pen(const Style& style) const { return visible ? style.pen : style.hidden_pen; }
};

/// In the order in which they are drawn; paths of one group stand together in a drawing.
std::vector<LineGroup> line_groups(const VectorDrawing& drawing);

} // namespace lineatlas
