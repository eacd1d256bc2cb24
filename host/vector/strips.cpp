#include "strips.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <set>
#include <span>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/chain.hpp"

namespace lineatlas {
namespace {

/// Silhouettes of fine meshes zigzag, so they go on through all but the sharpest turns.
constexpr float silhouette_chain_angle = 150.0F * std::numbers::pi_v<float> / 180;
/// Strokes shorter than this, in pixels, are flickers of visibility.
constexpr double shortest = 0.01;

/// The pieces of one segment.
struct Own {
    std::uint32_t first, end; ///< in Pieces::list
};

class StripMaker {
  public:
    StripMaker(const LineSet& lines, const Pieces& pieces) : lines_(lines), pieces_(pieces) {
        for (const ContourCorner& corner : lines.contours.corners)
            if (std::ranges::all_of(corner.normal, [](float x) { return x == 0; }))
                tips_.insert(as_array(lines.vertices[corner.vertex]));
    }

    std::vector<Strip> make() {
        collect_segments();
        std::vector<Strip> strips = strips_of_paths();
        add_silhouettes(strips);
        for (Strip& strip : strips) finish(strip);
        return strips;
    }

  private:
    const Segment& segment(std::size_t own) const {
        return lines_.segments[pieces_.list[owns_[own].first].segment];
    }
    const ScreenSegment& screen(std::size_t own) const {
        return pieces_.segment_of(pieces_.list[owns_[own].first]);
    }
    std::uint32_t kind_of(std::size_t own) const { return segment(own).tag & LA_TAG_KIND_MASK; }

    void collect_segments() {
        for (std::uint32_t i = 0; i < pieces_.list.size(); ++i) {
            if (i == 0 || pieces_.list[i].screen != pieces_.list[i - 1].screen) {
                owns_.push_back({i, i});
            }
            owns_.back().end = i + 1;
        }
    }

    bool connected(std::size_t a, std::size_t b) const {
        return segment(a).path == segment(b).path &&
               glm::distance(screen(a).q.at, screen(b).p.at) < same_place;
    }

    std::vector<Strip> strips_of_paths() {
        std::vector<Strip> strips;
        for (std::size_t i = 0; i < owns_.size(); ++i) {
            if (kind_of(i) == LA_KIND_SILHOUETTE) continue;
            const bool goes_on = !strips.empty() && i > 0 && connected(i - 1, i) &&
                                 kind_of(i - 1) != LA_KIND_SILHOUETTE;
            if (!goes_on) strips.emplace_back();
            add_step(strips.back(), static_cast<std::uint32_t>(i), false);
        }
        for (Strip& strip : strips) {
            const std::size_t first = strip.steps.front().segment;
            const std::size_t last = strip.steps.back().segment;
            const bool closed = (segment(first).tag & LA_TAG_CLOSED) != 0;
            strip.open_start = !closed && segment(first).from_start == 0;
            strip.open_end = !closed && segment(last).to_end == 0;
            strip.closed = closed && segment(first).from_start == 0 && segment(last).to_end == 0 &&
                           connected(last, first);
            strip.start_arc = screen(first).p.arc;
        }
        return strips;
    }

    void add_silhouettes(std::vector<Strip>& strips) {
        std::vector<std::uint32_t> silhouettes;
        for (std::uint32_t i = 0; i < owns_.size(); ++i) {
            if (kind_of(i) != LA_KIND_SILHOUETTE) continue;
            const bool contour = is_contour(lines_, pieces_.list[owns_[i].first].segment);
            const ScreenSegment& seen = screen(i);
            edges_.push_back({.p = contour ? contour_node(seen.end_p, seen.p)
                                           : node(node_of_vertex_, segment(i).p, seen.p),
                              .q = contour ? contour_node(seen.end_q, seen.q)
                                           : node(node_of_vertex_, segment(i).q, seen.q),
                              .kind = LA_KIND_SILHOUETTE});
            // Beside a corner of the mesh a contour may have a piece of no length.
            if (contour && edges_.back().p == edges_.back().q)
                edges_.pop_back();
            else
                silhouettes.push_back(i);
        }
        for (const Chain& chain : chain_edges(nodes_, edges_, silhouette_chain_angle)) {
            Strip& strip = strips.emplace_back();
            for (const ChainStep step : chain.steps) {
                add_step(strip, silhouettes[step.edge], step.reversed);
            }
            strip.closed = chain.closed;
            strip.open_start = strip.open_end = !chain.closed;
            strip.start_arc = -0.5 * strip.length;
        }
    }

    using Nodes = std::unordered_map<std::uint64_t, std::uint32_t>;

    std::uint32_t add_node(const VectorPoint& point) {
        nodes_.emplace_back(static_cast<float>(point.at.x), static_cast<float>(point.at.y), 0.0F);
        return static_cast<std::uint32_t>(nodes_.size() - 1);
    }

