#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "background.hpp"
#include "base/stretches.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/vector.hpp"
#include "pieces.hpp"

namespace lineatlas {

/// A segment of a strip.
struct StripStep {
    std::uint32_t segment = 0; ///< index into LineSet::segments
    std::uint32_t screen = 0;  ///< index into Pieces::screen
    bool reversed = false;     ///< walked from q to p
    double start = 0;          ///< pixels from the start of the strip
};

/// A part of a strip that is drawn in one go, visible all along or hidden all along. A stroke that
/// grew may reach beyond the strip: straight on if the strip is open, and around if it is closed.
struct Stroke {
    double from = 0, to = 0;                    ///< pixels from the start of the strip
    std::uint32_t start_kind = 0, end_kind = 0; ///< LA_END_*: CLIPPED, JOIN (a seam), HIDDEN, PATH
    bool visible = true;
    float alpha = 1; ///< mean visibility

    double length() const { return to - from; }
};

/// Segments that are connected on the screen: a path of the line set, or a chain of silhouettes,
/// each of which is a path in the line set.
struct Strip {
    LineKind kind = LineKind::crease;
    std::uint32_t path = 0; ///< of its first segment
    bool closed = false;
    bool open_start = false, open_end = false; ///< the path itself ends there
    double length = 0;
    double start_arc = 0; ///< arc length at its start
    std::vector<StripStep> steps;
    std::vector<Stretch> outlines{}; ///< beside the background, pixels from the start; ascending
    std::vector<Stroke> strokes;     ///< ascending
};

/// Makes strips of pieces. Silhouettes are chained at the mesh's vertices, the straightest first.
std::vector<Strip> make_strips(const LineSet& lines, const Pieces& pieces);

/// Marks the stretches of every strip that have background on one side. Rims of holes, beside
/// Ground::enclosed, are not marked. A silhouette that ends on an edge ends the stretches beside
/// it. picture: its size, pixels.
void mark_outlines(std::vector<Strip>& strips, const Pieces& pieces,
                   std::span<const OutlinePart> outlines, glm::dvec2 picture,
                   const Background& background);

} // namespace lineatlas
