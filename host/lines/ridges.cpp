#include "ridges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "core/pair_key.hpp"
#include "curvature.hpp"
#include "diagonal.hpp"
#include "place_grid.hpp"

namespace lineatlas {
namespace {

/// A scale at which folds are found, as wide as the surface is smoothed.
struct Scale {
    float edges; ///< to what normals are smoothed
    float least; ///< strength somewhere along a line, radians
};
constexpr std::array<Scale, 2> scales{{{1, 0.5F}, {2.5F, 0.4F}}}; ///< fine ones first
constexpr float ridge_factor = 1.3F;   ///< furrows are seen before crests
constexpr float weak_share = 1 / 3.0F; ///< of the least strength; a line that has begun goes on
                                       ///< down to this
constexpr float least_bend = 2.2F;     ///< strength times length, in deviations
constexpr double least_length = 0.01;  ///< of the model's diagonal
constexpr float most_strength = 1.5F;  ///< that counts, radians

// The roughness mask. A line must be stronger than the bends about it.
constexpr float roughness_factor = 2.4F;
constexpr float roughness_reach = 6;      ///< deviations
constexpr std::size_t roughness_step = 4; ///< every so many triangles are asked

constexpr float same_line =
    1.2F; ///< deviations: a coarser line this near to a finer one is the same
constexpr float beside_edge =
    2.5F; ///< edges: a line this near to one that is drawn anyway is the same
constexpr float along_line = 0.7F; ///< deviations: an edge this near to a line says the same

constexpr int straightening_rounds = 10;
constexpr float most_shift = 0.6F; ///< deviations, by straightening

/// √(2π): a fold's curvature is a Gaussian of its angle across it, whose second derivative at the
/// crest is the angle over √(2π)·σ³.
constexpr float root_two_pi = 2.5066283F;
/// The factor by which the kernel of Diffusion is more pointed than a Gaussian there.
constexpr float pointedness = 1.5F;

/// Curvature in the form for ridges. For valleys it is the least curvature with its sign changed.
struct Field {
    LineKind kind;
    const PrincipalCurvature& own;
    const PrincipalCurvature& other;
    float sign;

    float k(std::uint32_t v) const { return sign * own.k[v]; }
    glm::vec3 gradient(std::uint32_t v) const { return sign * own.gradient[v]; }
    float slope(std::uint32_t v) const { return sign * own.slope[v]; }
    /// How much more the surface bends this way than the other way.
    float lead(std::uint32_t v) const { return k(v) - std::abs(other.k[v]); }
};

/// Slopes at the corners of a triangle, along one direction.
struct FaceSlopes {
    glm::vec3 slopes;
    glm::vec3 way;
};

std::optional<FaceSlopes> slopes_of(const Field& field, glm::uvec3 t) {
    const glm::vec3 a = field.own.way[t.x], b = field.own.way[t.y], c = field.own.way[t.z];
    const float of_b = glm::dot(a, b) < 0 ? -1.0F : 1.0F, of_c = glm::dot(a, c) < 0 ? -1.0F : 1.0F;
    if (of_b * of_c * glm::dot(b, c) < 0) return {}; // the direction turns all around
    return FaceSlopes{
        .slopes = {field.slope(t.x), of_b * field.slope(t.y), of_c * field.slope(t.z)},
        .way = a + of_b * b + of_c * c};
}

bool changes_sign(glm::vec3 v) {
    return (v.x < 0) != (v.y < 0) || (v.x < 0) != (v.z < 0);
}

/// The share of the way from one corner to another at which a slope is zero.
float zero_between(float a, float b) {
    return a / (a - b);
}

/// A piece of a line in a triangle.
struct Piece {
    EdgePlace p, q;
    std::uint32_t face;
    float strength;
};

EdgePlace place_between(std::uint32_t from, std::uint32_t to, double share) {
    if (from < to) return {from, to, share};
    return {to, from, 1 - share};
}

/// A line of pieces, each of which begins where the last one ended.
struct Path {
    std::vector<EdgePlace> points;
    std::vector<std::uint32_t> faces;
    std::vector<float> strengths; ///< of faces
    bool closed = false;
};

/// Joins pieces that meet on an edge.
class PathMaker {
  public:
    explicit PathMaker(std::span<const Piece> pieces) : pieces_(pieces), ends_(2 * pieces.size()) {
        for (std::uint32_t i = 0; i < pieces.size(); ++i) {
            ends_[2 * i] = {pair_key(pieces[i].p.from, pieces[i].p.to), 2 * i};
            ends_[2 * i + 1] = {pair_key(pieces[i].q.from, pieces[i].q.to), 2 * i + 1};
        }
        std::ranges::sort(ends_);
        match_ends();
    }

