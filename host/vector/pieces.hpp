#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lineatlas/camera.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/vector.hpp"

namespace lineatlas {

/// The point at a share of the way between two points of a straight line, or beyond them.
VectorPoint between(const VectorPoint& a, const VectorPoint& b, double share);

/// A whole segment on the screen, up to the near plane.
struct ScreenSegment {
    VectorPoint p, q;
    double length = 0; ///< pixels
    /// Names of the ends of a contour, which has no vertices. Ends that meet have the same name,
    /// and so do ends that are one behind the other.
    std::uint64_t end_p = 0, end_q = 0;
};

/// One end of a piece.
struct PieceEnd {
    double t = 0;           ///< share of the way along the segment
    std::uint32_t kind = 0; ///< LA_END_*
};

/// A part of one segment that is visible all along, or hidden all along.
struct Piece {
    std::uint32_t segment = 0; ///< index into LineSet::segments
    std::uint32_t screen = 0;  ///< index into Pieces::screen
    PieceEnd start{}, end{};
    bool visible = true;
    float alpha = 1;
};

/// The data of all steps up to the chains.
struct Pieces {
    std::vector<ScreenSegment> screen;
    std::vector<Piece> list; ///< in order of the segments and along each
    bool exact = false;      ///< see LA_INTERVAL_EXACT

    const ScreenSegment& segment_of(const Piece& piece) const { return screen[piece.screen]; }
    VectorPoint point(const Piece& piece, double t) const {
        return between(segment_of(piece).p, segment_of(piece).q, t);
    }
    VectorPoint start(const Piece& piece) const { return point(piece, piece.start.t); }
    VectorPoint end(const Piece& piece) const { return point(piece, piece.end.t); }
    double length(const Piece& piece) const {
        return (piece.end.t - piece.start.t) * segment_of(piece).length;
    }
};

/// Whether an end of this kind lies at the vertex of its segment.
bool at_vertex(std::uint32_t kind);

/// Ends of neighbours in a path are one place within this, pixels.
constexpr double same_place = 0.02;

/// Leaves out pieces without length, where visibility only seems to change. A whole segment stays
/// however short it is: it holds its neighbours together.
void drop_flickers(Pieces& pieces);

/// Whether a segment is a contour (LineSet::contours): its intervals alone say where it runs.
bool is_contour(const LineSet& lines, std::uint32_t segment);

/// Whether two segments meet in a vertex of the mesh.
bool share_vertex(const Segment& a, const Segment& b);

/// Whether piece b starts where piece a, which comes before it, ends, in one path.
bool goes_on(const LineSet& lines, const Pieces& pieces, const Piece& a, const Piece& b);

/// The intervals as parts of their segments, so that ends move along exact lines. Intervals of
/// segments that the camera cannot see, and what is not finite, are left out.
Pieces make_pieces(const LineSet& lines, const Camera& camera, std::span<const Interval> intervals);

} // namespace lineatlas
