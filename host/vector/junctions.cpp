#include "junctions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/plane_vectors.hpp"
#include "patch_cover.hpp"
#include "segment_grid.hpp"
#include "shared/constants.h"

namespace lineatlas {
namespace {

/// Lines at less than this sine to each other run along each other and do not cross.
constexpr double least_sine = 0.01;
/// How near to its very end, in pixels, a line may cross another.
constexpr double end_slack = 0.05;
/// Ends of contours with one name meet if their depths differ by less than this.
constexpr double same_depth = 1e-5;
/// How far from its silhouette the exact method may see a line vanish, pixels: triangles are inside
/// their surface, and the line may come to the silhouette aslant.
constexpr double exact_reach = 2.5;
/// How far beyond the end of a visible line, in pixels, is asked what hides it.
constexpr double beyond_end = 0.05;
/// The same for silhouettes. They are tested off their surface, so they vanish a little early.
constexpr double beyond_silhouette = 1.75;

/// The range along its segment to which an end may move.
struct Range {
    double low, high;
};

class Junctions {
  public:
    Junctions(const LineSet& lines, const Camera& camera, Pieces& pieces, double reach)
        : lines_(lines), pieces_(pieces), before_(pieces.list), grid_(glm::dvec2{camera.size}),
          reach_(pieces.exact ? std::max(reach, exact_reach) : reach),
          line_at_(lines.vertices.size(), no_line) {
        for (std::uint32_t i = 0; i < before_.size(); ++i) {
            const Piece& piece = before_[i];
            if (!piece.visible || (pieces.exact && !is_beyond_triangles(piece))) continue;
            grid_.insert(pieces.start(piece).at, pieces.end(piece).at, i);
            if (is_contour(lines, piece.segment)) continue; // it ends at no vertex
            const Segment& segment = lines.segments[piece.segment];
            if (at_vertex(piece.start.kind)) note_line_at(segment.p, piece.segment);
            if (at_vertex(piece.end.kind)) note_line_at(segment.q, piece.segment);
        }
        if (pieces.exact && !lines.contours.surfaces.empty()) {
            cover_.emplace(lines, camera);
            for (std::size_t i = 0; i < before_.size(); ++i) note_chord_ends(i);
        }
    }

    std::size_t meet_all() {
        std::size_t met = 0;
        if (pieces_.exact && lines_.contours.surfaces.empty()) return met;
        for (std::size_t i = 0; i < pieces_.list.size(); ++i)
            for (const bool at_end : {false, true})
                met += before_[i].visible && pieces_.list[i].visible && meet(i, at_end) ? 1U : 0U;
        insert_divided();
        return met;
    }

  private:
    bool is_beyond_triangles(const Piece& piece) const {
        const KnownSurfaces& known = lines_.contours.surfaces;
        return !known.empty() && is_contour(lines_, piece.segment) &&
               known.of_triangle[face_of(piece)] != KnownSurfaces::none;
    }

    /// The triangle of a contour, into Contours::faces.
    std::uint32_t face_of(const Piece& piece) const {
        return static_cast<std::uint32_t>(piece.segment -
                                          (lines_.segments.size() - lines_.contours.faces.size()));
    }

    static PieceEnd& end_of(Piece& piece, bool at_end) { return at_end ? piece.end : piece.start; }
    static const PieceEnd& end_of(const Piece& piece, bool at_end) {
        return at_end ? piece.end : piece.start;
    }

    using Places = std::array<VectorPoint, 2>;

    /// Places just beyond an end, on the line. What hides the line at one of them ends it.
    Places hidden_beside(const Piece& piece, bool at_end) const {
        const auto place = [&](double pixels) {
            const double step = pixels / pieces_.segment_of(piece).length;
            return pieces_.point(piece, end_of(piece, at_end).t + (at_end ? step : -step));
        };
        return {place(beyond_end),
                place(is_contour(lines_, piece.segment) ? beyond_silhouette : beyond_end)};
    }