    std::vector<Path> paths() {
        std::vector<Path> result;
        for (std::uint32_t end = 0; end < across_.size(); ++end) // open ones from their ends
            if (across_[end] == none && !used_[end / 2]) result.push_back(walk(end));
        for (std::uint32_t end = 0; end < across_.size(); end += 2)
            if (!used_[end / 2]) result.push_back(walk(end));
        return result;
    }

  private:
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    /// An end is 2 i of a piece's p, 2 i + 1 of its q.
    void match_ends() {
        across_.assign(ends_.size(), none);
        used_.assign(pieces_.size(), false);
        for (std::size_t i = 0; i + 1 < ends_.size(); ++i) {
            const bool pair = ends_[i].first == ends_[i + 1].first;
            if (!pair) continue;
            across_[ends_[i].second] = ends_[i + 1].second;
            across_[ends_[i + 1].second] = ends_[i].second;
            ++i;
        }
    }

    const EdgePlace& place(std::uint32_t end) const {
        const Piece& piece = pieces_[end / 2];
        return end % 2 == 0 ? piece.p : piece.q;
    }

    Path walk(std::uint32_t start) {
        Path path;
        path.points.push_back(place(start));
        std::uint32_t end = start;
        while (true) {
            const Piece& piece = pieces_[end / 2];
            used_[end / 2] = true;
            path.faces.push_back(piece.face);
            path.strengths.push_back(piece.strength);
            path.points.push_back(place(end ^ 1U));
            const std::uint32_t next = across_[end ^ 1U];
            path.closed = next == start;
            if (next == none || used_[next / 2]) return path;
            end = next;
        }
    }

    std::span<const Piece> pieces_;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> ends_;
    std::vector<std::uint32_t> across_; ///< per end the one that it meets
    std::vector<bool> used_;
};

Path part_of(const Path& path, std::size_t first, std::size_t end) {
    const auto cut = [&](const auto& values, std::size_t last) {
        return std::decay_t<decltype(values)>(values.begin() + static_cast<std::ptrdiff_t>(first),
                                              values.begin() + static_cast<std::ptrdiff_t>(last));
    };
    return {.points = cut(path.points, end + 1),
            .faces = cut(path.faces, end),
            .strengths = cut(path.strengths, end),
            .closed = path.closed && first == 0 && end == path.faces.size()};
}

/// Calls `each` with every stretch of pieces for which `keeps` is true, as a path of its own.
template <class Keeps, class Each>
void for_each_stretch(const Path& path, const Keeps& keeps, const Each& each) {
    std::size_t first = 0;
    for (std::size_t i = 0; i <= path.faces.size(); ++i) {
        if (i < path.faces.size() && keeps(i)) continue;
        if (i > first) each(part_of(path, first, i));
        first = i + 1;
    }
}

/// Finds the lines of one scale after the other.
class RidgeFinder {
  public:
    RidgeFinder(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                std::span<const std::uint32_t> faces)
        : mesh_(mesh), faces_(faces), surface_(mesh, edges, faces),
          least_length_(static_cast<float>(least_length * diagonal_of(mesh.vertices))) {}

    void leave_out_beside(const std::vector<MeshEdge>& edges, const std::vector<bool>& drawn) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            if (!drawn[i]) continue;
            const glm::vec3 p = mesh_.vertices[edges[i].p], q = mesh_.vertices[edges[i].q];
            const float reach = beside_edge * glm::distance(p, q);
            for (const float share : {0.0F, 0.5F, 1.0F}) taken_.add(p + share * (q - p), reach);
        }
    }

    FoundRidges find(const std::vector<MeshEdge>& edges, const std::vector<bool>& may_go) {
        for (const Scale& scale : scales) find_at(scale);
        std::vector<bool> said(edges.size(), false);
        for (std::size_t i = 0; i < edges.size(); ++i) said[i] = may_go[i] && runs_along(edges[i]);
        return {std::move(found_), std::move(said)};
    }

  private:
    void find_at(const Scale& scale) {
        surface_.smooth_to(scale.edges);
        deviation_ = surface_.deviation();
        const Curvatures curvatures = surface_.curvatures();
        const Field ridges{LineKind::ridge, curvatures.most, curvatures.least, 1};
        const Field valleys{LineKind::valley, curvatures.least, curvatures.most, -1};
        find_roughness(ridges, valleys);
        std::vector<Path> paths;
        for (const Field* field : {&valleys, &ridges}) {
            const float least = scale.least * (field->kind == LineKind::ridge ? ridge_factor : 1);
            for (Path& path : paths_of(*field, least)) {
                straighten(path);
                found_.push_back({field->kind, std::move(path.points), std::move(path.faces)});
            }
        }
        for (; taken_of_ < found_.size(); ++taken_of_) take(found_[taken_of_]);
    }

