#include "chaining.hpp"

#include <algorithm>
#include <numbers>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "core/chain.hpp"

namespace lineatlas {
namespace {

/// A piece counts as at least this long for the mean visibility, pixels.
constexpr double least_weight = 0.01;
/// Silhouettes of fine meshes zigzag: they go on through all but the sharpest turns.
constexpr float silhouette_chain_angle = 150.0F * std::numbers::pi_v<float> / 180;

/// Consecutive pieces of a path that are drawn in one go.
struct Run {
    std::vector<std::uint32_t> pieces; ///< along the path
    bool closed = false;
};

struct RunStep {
    std::uint32_t run;
    bool reversed;
};

class Chaining {
  public:
    Chaining(const LineSet& lines, const Pieces& pieces) : lines_(lines), pieces_(pieces) {}

    std::vector<VectorPath> chain() {
        find_runs();
        std::vector<VectorPath> paths;
        for (std::uint32_t r = 0; r < runs_.size(); ++r) {
            if (!is_silhouette(r)) paths.push_back(make_path({{r, false}}, runs_[r].closed));
        }
        chain_silhouettes(paths);
        return paths;
    }

  private:
    const Piece& piece(std::uint32_t i) const { return pieces_.list[i]; }
    const Piece& first_of(const Run& run) const { return piece(run.pieces.front()); }
    const Piece& last_of(const Run& run) const { return piece(run.pieces.back()); }
    const Segment& segment_of(const Piece& piece) const { return lines_.segments[piece.segment]; }
    std::uint32_t kind_of(const Piece& piece) const {
        return segment_of(piece).tag & LA_TAG_KIND_MASK;
    }
    bool is_silhouette(std::uint32_t run) const {
        return kind_of(first_of(runs_[run])) == LA_KIND_SILHOUETTE;
    }

    bool continues(const Piece& a, const Piece& b) const {
        return a.visible == b.visible && goes_on(lines_, pieces_, a, b);
    }

    void find_runs() {
        std::size_t first_of_path = 0;
        for (std::uint32_t i = 0; i < pieces_.list.size(); ++i) {
            if (!runs_.empty() &&
                segment_of(last_of(runs_.back())).path != segment_of(piece(i)).path) {
                close_path(first_of_path);
                first_of_path = runs_.size();
            }
            if (runs_.size() == first_of_path || !continues(last_of(runs_.back()), piece(i))) {
                runs_.emplace_back();
            }
            runs_.back().pieces.push_back(i);
        }
        close_path(first_of_path);
    }

    /// Joins the last run of a closed path to its first one where both are drawn at the seam.
    void close_path(std::size_t first_of_path) {
        if (first_of_path == runs_.size()) return;
        Run& head = runs_[first_of_path];
        Run& tail = runs_.back();
        const Segment& first = segment_of(first_of(head));
        const Segment& last = segment_of(last_of(tail));
        const bool at_seam = (first.tag & LA_TAG_CLOSED) != 0 && first.from_start == 0 &&
                             last.to_end == 0 && continues(last_of(tail), first_of(head));
        if (!at_seam) return;
        if (&head == &tail) {
            head.closed = true;
            return;
        }
        tail.pieces.insert(tail.pieces.end(), head.pieces.begin(), head.pieces.end());
        head = std::move(tail);
        runs_.pop_back();
    }

    void chain_silhouettes(std::vector<VectorPath>& paths) {
        std::vector<std::uint32_t> silhouettes;
        for (std::uint32_t r = 0; r < runs_.size(); ++r) {
            if (!is_silhouette(r)) continue;
            silhouettes.push_back(r);
            const Run& run = runs_[r];
            edges_.push_back({.p = node(first_of(run), false),
                              .q = node(last_of(run), true),
                              .kind = first_of(run).visible ? 1U : 0U});
        }
        for (const Chain& chain : chain_edges(nodes_, edges_, silhouette_chain_angle)) {
            std::vector<RunStep> steps;
            steps.reserve(chain.steps.size());
            for (const ChainStep step : chain.steps) {
                steps.push_back({silhouettes[step.edge], step.reversed});
            }
            paths.push_back(make_path(steps, chain.closed));
            centre_arcs(paths.back());
        }
    }

    /// One for all ends at a vertex of the mesh, one of its own for every other end.
    std::uint32_t node(const Piece& piece, bool at_end) {
        const PieceEnd& end = at_end ? piece.end : piece.start;
        const auto fresh = static_cast<std::uint32_t>(nodes_.size());
        if (at_vertex(end.kind)) {
            const Segment& segment = segment_of(piece);
            const auto [known, is_new] =
                node_of_vertex_.emplace(at_end ? segment.q : segment.p, fresh);
            if (!is_new) return known->second;
        }
        const glm::dvec2 at = pieces_.point(piece, end.t).at;
        nodes_.emplace_back(static_cast<float>(at.x), static_cast<float>(at.y), 0.0F);
        return fresh;
    }

    VectorPath make_path(const std::vector<RunStep>& steps, bool closed) const {
        const Piece& first = first_of(runs_[steps.front().run]);
        VectorPath path{.kind = static_cast<LineKind>(kind_of(first)),
                        .visible = first.visible,
                        .closed = closed,
                        .points = {},
                        .pieces = {}};
        double length = 0;
        double alpha_length = 0;
        const auto add = [&](std::uint32_t i, bool reversed) {
            append(path, piece(i), reversed);
            const double own = std::max(pieces_.length(piece(i)), least_weight);
            length += own;
            alpha_length += own * static_cast<double>(piece(i).alpha);
        };
        for (const RunStep step : steps) {
            const std::vector<std::uint32_t>& own = runs_[step.run].pieces;
            for (std::size_t k = 0; k < own.size(); ++k) {
                add(step.reversed ? own[own.size() - 1 - k] : own[k], step.reversed);
            }
        }
        path.alpha = static_cast<float>(alpha_length / length);
        // Bit by bit, whatever rounding made of it.
        if (closed) path.points.back().at = path.points.front().at;
        return path;
    }

    void append(VectorPath& path, const Piece& piece, bool reversed) const {
        if (path.points.empty()) {
            path.points.push_back(reversed ? pieces_.end(piece) : pieces_.start(piece));
        }
        VectorPiece tag{.point = static_cast<std::uint32_t>(path.points.size() - 1),
                        .segment = piece.segment};
        if (piece.segment < lines_.sources.size()) tag.source = lines_.sources[piece.segment];
        if (reversed) std::swap(tag.source.from, tag.source.to);
        path.pieces.push_back(tag);
        path.points.push_back(reversed ? pieces_.start(piece) : pieces_.end(piece));
    }

    /// A chain of silhouettes has an arc length of its own.
    static void centre_arcs(VectorPath& path) {
        double length = 0;
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            length += glm::distance(path.points[i - 1].at, path.points[i].at);
        }
        double arc = -0.5 * length;
        path.points.front().arc = arc;
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            arc += glm::distance(path.points[i - 1].at, path.points[i].at);
            path.points[i].arc = arc;
        }
    }

    const LineSet& lines_;
    const Pieces& pieces_;
    std::vector<Run> runs_;
    std::vector<ChainEdge> edges_;
    std::vector<glm::vec3> nodes_;
    std::unordered_map<std::uint32_t, std::uint32_t> node_of_vertex_;
};

} // namespace

std::vector<VectorPath> chain_pieces(const LineSet& lines, const Pieces& pieces) {
    return Chaining{lines, pieces}.chain();
}

} // namespace lineatlas