    /// The next piece beyond an end, if there is one.
    Piece* neighbour(std::size_t i, bool at_end) {
        if (at_end ? i + 1 == pieces_.list.size() : i == 0) return nullptr;
        return &pieces_.list[at_end ? i + 1 : i - 1];
    }

    bool touches(const Piece& piece, const Piece& other, bool at_end) const {
        return at_end ? goes_on(lines_, pieces_, piece, other)
                      : goes_on(lines_, pieces_, other, piece);
    }

    bool meet(std::size_t i, bool at_end) {
        Piece& piece = pieces_.list[i];
        PieceEnd& end = end_of(piece, at_end);
        if (!(pieces_.segment_of(piece).length > 0)) return false;
        if (end.kind != LA_END_HIDDEN)
            return is_hidden_on(i, at_end) && meet_on_next_chord(i, at_end);
        Piece* other = neighbour(i, at_end);
        const bool shared = other != nullptr && touches(piece, *other, at_end);
        // The line is visible on either side of the vertex.
        if (shared && other->visible) return false;
        const bool beside = other != nullptr && other->screen == piece.screen;
        const bool moves_along = shared && beside;
        double limit = at_end ? 1 : 0;
        if (beside) limit = end_of(*other, moves_along ? at_end : !at_end).t;
        const Range range = at_end ? Range{piece.start.t, limit} : Range{limit, piece.end.t};
        const Places hidden = hidden_beside(before_[i], at_end);
        const std::optional<double> t = nearest_crossing(
            piece, {.t = end.t, .far = end_of(piece, !at_end).t, .reach = reach_}, range, hidden);
        if (!t)
            return meet_on_next_chord(i, at_end) ||
                   meet_vertex(piece, at_end, range, moves_along ? other : nullptr);
        end.t = *t;
        if (moves_along) end_of(*other, !at_end).t = *t;
        return true;
    }

    /// One of the two ends of a piece.
    struct Side {
        std::size_t piece;
        bool at_end;
    };

    void note_chord_ends(std::size_t i) {
        const Piece& piece = before_[i];
        if (!is_contour(lines_, piece.segment)) return;
        const ScreenSegment& chord = pieces_.segment_of(piece);
        if (piece.start.t == 0) ends_of_chords_.emplace(chord.end_p, Side{i, false});
        if (piece.end.t == 1) ends_of_chords_.emplace(chord.end_q, Side{i, true});
    }

    /// The end of the next chord of a contour that is there where a piece's own chord ends.
    std::optional<Side> next_chord(const Piece& piece, bool at_end) const {
        const ScreenSegment& own = pieces_.segment_of(piece);
        const double depth = (at_end ? own.q : own.p).depth;
        const auto [first, last] = ends_of_chords_.equal_range(at_end ? own.end_q : own.end_p);
        for (auto found = first; found != last; ++found) {
            const Piece& other = before_[found->second.piece];
            const ScreenSegment& chord = pieces_.segment_of(other);
            const double its_depth = (found->second.at_end ? chord.q : chord.p).depth;
            if (other.screen != piece.screen && std::abs(its_depth - depth) < same_depth)
                return found->second;
        }
        return std::nullopt;
    }

    /// Whether a contour is hidden from the end of this chord on.
    bool is_hidden_on(std::size_t i, bool at_end) const {
        if (!pieces_.exact || !is_contour(lines_, before_[i].segment)) return false;
        const std::optional<Side> next = next_chord(before_[i], at_end);
        return next && !before_[next->piece].visible;
    }

    /// The hidden piece of the same chord beyond an end, if there is one.
    Piece* rest_of_chord(std::size_t i, bool at_end) {
        Piece* const rest = neighbour(i, at_end);
        const bool is_rest =
            rest != nullptr && rest->screen == pieces_.list[i].screen && !rest->visible;
        return is_rest ? rest : nullptr;
    }