    /// The angle, in radians, of a sharp fold that would bend as much there; below 0 if a line
    /// there would be one of least curvature.
    float strength(const Field& field, std::uint32_t face, glm::vec3 along) const {
        const float squared = glm::dot(along, along);
        if (!(squared > 0)) return 0;
        const glm::uvec3 t = mesh_.triangles[face];
        const glm::vec3 slopes{glm::dot(field.gradient(t.x), along),
                               glm::dot(field.gradient(t.y), along),
                               glm::dot(field.gradient(t.z), along)};
        return -glm::dot(surface_.gradient(face, slopes), along) / squared *
               (root_two_pi / pointedness * deviation_ * deviation_ * deviation_);
    }

    glm::vec3 middle(std::uint32_t face) const {
        const glm::uvec3 t = mesh_.triangles[face];
        return (mesh_.vertices[t.x] + mesh_.vertices[t.y] + mesh_.vertices[t.z]) / 3.0F;
    }

    /// Finds the mean bend about every triangle, in cells.
    void find_roughness(const Field& ridges, const Field& valleys) {
        roughness_.start(roughness_reach * deviation_);
        for (std::size_t i = 0; i < faces_.size(); i += roughness_step) {
            const std::uint32_t face = faces_[i];
            const glm::uvec3 t = mesh_.triangles[face];
            const Field& field = ridges.k(t.x) > valleys.k(t.x) ? ridges : valleys;
            const std::optional<FaceSlopes> at = slopes_of(field, t);
            const glm::vec3 a = mesh_.vertices[t.x];
            const glm::vec3 normal = glm::cross(mesh_.vertices[t.y] - a, mesh_.vertices[t.z] - a);
            const float bend =
                at ? std::min(std::abs(strength(field, face, at->way)), most_strength) : 0;
            roughness_.add(middle(face), bend, std::sqrt(glm::dot(normal, normal)));
        }
    }

    std::vector<Path> paths_of(const Field& field, float least) {
        std::vector<Path> kept;
        for (const Path& path : PathMaker{pieces_of(field, least)}.paths()) {
            const Path even = evened(path);
            for_each_stretch(
                even, [&](std::size_t i) { return even.strengths[i] >= weak_share * least; },
                [&](const Path& strong) {
                    for_each_stretch(
                        strong, [&](std::size_t i) { return !is_taken(strong, i); },
                        [&](Path&& free) {
                            if (is_line(free, least)) kept.push_back(std::move(free));
                        });
                });
        }
        return kept;
    }

    std::vector<Piece> pieces_of(const Field& field, float least) {
        std::vector<Piece> pieces = joined(made_of_pieces<std::vector<Piece>>(
            faces_.size(), usual_piece, [&](std::size_t first, std::size_t end) {
                std::vector<Piece> own;
                for (const std::uint32_t face : faces_.subspan(first, end - first))
                    if (const auto piece = piece_in(field, face, least)) own.push_back(*piece);
                return own;
            }));
        for (Piece& piece : pieces) {
            const float rough = roughness_factor * roughness_.about(middle(piece.face));
            if (rough > least) piece.strength *= least / rough;
        }
        return pieces;
    }

    std::optional<Piece> piece_in(const Field& field, std::uint32_t face, float least) const {
        const glm::uvec3 t = mesh_.triangles[face];
        if (!(std::max({field.lead(t.x), field.lead(t.y), field.lead(t.z)}) > 0)) return {};
        const std::optional<FaceSlopes> at = slopes_of(field, t);
        if (!at || !changes_sign(at->slopes)) return {};
        const float strong = std::min(strength(field, face, at->way), most_strength);
        if (strong < 0.5F * weak_share * least) return {};
        return piece_of(field, face, *at, strong);
    }

    std::optional<Piece> piece_of(const Field& field, std::uint32_t face, const FaceSlopes& at,
                                  float strong) const {
        const glm::uvec3 t = mesh_.triangles[face];
        std::array<EdgePlace, 2> ends{};
        float lead = 0;
        int count = 0;
        for (int k = 0; k < 3; ++k) {
            const int next = (k + 1) % 3;
            const float a = at.slopes[k], b = at.slopes[next];
            if ((a < 0) == (b < 0)) continue;
            const float share = zero_between(a, b);
            ends.at(static_cast<std::size_t>(count++)) = place_between(t[k], t[next], share);
            lead += field.lead(t[k]) * (1 - share) + field.lead(t[next]) * share;
        }
        if (!(lead > 0)) return {};
        return Piece{ends[0], ends[1], face, strong};
    }

    glm::vec3 at(const EdgePlace& place) const {
        return glm::mix(mesh_.vertices[place.from], mesh_.vertices[place.to],
                        static_cast<float>(place.share));
    }