    std::uint32_t node(Nodes& nodes, std::uint64_t name, const VectorPoint& point) {
        const auto [known, is_new] = nodes.emplace(name, 0);
        if (is_new) known->second = add_node(point);
        return known->second;
    }

    /// The node at an end of a contour. Each contour ends at a tip.
    std::uint32_t contour_node(std::uint64_t name, const VectorPoint& point) {
        if (tips_.contains(as_array(glm::vec3{point.world}))) return add_node(point);
        constexpr double same_depth = 1e-5;
        const auto [first, last] = nodes_of_end_.equal_range(name);
        for (auto known = first; known != last; ++known)
            if (std::abs(known->second.depth - point.depth) < same_depth) return known->second.node;
        const std::uint32_t fresh = add_node(point);
        nodes_of_end_.emplace(name, NodeAtDepth{point.depth, fresh});
        return fresh;
    }

    static std::array<float, 3> as_array(glm::vec3 at) { return {at.x, at.y, at.z}; }

    /// Adds a step. Until the strip is finished, the step's segment is an index into `owns_`.
    void add_step(Strip& strip, std::uint32_t own, bool reversed) const {
        const Piece& piece = pieces_.list[owns_[own].first];
        strip.steps.push_back(
            {.segment = own, .screen = piece.screen, .reversed = reversed, .start = strip.length});
        strip.length += screen(own).length;
    }

    void finish(Strip& strip) const {
        const std::size_t first = strip.steps.front().segment;
        strip.kind = static_cast<LineKind>(kind_of(first));
        strip.path = segment(first).path;
        for (StripStep& step : strip.steps) {
            const Own own = owns_[step.segment];
            step.segment = pieces_.list[own.first].segment;
            for (std::uint32_t k = 0; k < own.end - own.first; ++k) {
                const std::uint32_t i = step.reversed ? own.end - 1 - k : own.first + k;
                add_stretch(strip, step, pieces_.list[i]);
            }
        }
        drop_flickers(strip);
    }

    void add_stretch(Strip& strip, const StripStep& step, const Piece& piece) const {
        const double length = pieces_.segment_of(piece).length;
        const PieceEnd& start = step.reversed ? piece.end : piece.start;
        const PieceEnd& end = step.reversed ? piece.start : piece.end;
        const auto place = [&](double t) {
            return step.start + (step.reversed ? 1 - t : t) * length;
        };
        Stroke stroke{.from = place(start.t),
                      .to = place(end.t),
                      .visible = piece.visible,
                      .alpha = piece.alpha};
        stroke.start_kind = end_kind(strip, start.kind, stroke.from <= 0, strip.open_start);
        stroke.end_kind = end_kind(strip, end.kind, stroke.to >= strip.length, strip.open_end);
        strip.strokes.push_back(stroke);
    }

    static std::uint32_t end_kind(const Strip& strip, std::uint32_t kind, bool at_strip_end,
                                  bool open) {
        if (!at_vertex(kind)) return kind;
        if (!at_strip_end || strip.closed) return LA_END_HIDDEN; // unless the next stroke goes on
        return open ? LA_END_PATH : LA_END_CLIPPED;
    }

    static void drop_flickers(Strip& strip) {
        join_neighbours(strip);
        std::erase_if(strip.strokes, [](const Stroke& one) { return one.length() < shortest; });
        join_neighbours(strip);
    }

    /// Joins neighbouring strokes that are both visible or both hidden.
    static void join_neighbours(Strip& strip) {
        std::vector<Stroke> joined;
        for (const Stroke& stroke : strip.strokes) {
            const bool goes_on = !joined.empty() && joined.back().visible == stroke.visible &&
                                 stroke.from - joined.back().to < same_place;
            if (goes_on) {
                extend(joined.back(), stroke);
            } else {
                joined.push_back(stroke);
            }
        }
        strip.strokes = std::move(joined);
    }

    static void extend(Stroke& stroke, const Stroke& next) {
        const auto length = static_cast<float>(stroke.length());
        const auto next_length = static_cast<float>(next.length());
        if (length + next_length > 0)
            stroke.alpha =
                (stroke.alpha * length + next.alpha * next_length) / (length + next_length);
        stroke.to = next.to;
        stroke.end_kind = next.end_kind;
    }

    const LineSet& lines_;
    const Pieces& pieces_;
    std::vector<Own> owns_; ///< per segment that has pieces
    std::vector<ChainEdge> edges_;
    std::vector<glm::vec3> nodes_;
    Nodes node_of_vertex_;
    /// Nodes that are one behind the other have the same name, and differ in depth.
    struct NodeAtDepth {
        double depth;
        std::uint32_t node;
    };
    std::unordered_multimap<std::uint64_t, NodeAtDepth> nodes_of_end_;
    std::set<std::array<float, 3>> tips_; ///< their places
};

} // namespace

std::vector<Strip> make_strips(const LineSet& lines, const Pieces& pieces) {
    return StripMaker{lines, pieces}.make();
}

} // namespace lineatlas