    /// A contour is a row of chords. The crossing may be on the next chord, which is hidden, or on
    /// the chord before, which is visible.
    bool meet_on_next_chord(std::size_t i, bool at_end) {
        Piece& piece = pieces_.list[i];
        if (!pieces_.exact || !is_contour(lines_, piece.segment)) return false;
        struct Found {
            Side side;
            double t, way;
            bool goes_on;
        };
        std::optional<Found> nearest;
        Piece* const rest = rest_of_chord(i, at_end);
        const Places hidden = hidden_beside(before_[i], at_end);
        for (const bool goes_on : {true, false}) {
            const bool side = goes_on == at_end;
            const double chord_end = side ? 1 : 0;
            const double last = end_of(goes_on && rest != nullptr ? *rest : piece, side).t;
            if (last != chord_end) continue;
            const double way =
                std::abs(chord_end - end_of(piece, at_end).t) * pieces_.segment_of(piece).length;
            const std::optional<Side> next = next_chord(piece, side);
            if (!(way < reach_) || !next) continue;
            Piece& other = pieces_.list[next->piece];
            if (!(pieces_.segment_of(other).length > 0)) continue; // seen end on
            const double from = next->at_end ? 1 : 0;
            if (other.visible == goes_on || end_of(other, next->at_end).t != from) continue;
            const auto t = nearest_crossing(other, {.t = from, .far = {}, .reach = reach_ - way},
                                            {other.start.t, other.end.t}, hidden);
            if (!t) continue;
            const double whole = way + std::abs(*t - from) * pieces_.segment_of(other).length;
            if (!nearest || whole < nearest->way) nearest = {*next, *t, whole, goes_on};
        }
        if (!nearest) return false;
        if (!nearest->goes_on)
            piece.visible = false;
        else if (rest != nullptr)
            rest->visible = true;
        divide(nearest->side, nearest->t);
        return true;
    }

    /// Divides a piece. The part at the given end is visible if the piece is not.
    void divide(const Side& side, double t) {
        Piece& piece = pieces_.list[side.piece];
        Piece part = piece;
        part.visible = !piece.visible;
        end_of(piece, side.at_end) = end_of(part, !side.at_end) = {.t = t, .kind = LA_END_HIDDEN};
        divided_.emplace(side.piece, std::pair{side.at_end, part});
    }

    /// Puts the new parts beside the pieces that they are of.
    void insert_divided() {
        if (divided_.empty()) return;
        std::vector<Piece> list;
        for (std::size_t i = 0; i < pieces_.list.size(); ++i) {
            const auto [first, last] = divided_.equal_range(i);
            for (auto part = first; part != last; ++part)
                if (!part->second.first) list.push_back(part->second.second);
            list.push_back(pieces_.list[i]);
            for (auto part = first; part != last; ++part)
                if (part->second.first) list.push_back(part->second.second);
        }
        pieces_.list = std::move(list);
    }

    /// Moves an end to a nearby vertex where another visible line ends. Lines vanish behind their
    /// own surface at vertices of outlines.
    bool meet_vertex(Piece& piece, bool at_end, Range range, Piece* other) {
        if (pieces_.exact || is_contour(lines_, piece.segment)) return false;
        PieceEnd& end = end_of(piece, at_end);
        const double t = end.t < 0.5 ? 0 : 1;
        const Segment& segment = lines_.segments[piece.segment];
        const std::uint32_t line = line_at_[t == 0 ? segment.p : segment.q];
        if (line == no_line || line == piece.segment || end.t == t) return false;
        if (t < range.low || t > range.high) return false;
        if (std::abs(t - end.t) * pieces_.segment_of(piece).length > reach_) return false;
        end.t = t;
        if (other == nullptr) return true;
        end_of(*other, !at_end).t = t;
        // The hidden part up to the vertex is gone, so the line goes on there, or ends.
        const PieceEnd far = end_of(*other, at_end);
        if (far.t == t) end.kind = far.kind;
        return true;
    }