    /// The path with strengths that are means over a deviation to either side, because strengths of
    /// single triangles jump.
    Path evened(Path path) const {
        const std::size_t count = path.faces.size();
        std::vector<float> lengths(count);
        for (std::size_t i = 0; i < count; ++i)
            lengths[i] = glm::distance(at(path.points[i]), at(path.points[i + 1]));
        std::vector<float> means(count);
        for (std::size_t i = 0; i < count; ++i) {
            float sum = lengths[i] * path.strengths[i], weight = lengths[i];
            for (const int way : {-1, 1}) {
                float gone = 0.5F * lengths[i];
                for (std::size_t k = next_of(i, way, path);
                     k != i && k < count && gone < deviation_; k = next_of(k, way, path)) {
                    sum += lengths[k] * path.strengths[k];
                    weight += lengths[k];
                    gone += lengths[k];
                }
            }
            means[i] = weight > 0 ? sum / weight : path.strengths[i];
        }
        path.strengths = std::move(means);
        return path;
    }

    /// The piece after or before another one; no piece beyond the ends of an open path.
    static std::size_t next_of(std::size_t i, int way, const Path& path) {
        const std::size_t count = path.faces.size();
        if (way > 0) return i + 1 < count ? i + 1 : path.closed ? 0 : count;
        return i > 0 ? i - 1 : path.closed ? count - 1 : count;
    }

    bool is_line(const Path& path, float least) const {
        float strongest = 0, bend = 0, length = 0;
        for (std::size_t i = 0; i < path.faces.size(); ++i) {
            const float step = glm::distance(at(path.points[i]), at(path.points[i + 1]));
            strongest = std::max(strongest, path.strengths[i]);
            bend += path.strengths[i] * step / deviation_;
            length += step;
        }
        return strongest >= least && bend >= least_bend && length >= least_length_;
    }

    bool is_taken(const Path& path, std::size_t i) const {
        return taken_.near(0.5F * (at(path.points[i]) + at(path.points[i + 1])));
    }

    void take(const Ridge& ridge) {
        for (const EdgePlace& point : ridge.points) {
            taken_.add(at(point), same_line * deviation_);
            along_.add(at(point), along_line * deviation_);
        }
    }

    bool runs_along(const MeshEdge& edge) const {
        return along_.near(mesh_.vertices[edge.p]) && along_.near(mesh_.vertices[edge.q]);
    }

    /// Moves points a little along their edges to where the line bends least.
    void straighten(Path& path) const {
        const std::size_t count = path.points.size();
        const std::vector<EdgePlace> given = path.points;
        for (int round = 0; round < straightening_rounds; ++round) {
            const std::vector<EdgePlace> last = path.points;
            for (std::size_t i = path.closed ? 0 : 1; i + 1 < count; ++i) {
                const glm::vec3 before = at(last[i > 0 ? i - 1 : count - 2]);
                move(path.points[i], before, at(last[i + 1]), given[i], most_shift * deviation_);
            }
            if (path.closed) path.points.back() = path.points.front();
        }
    }

    void move(EdgePlace& place, glm::vec3 before, glm::vec3 after, const EdgePlace& given,
              float reach) const {
        const glm::vec3 p = mesh_.vertices[place.from];
        const glm::vec3 along = mesh_.vertices[place.to] - p;
        const glm::vec3 now = at(place);
        const float length = std::sqrt(glm::dot(along, along));
        const float to_before = glm::distance(before, now), to_after = glm::distance(now, after);
        if (!(length > 0) || !(to_before + to_after > 0)) return;
        const glm::vec3 middle = (before * to_after + after * to_before) / (to_before + to_after);
        const double wanted = glm::dot(middle - p, along) / (length * length);
        const double most = reach / length;
        const double share = 0.5 * (place.share + wanted);
        place.share =
            std::clamp(std::clamp(share, given.share - most, given.share + most), 0.0, 1.0);
    }

    const WeldedMesh& mesh_;
    std::span<const std::uint32_t> faces_;
    SmoothedSurface surface_;
    float least_length_;
    float deviation_ = 0; ///< of the scale
    MeanGrid roughness_;
    PlaceGrid taken_; ///< where lines are already
    PlaceGrid along_; ///< places along the lines that were found
    std::vector<Ridge> found_;
    std::size_t taken_of_ = 0; ///< lines of found_ that are in taken_
};

} // namespace

FoundRidges find_ridges(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                        std::span<const std::uint32_t> faces, const std::vector<bool>& drawn,
                        const std::vector<bool>& may_go) {
    if (faces.empty()) return {};
    RidgeFinder finder{mesh, edges, faces};
    finder.leave_out_beside(edges, drawn);
    return finder.find(edges, may_go);
}

} // namespace lineatlas
