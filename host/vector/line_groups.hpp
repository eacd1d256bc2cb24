#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lineatlas/vector.hpp"

namespace lineatlas {

/// A layer of the drawing: paths of one kind or of the outline, with one pen. All are visible or
/// all hidden, and all are thinned or none.
struct LineGroup {
    LineKind kind; ///< for an outline the kind of its first path
    bool visible;
    bool outline;
    bool thinned;    ///< not shown
    unsigned number; ///< counts groups of one kind with different pens, from 1
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
