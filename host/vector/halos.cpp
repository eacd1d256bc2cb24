#include "halos.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <glm/geometric.hpp>

#include "core/plane_vectors.hpp"
#include "segment_grid.hpp"
#include "shared/constants.h"

namespace lineatlas {
namespace {

constexpr double reach_hidden{LA_HALO_REACH_HIDDEN};
constexpr double reach_over{LA_HALO_REACH_OVER};
constexpr double least_sine{LA_HALO_LEAST_SINE};
constexpr double most_stretch{LA_HALO_STRETCH};

/// A visible part of one segment.
struct StrokePiece {
    std::uint32_t strip, segment;
    double from;          ///< pixels from the start of the strip
    VectorPoint a, b;     ///< along the strip
    glm::dvec2 along;     ///< unit direction
    double length;        ///< pixels
    double before, after; ///< lengths by which it is longer if it is cut, pixels
};

struct Crossing {
    double on_line, on_other, sine; ///< pixels from the starts
};

class Halos {
  public:
    Halos(const LineSet& lines, const Pieces& pieces, glm::dvec2 picture,
          const HaloOptions& options)
        : lines_(lines), pieces_(pieces), options_(options), grid_(picture) {}

    std::vector<std::vector<Cut>> find(const std::vector<Strip>& strips) {
        for (std::uint32_t i = 0; i < strips.size(); ++i) add_strokes(strips[i], i);
        std::vector<std::vector<Cut>> cuts(strips.size());
        for (const StrokePiece& piece : stroke_pieces_) find_cuts(piece, cuts[piece.strip]);
        for (std::size_t i = 0; i < strips.size(); ++i) {
            if (strips[i].closed) wrap(strips[i].length, cuts[i]);
            std::ranges::sort(cuts[i], {}, &Cut::from);
        }
        return cuts;
    }

  private:
    void add_strokes(const Strip& strip, std::uint32_t index) {
        for (const Stroke& stroke : strip.strokes) {
            if (!stroke.visible) continue;
            auto step = std::ranges::upper_bound(strip.steps, stroke.from, {}, &StripStep::start);
            for (step = std::prev(step); step != strip.steps.end() && step->start < stroke.to;
                 ++step) {
                add_piece(stroke, *step, index);
            }
        }
    }

    void add_piece(const Stroke& stroke, const StripStep& step, std::uint32_t index) {
        const ScreenSegment& segment = pieces_.screen[step.screen];
        const double from = std::max(stroke.from, step.start);
        const double to = std::min(stroke.to, step.start + segment.length);
        if (!(to > from)) return;
        const auto place = [&](double at) {
            const double share = (at - step.start) / segment.length;
            return step.reversed ? between(segment.q, segment.p, share)
                                 : between(segment.p, segment.q, share);
        };
        const auto reach = [](std::uint32_t kind) {
            return kind == LA_END_HIDDEN ? reach_hidden : 0;
        };
        StrokePiece piece{.strip = index,
                          .segment = step.segment,
                          .from = from,
                          .a = place(from),
                          .b = place(to),
                          .along = {},
                          .length = to - from,
                          .before = from == stroke.from ? reach(stroke.start_kind) : 0,
                          .after = to == stroke.to ? reach(stroke.end_kind) : 0};
        piece.along = (piece.b.at - piece.a.at) / piece.length;
        grid_.insert(piece.a.at - piece.along * reach_over, piece.b.at + piece.along * reach_over,
                     static_cast<std::uint32_t>(stroke_pieces_.size()));
        stroke_pieces_.push_back(piece);
    }

    void find_cuts(const StrokePiece& piece, std::vector<Cut>& cuts) {
        const glm::dvec2 start = piece.a.at - piece.along * piece.before;
        const glm::dvec2 end = piece.b.at + piece.along * piece.after;
        for (const std::uint32_t i : grid_.near(start, end, 0)) {
            const StrokePiece& other = stroke_pieces_[i];
            const std::optional<Crossing> crossing = crossing_of(piece, other);
            if (!crossing || !is_nearer(piece, other, *crossing)) continue;
            if (share_vertex(lines_.segments[piece.segment], lines_.segments[other.segment])) {
                continue;
            }
            const double half =
                options_.width *
                std::min(1 / crossing->sine, most_stretch * most_stretch * crossing->sine);
            const double centre = piece.from + crossing->on_line;
            cuts.push_back({centre - half, centre + half});
        }
    }

    static std::optional<Crossing> crossing_of(const StrokePiece& piece, const StrokePiece& other) {
        const double sine = cross(piece.along, other.along);
        if (!(std::abs(sine) >= least_sine)) return {};
        const glm::dvec2 between = other.a.at - piece.a.at;
        const Crossing crossing{.on_line = cross(between, other.along) / sine,
                                .on_other = cross(between, piece.along) / sine,
                                .sine = std::abs(sine)};
        if (crossing.on_line < -piece.before || crossing.on_line > piece.length + piece.after ||
            crossing.on_other < -reach_over || crossing.on_other > other.length + reach_over) {
            return {};
        }
        return crossing;
    }

    bool is_nearer(const StrokePiece& piece, const StrokePiece& other,
                   const Crossing& crossing) const {
        const VectorPoint own = between(piece.a, piece.b, crossing.on_line / piece.length);
        const double share = std::clamp(crossing.on_other / other.length, 0.0, 1.0);
        const double other_depth = std::lerp(other.a.depth, other.b.depth, share);
        const double apart =
            options_.tolerance * own.inverse_w + static_cast<double>(LA_DEPTH_ROUNDING);
        return other_depth < own.depth - 2 * apart;
    }

    /// Gaps at the seam of a closed strip lie on both of its sides.
    static void wrap(double length, std::vector<Cut>& cuts) {
        const std::size_t count = cuts.size();
        for (std::size_t i = 0; i < count; ++i) {
            const Cut cut = cuts[i];
            if (cut.from < 0) cuts.push_back({cut.from + length, cut.to + length});
            if (cut.to > length) cuts.push_back({cut.from - length, cut.to - length});
        }
    }

    const LineSet& lines_;
    const Pieces& pieces_;
    HaloOptions options_;
    SegmentGrid grid_;
    std::vector<StrokePiece> stroke_pieces_;
};

} // namespace

std::vector<std::vector<Cut>> find_halos(const LineSet& lines, const Pieces& pieces,
                                         const std::vector<Strip>& strips, glm::dvec2 picture,
                                         const HaloOptions& options) {
    return Halos{lines, pieces, picture, options}.find(strips);
}

} // namespace lineatlas
