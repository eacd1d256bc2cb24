#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// Paths of one kind or of the outline, with one pen, all visible or all hidden, all thinned or
/// none: a layer of the drawing.
struct LineGroup {
    LineKind kind; ///< of an outline that of its first path
    bool visible;
    bool outline;
    bool thinned;    ///< not shown
    unsigned number; ///< among those of its kind that differ in their pens, from 1
    const Pen& pen;  ///< the drawing's
    std::span<const VectorPath> paths;

    /// "crease", "outline".
    std::string_view kind_name() const;
    /// "crease", "crease-hidden", "crease-thinned", "outline", "crease-2" of another pen.
    std::string name() const;
};

/// In the order in which they are drawn; paths of one group stand together in a drawing.
std::vector<LineGroup> line_groups(const VectorDrawing& drawing);

} // namespace lineatlas