    /// Notes the line that is visible at a vertex. A line does not meet itself.
    void note_line_at(std::uint32_t vertex, std::uint32_t segment) {
        std::uint32_t& line = line_at_[vertex];
        line = line == no_line || line == segment ? segment : several_lines;
    }

    /// An end that looks for a crossing.
    struct Seeker {
        double t;                  ///< where it is
        std::optional<double> far; ///< where the other end of its piece is
        double reach;              ///< pixels
    };

    /// `hidden`: where the line is hidden beside its old end. By the exact method the surface of
    /// the silhouette that is met must hide one of these places.
    std::optional<double> nearest_crossing(const Piece& piece, const Seeker& end, Range range,
                                           const Places& hidden) {
        const double length = pieces_.segment_of(piece).length, step = end.reach / length;
        const glm::dvec2 from = pieces_.point(piece, end.t - step).at;
        const glm::dvec2 to = pieces_.point(piece, end.t + step).at;
        std::optional<double> nearest;
        for (const std::uint32_t j : grid_.near(from, to, end_slack)) {
            const std::optional<double> found = crossing(piece, before_[j]);
            if (!found || *found < range.low || *found > range.high) continue;
            const double way = std::abs(*found - end.t);
            if (way > step || (nearest && !(way < std::abs(*nearest - end.t)))) continue;
            if (cover_) {
                if (end.far && std::abs(*found - *end.far) * length < end_slack) continue;
                if (std::ranges::none_of(hidden, [&](const VectorPoint& place) {
                        return cover_->hides(face_of(before_[j]), place, exact_reach);
                    }))
                    continue;
            }
            nearest = found;
        }
        return nearest;
    }

    /// The place along the segment of `piece` where a nearer line crosses it.
    std::optional<double> crossing(const Piece& piece, const Piece& other) const {
        if (share_vertex(lines_.segments[piece.segment], lines_.segments[other.segment])) return {};
        const ScreenSegment& segment = pieces_.segment_of(piece);
        const VectorPoint a = pieces_.start(other);
        const VectorPoint b = pieces_.end(other);
        const glm::dvec2 way = segment.q.at - segment.p.at;
        const glm::dvec2 other_way = b.at - a.at;
        const double other_length = glm::length(other_way);
        const double area = cross(way, other_way);
        if (!(std::abs(area) > least_sine * segment.length * other_length)) return {};
        const glm::dvec2 offset = a.at - segment.p.at;
        const double t = cross(offset, other_way) / area;
        const double on_other = cross(offset, way) / area;
        const double slack = end_slack / other_length;
        if (on_other < -slack || on_other > 1 + slack) return {};
        const double depth = std::lerp(segment.p.depth, segment.q.depth, t);
        const double other_depth = std::lerp(a.depth, b.depth, on_other);
        constexpr double rounding = 2 * double{LA_DEPTH_ROUNDING};
        if (!(other_depth < depth - rounding)) return {};
        return t;
    }

    static constexpr std::uint32_t no_line = 0xFFFFFFFF;
    static constexpr std::uint32_t several_lines = 0xFFFFFFFE;

    const LineSet& lines_;
    Pieces& pieces_;
    const std::vector<Piece> before_; ///< lines cross at their old places, so that the order does
                                      ///< not matter
    SegmentGrid grid_;
    std::optional<PatchCover> cover_; ///< with exact ends, of known surfaces
    double reach_;
    std::vector<std::uint32_t> line_at_; ///< per vertex, the segment that is visible there
    std::multimap<std::uint64_t, Side> ends_of_chords_; ///< of contours, by their names
    /// New parts, by the piece that each is of, and whether the part stands behind the piece.
    std::multimap<std::size_t, std::pair<bool, Piece>> divided_;
};

} // namespace

std::size_t meet_junctions(const LineSet& lines, const Camera& camera, Pieces& pieces,
                           double reach) {
    return Junctions{lines, camera, pieces, reach}.meet_all();
}

} // namespace lineatlas
