#include "lineatlas/lines.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "added_vertices.hpp"
#include "base/parallel.hpp"
#include "buried_faces.hpp"
#include "centre_lines.hpp"
#include "contours.hpp"
#include "core/contact.hpp"
#include "core/host_clock.hpp"
#include "core/pair_key.hpp"
#include "core/progress.hpp"
#include "cracks.hpp"
#include "diagonal.hpp"
#include "edges.hpp"
#include "flat_creases.hpp"
#include "intersections.hpp"
#include "islands.hpp"
#include "known_edges.hpp"
#include "line_set_builder.hpp"
#include "lineatlas/error.hpp"
#include "lying_faces.hpp"
#include "noisy_creases.hpp"
#include "parts.hpp"
#include "ridges.hpp"
#include "seams.hpp"
#include "surface/round_surface.hpp"
#include "t_junctions.hpp"
#include "tangent_edges.hpp"
#include "triangle_groups.hpp"
#include "triangle_tree.hpp"
#include "undesigned_faces.hpp"
#include "weld.hpp"

namespace lineatlas {
namespace {

void check_angle(const char* name, float angle) {
    constexpr float most = std::numbers::pi_v<float> * 1.000001F; // of 180 degrees in floats
    if (angle >= 0 && angle <= most) return;                      // NaN is not
    throw UsageError("lines: " + std::string{name} + " must be from 0 to pi radians, not " +
                     std::to_string(angle));
}

LineKind kind_of(PolylineKind kind) {
    switch (kind) {
    case PolylineKind::section:
        return LineKind::section;
    case PolylineKind::hatching:
        return LineKind::hatching;
    case PolylineKind::trail:
        return LineKind::trail;
    case PolylineKind::file:
        break;
    }
    return LineKind::file;
}

/// The segments of the polylines that are wanted, each once.
std::vector<Line> lines_of_polylines(const WeldedMesh& mesh, LineKindMask kinds,
                                     std::unordered_map<std::uint64_t, std::size_t>& line_of_edge) {
    std::vector<Line> lines;
    for (std::size_t k = 0; k < mesh.polylines.size(); ++k) {
        const LineKind kind = kind_of(mesh.polyline_kinds[k]);
        if ((kinds & mask_of(kind)) == 0) continue;
        const std::vector<std::uint32_t>& polyline = mesh.polylines[k];
        const std::vector<std::uint32_t>& sources = mesh.polyline_sources[k];
        for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
            const std::uint64_t key = pair_key(polyline[i], polyline[i + 1]);
            if (!line_of_edge.emplace(key, lines.size()).second) continue;
            lines.push_back({.p = polyline[i],
                             .q = polyline[i + 1],
                             .kind = kind,
                             .source = {.from = sources[i], .to = sources[i + 1]}});
        }
    }
    return lines;
}

/// The edge from p to q of a welded triangle, in the mesh that was welded.
LineSource triangle_edge(const Mesh& mesh, const WeldedMesh& welded, std::uint32_t face,
                         std::uint32_t p, std::uint32_t q) {
    const glm::uvec3 corners = welded.triangles[face];
    LineSource result{.triangle = welded.triangle_source[face]};
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t position =
            mesh.triangles[result.triangle][welded.source_corner(face, i)];
        if (corners[i] == p) result.from = position;
        if (corners[i] == q) result.to = position;
    }
    return result;
}

double milliseconds_since(std::int64_t start) {
    return 1e-6 * static_cast<double>(host_nanoseconds() - start);
}

/// An edge that bends more is drawn as a crease, and not as the ridge that runs along it.
constexpr double sharp_crease = std::numbers::pi / 3;

/// How far apart parts of one island may lie, as a share of the model's diagonal: farther than what
/// lies between parts reaches. The farthest are lines that double an intersection.
constexpr double island_reach = 1.25e-3;

enum class ListOfLines : std::uint8_t { fixed, candidates, replaced };

/// From a mesh to its lines, step by step.
class Extraction {
  public:
    Extraction(const Mesh& mesh, const LineOptions& options, const Progress& progress)
        : mesh_(mesh), options_(options), done_(started(progress)),
          objects_(options.separate_objects ? find_objects(mesh) : MeshObjects{}),
          welded_(weld(mesh, objects_)), edges_(mesh_edges(welded_)) {
        const bool mends = !options.crease && mesh.known_edges.empty();
        if (mends) close_gaps();
        parts_ = find_parts(welded_);
        // Where the file says how surfaces look, they do.
        if (mesh.corner_normals.empty()) turn_outwards(welded_, edges_, parts_);
        if (mends) between_bodies_ = see_lying_faces_as_one(welded_, parts_, edges_);
        first_face_.resize(edges_.size());
        for_each_index(edges_.size(), [&](std::size_t i) { first_face_[i] = edges_[i].face_a; });
        normals_ = face_normals(welded_);
        replace_slivers(welded_, normals_, edges_);
    }

    LineSet run() {
        reach(0.2F);
        // Parts of either that run on one thread run beside the other.
        do_both([&] { classify_edges(); }, [&] { find_tree(); });
        tell_copies_apart();
        reach(0.5F);
        leave_out_seams();
        reach(0.7F);
        find_undesigned();
        find_shape();
        tell_copies_apart(); // creases that went may have had bends near a limit
        do_both([&] { find_smooth_patches(); }, [&] { leave_out_buried(); });
        collect_lines();
        reach(0.8F);
        add_intersections();
        add_ridges();
        add_tangents();
        add_centres();
        reach(0.9F);
        LineSet result = assemble();
        reach(1);
        return result;
    }

  private:
    static ProgressPart started(const Progress& progress) {
        const ProgressPart all{progress, "finding lines"};
        all(0);
        return all;
    }

    /// So much is done; until more is, the same is said again, to be stopped.
    void reach(float share) {
        done_(share);
        reached_ = share;
    }

    /// Not done if a crease angle is given (then every edge counts) or the file names its edges
    /// (such files have no cracks).
    void close_gaps() {
        for (const auto& close : {close_cracks, close_t_junctions}) {
            const std::size_t closed = close(welded_, edges_);
            if (closed > 0) edges_ = mesh_edges(welded_);
            left_out_.cracks += closed;
        }
    }

    bool wanted(LineKind kind) const { return (options_.lines & mask_of(kind)) != 0; }

    void classify_edges() {
        const std::int64_t start = host_nanoseconds();
        bends_ = bends_of(edges_, normals_);
        const KnownEdges known{mesh_, welded_};
        kinds_.resize(edges_.size());
        for_each_index(edges_.size(), [&](std::size_t i) {
            kinds_[i] = known.all() || known.drawn(edges_[i])
                            ? known.classify(edges_[i], welded_, bends_[i], options_)
                            : classify(edges_[i], welded_, bends_[i], options_);
        });
        leave_out_joints();
        find_tangents(known);
        if (known.all() || options_.crease || !wanted(LineKind::crease)) return;
        const std::vector<bool> flat =
            flat_creases(welded_, parts_, edges_, bends_, normals_, kinds_);
        for (std::size_t i = 0; i < edges_.size(); ++i)
            if (flat[i]) kinds_[i] = LineKind::crease;
        const std::vector<bool> noisy = noisy_creases(welded_, parts_, edges_, bends_, kinds_);
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            if (!noisy[i] || flat[i] || known.drawn(edges_[i])) continue;
            take_crease_away(i);
            ++left_out_.noisy_creases;
        }
        times_.creases = milliseconds_since(start);
    }

    /// The edge is whatever it is besides.
    void take_crease_away(std::size_t i) {
        const LineOptions others{.lines = options_.lines & ~mask_of(LineKind::crease)};
        kinds_[i] = classify(edges_[i], welded_, bends_[i], others);
    }

    /// Where bodies of one material meet in one plane, no line is seen.
    void leave_out_joints() {
        if (between_bodies_.empty()) return;
        const std::vector<std::uint32_t> material = materials_of(mesh_.groups, welded_, {});
        for (const std::uint32_t i : between_bodies_) {
            const MeshEdge& edge = edges_[i];
            if (kinds_[i] == LineKind::material && bends_[i] < flat_bend &&
                material[edge.face_a] == material[edge.face_b & LA_FACE_INDEX])
                kinds_[i].reset();
        }
    }

    void find_plain_shapes() {
        if (plain_shapes_.empty())
            for (const SurfaceShape& shape : mesh_.surfaces.shapes)
                plain_shapes_.push_back(plain_shape(shape));
    }

    /// Lines besides, whatever else they are: silhouettes run there in other views.
    void find_tangents(const KnownEdges& known) {
        if (!wanted(LineKind::tangent) || options_.smooth_edges || mesh_.known_edges.empty())
            return;
        find_plain_shapes();
        tangents_ = tangent_edges(welded_, edges_, known, mesh_.surfaces, plain_shapes_);
    }

    /// Nothing passes through, or abuts on, a body that is closed and alone.
    void find_tree() {
        is_open_.assign(parts_.count, false);
        for (const MeshEdge& edge : edges_)
            if (edge.face_count == 1) is_open_[parts_.of_vertex[edge.p]] = true;
        has_parts_ = parts_.count > 1;
        if (!has_parts_ && std::ranges::find(is_open_, true) == is_open_.end()) return;
        object_of_triangle_ = objects_of(welded_);
        material_ = materials_of(mesh_.groups, welded_, object_of_triangle_);
        body_ = bodies_of(mesh_.groups, welded_, material_, parts_.of_vertex);
        find_islands();
        grow_trees(islands_ ? islands_->copied_triangles() : std::vector<bool>{});
    }

    void find_islands() {
        if (!has_parts_) return;
        const double diagonal = diagonal_of(welded_.vertices);
        const double reach =
            std::max(island_reach * diagonal, 2 * contact_of(diagonal, welded_.precision));
        const TriangleOwners owners{
            .materials = material_, .bodies = body_, .objects = object_of_triangle_};
        islands_.emplace(welded_, edges_, parts_, owners, reach);
        if (!islands_->has_copies()) islands_.reset();
    }

    /// Which lines between parts are doubled depends on the kinds of edges.
    void tell_copies_apart() {
        if (islands_ && islands_->tell_apart(kinds_)) grow_trees(islands_->copied_triangles());
    }

    /// `left_out`: triangles; may be empty.
    void grow_trees(const std::vector<bool>& left_out) {
        trees_.emplace(welded_, normals_, parts_.of_vertex, object_of_triangle_, left_out);
    }

    void leave_out_seams() {
        if (!trees_ || options_.crease) return; // with a crease angle every edge counts
        const std::int64_t start = host_nanoseconds();
        std::vector<std::uint32_t> closed_part;
        closed_part.reserve(welded_.triangles.size());
        for (const glm::uvec3& t : welded_.triangles) {
            const std::uint32_t part = parts_.of_vertex[t.x];
            closed_part.push_back(is_open_[part] ? BoxTree::nobody : part);
        }
        seams_ = find_seams(welded_, edges_, normals_, kinds_, *trees_,
                            {.material = material_, .body = body_, .closed_part = closed_part},
                            islands_ ? islands_->copied_edges() : std::vector<bool>{});
        if (islands_) islands_->add_copies(seams_);
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            if (seams_.of_edge[i]) kinds_[i].reset();
            left_out_.seams += seams_.of_edge[i] ? 1 : 0;
        }
        left_out_.cut_seams = seams_.cut.size();
        times_.seams = milliseconds_since(start);
    }

    /// A mesh whose file knows its surfaces was designed.
    void find_undesigned() {
        if (!mesh_.surfaces.empty()) return;
        undesigned_ = undesigned_faces(welded_, edges_, bends_, parts_);
    }

    void find_smooth_patches() {
        if (options_.silhouettes == Silhouettes::mesh || !wanted(LineKind::silhouette)) return;
        // Where creases are not wanted their edges are silhouettes, and part patches all the same.
        const bool by_kind = wanted(LineKind::crease);
        const double crease = options_.crease.value_or(least_crease_angle);
        const std::vector<bool> solid = solid_parts(welded_, edges_, parts_);
        smooth_ = find_contours({.mesh = welded_,
                                 .edges = edges_,
                                 .bends = bends_,
                                 .kinds = kinds_,
                                 .most_bend = by_kind ? std::numbers::pi : crease,
                                 .corner_normals = mesh_.corner_normals,
                                 .undesigned = undesigned_,
                                 .parts = parts_,
                                 .solid = solid},
                                options_.silhouettes);
        std::vector<bool> undesigned(welded_.triangles.size(), false);
        if (mesh_.corner_normals.empty()) // which say how the surface runs
            for (const std::uint32_t face : undesigned_) undesigned[face] = true;
        for (const std::uint32_t face : smooth_.faces) {
            const bool in_solid = solid[parts_.of_vertex[welded_.triangles[face].x]];
            contour_tags_.push_back((in_solid ? LA_TAG_SOLID : 0) |
                                    (undesigned[face] ? LA_TAG_UNDESIGNED : 0));
        }
    }

    void add_surfaces() {
        const KnownSurfaces& known = mesh_.surfaces;
        if (known.empty()) return;
        KnownSurfaces& own = smooth_.contours.surfaces;
        own.shapes = known.shapes;
        own.surfaces = known.surfaces;
        for (const std::uint32_t face : smooth_.faces) {
            const std::uint32_t triangle = welded_.triangle_source[face];
            std::array<glm::dvec2, 3> corners{};
            for (int k = 0; k < 3; ++k)
                corners[static_cast<std::size_t>(k)] =
                    known.parameters[triangle]
                                    [static_cast<std::size_t>(welded_.source_corner(face, k))];
            own.add_triangle(known.of_triangle[triangle], corners);
        }
    }

    /// Triangles through which silhouettes may run, as the last of the candidates.
    void add_contours() {
        add_surfaces();
        smooth_.contours.replaced = static_cast<std::uint32_t>(replaced_.size());
        candidates_.insert(candidates_.end(), replaced_.begin(), replaced_.end());
        for (const std::uint32_t face : smooth_.faces) {
            const glm::uvec3 corners = welded_.triangles[face];
            candidates_.push_back({.p = corners.x,
                                   .q = corners.y,
                                   .face_a = face,
                                   .face_b = face,
                                   .kind = LineKind::silhouette,
                                   .source = {.triangle = welded_.triangle_source[face]}});
        }
    }

    Line line_of(std::uint32_t i) const { return line_of(i, *kinds_[i]); }

    Line line_of(std::uint32_t i, LineKind kind) const {
        const MeshEdge& edge = edges_[i];
        return {.p = edge.p,
                .q = edge.q,
                .face_a = edge.face_a,
                .face_b = edge.face_b,
                .kind = kind,
                .source = triangle_edge(mesh_, welded_, first_face_[i], edge.p, edge.q)};
    }

    /// The line of `fixed_` that is the edge, if the edge is a part of a polyline; else null.
    Line* polyline_of(std::uint32_t i) {
        if (line_of_edge_.empty()) return nullptr;
        const auto found = line_of_edge_.find(pair_key(edges_[i].p, edges_[i].q));
        return found != line_of_edge_.end() ? &fixed_[found->second] : nullptr;
    }

    /// The lines that remain of each edge that is a seam in part.
    std::vector<std::vector<Line>> lines_of_cut_edges() {
        std::vector<std::vector<Line>> lines;
        auto part = seams_.left.begin();
        for (const std::uint32_t i : seams_.cut) {
            std::vector<Line>& of_edge = lines.emplace_back();
            for (; part != seams_.left.end() && part->edge == i; ++part) {
                if (!kinds_[i] || polyline_of(i) != nullptr) continue;
                Line line = line_of(i);
                line.p = added_.at(edges_[i].p, edges_[i].q, part->from);
                line.q = added_.at(edges_[i].p, edges_[i].q, part->to);
                if (line.p != line.q) of_edge.push_back(line);
            }
        }
        return lines;
    }

    /// Edges as lines of three lists; the first has those of polylines already. They are counted,
    /// then put in place.
    void collect_lines() {
        fixed_ = lines_of_polylines(welded_, options_.lines, line_of_edge_);
        const std::vector<std::vector<Line>> of_cut = lines_of_cut_edges();
        const auto list_of = [&](std::uint32_t i) {
            if (*kinds_[i] != LineKind::silhouette) return ListOfLines::fixed;
            const bool replaced = !smooth_.replaces.empty() && smooth_.replaces[i];
            return replaced ? ListOfLines::replaced : ListOfLines::candidates;
        };
        // Calls put(list, i, parts): parts of a cut edge, or nullptr.
        const auto for_lines = [&](std::size_t first, std::size_t end, const auto& put) {
            auto cut = std::ranges::lower_bound(seams_.cut, first);
            for (auto i = static_cast<std::uint32_t>(first); i < end; ++i) {
                const bool is_cut = cut != seams_.cut.end() && *cut == i;
                const std::vector<Line>* parts =
                    is_cut ? &of_cut[static_cast<std::size_t>(cut++ - seams_.cut.begin())]
                           : nullptr;
                if (!kinds_[i] || polyline_of(i) != nullptr) continue;
                put(is_cut ? ListOfLines::fixed : list_of(i), i, parts);
            }
        };
        const std::array<std::vector<Line>*, 3> lists{&fixed_, &candidates_, &replaced_};
        using Counts = std::array<std::size_t, 3>;
        std::vector<Counts> next = made_of_pieces<Counts>(
            edges_.size(), usual_piece, [&](std::size_t first, std::size_t end) {
                Counts counts{};
                for_lines(first, end, [&](ListOfLines list, std::uint32_t, const auto* parts) {
                    counts[static_cast<std::size_t>(list)] += parts != nullptr ? parts->size() : 1;
                });
                return counts;
            });
        for (std::size_t list = 0; list < lists.size(); ++list) {
            std::size_t count = lists[list]->size();
            for (Counts& counts : next) count += std::exchange(counts[list], count);
            lists[list]->resize(count);
        }
        for_each_piece(edges_.size(), usual_piece, [&](std::size_t first, std::size_t end) {
            Counts& place = next[first / usual_piece];
            for_lines(first, end, [&](ListOfLines list, std::uint32_t i, const auto* parts) {
                const auto index = static_cast<std::size_t>(list);
                const auto put = [&](const Line& line) { (*lists[index])[place[index]++] = line; };
                parts != nullptr ? static_cast<void>(std::ranges::for_each(*parts, put))
                                 : put(line_of(i));
            });
            for (auto i = static_cast<std::uint32_t>(first); i < end; ++i) {
                if (Line* polyline = polyline_of(i)) {
                    polyline->face_a = edges_[i].face_a;
                    polyline->face_b = edges_[i].face_b;
                }
            }
        });
    }

    bool has_intersections() const { return has_parts_ && wanted(LineKind::intersection); }

    void leave_out_buried() {
        if (!has_intersections()) return;
        const std::int64_t start = host_nanoseconds();
        std::vector<bool> left_out = islands_ ? islands_->copied_triangles() : std::vector<bool>{};
        const std::vector<bool> buried = buried_faces(welded_, edges_, normals_, parts_,
                                                      diagonal_of(welded_.vertices), left_out);
        if (std::ranges::find(buried, true) != buried.end()) {
            left_out.resize(buried.size(), false);
            for (std::size_t i = 0; i < buried.size(); ++i)
                if (buried[i]) left_out[i] = true;
            grow_trees(left_out);
        }
        times_.intersections = milliseconds_since(start);
    }

    /// The drawn lines of every object.
    std::vector<std::vector<DrawnLine>> drawn_lines() const {
        const auto& ends = welded_.object_ends;
        std::vector<std::vector<DrawnLine>> result(ends.size());
        for (const Line& line : fixed_) {
            if (line.p >= ends.back() || line.q >= ends.back()) continue; // a seam's
            if (islands_ && islands_->is_copy(line.p)) continue;
            const auto object = std::ranges::upper_bound(ends, line.p) - ends.begin();
            result[object].push_back({line.p, line.q});
        }
        return result;
    }

    void add_intersections() {
        if (!has_intersections()) return;
        const std::int64_t start = host_nanoseconds();
        const double diagonal = diagonal_of(welded_.vertices);
        const std::vector<std::vector<DrawnLine>> drawn = drawn_lines();
        std::vector<Intersection> found;
        for (std::size_t object = 0; object < trees_->size(); ++object) {
            std::vector<Intersection> own =
                find_intersections(welded_, normals_, (*trees_)[object], diagonal);
            drop_doubled(welded_, normals_, drawn[object], diagonal, own);
            found.insert(found.end(), own.begin(), own.end());
        }
        if (islands_) islands_->add_copies(found);
        std::ranges::sort(found, {}, [](const Intersection& one) {
            return std::pair{one.face_a, one.face_b};
        });
        for (const Intersection& one : found) {
            fixed_.push_back({.p = added_.at(one.p.from, one.p.to, one.p.share),
                              .q = added_.at(one.q.from, one.q.to, one.q.share),
                              .face_a = one.face_a,
                              .face_b = one.face_b,
                              .kind = LineKind::intersection,
                              .source = {.triangle = welded_.triangle_source[one.face_a],
                                         .crossing = welded_.triangle_source[one.face_b]}});
        }
        times_.intersections += milliseconds_since(start);
    }

    /// Where ridges and valleys run, creases say the same once more, in zigzags.
    void find_shape() {
        if ((options_.lines & LA_KINDS_OF_SHAPE) == 0 || undesigned_.empty()) return;
        const std::int64_t start = host_nanoseconds();
        const std::vector<bool> may_go = creases_by_angle();
        std::vector<bool> drawn(edges_.size(), false);
        for (std::size_t i = 0; i < edges_.size(); ++i)
            drawn[i] = kinds_[i] && *kinds_[i] != LineKind::silhouette && !may_go[i];
        FoundRidges found = find_ridges(welded_, edges_, undesigned_, drawn, may_go);
        for (std::size_t i = 0; i < found.said.size(); ++i)
            if (found.said[i] && bends_[i] < sharp_crease) take_crease_away(i);
        ridges_ = std::move(found.ridges);
        times_.ridges = milliseconds_since(start);
    }

    /// Edges that are creases by their bend alone, with no number from the user.
    std::vector<bool> creases_by_angle() const {
        std::vector<bool> found(edges_.size(), false);
        if (options_.crease) return found;
        const KnownEdges known{mesh_, welded_};
        for (std::size_t i = 0; i < edges_.size(); ++i)
            found[i] = kinds_[i] == LineKind::crease && !known.all() && !known.drawn(edges_[i]);
        return found;
    }

    void add_ridges() {
        for (const Ridge& ridge : ridges_)
            if (wanted(ridge.kind)) add_ridge(ridge);
    }

    void add_ridge(const Ridge& ridge) {
        const auto vertex = [&](const EdgePlace& place) {
            return added_.at(place.from, place.to, place.share);
        };
        for (std::size_t i = 0; i < ridge.faces.size(); ++i)
            fixed_.push_back({.p = vertex(ridge.points[i]),
                              .q = vertex(ridge.points[i + 1]),
                              .face_a = ridge.faces[i],
                              .face_b = ridge.faces[i],
                              .kind = ridge.kind,
                              .source = {.triangle = welded_.triangle_source[ridge.faces[i]]}});
    }

    void add_tangents() {
        for (const std::uint32_t i : tangents_) {
            if ((kinds_[i] && *kinds_[i] != LineKind::silhouette) || polyline_of(i) != nullptr)
                continue;
            fixed_.push_back(line_of(i, LineKind::tangent));
        }
    }

    void add_centres() {
        if (!wanted(LineKind::centre)) return;
        const std::int64_t start = host_nanoseconds();
        find_plain_shapes();
        for (const CentreLine& line : find_centre_lines(welded_, edges_, normals_, mesh_.surfaces,
                                                        plain_shapes_, objects_of(welded_)))
            fixed_.push_back({.p = added_.beside(line.vertex, line.p),
                              .q = added_.beside(line.vertex, line.q),
                              .face_a = line.face,
                              .face_b = line.is_turned ? line.face | LA_FACE_FLIPPED : line.face,
                              .kind = LineKind::centre,
                              .source = {.triangle = line.source}});
        times_.centres = milliseconds_since(start);
    }

    /// Vertices have their last numbers now; what has become a point by it, or stands twice, goes:
    /// an edge that is a line in every frame is no candidate besides. `replaced_` never are lines,
    /// whatever else stands there.
    void renumber() {
        const auto mesh_vertices = static_cast<std::uint32_t>(welded_.vertices.size());
        const std::vector<std::uint32_t> number = added_.insert();
        const std::vector<bool> is_met = ends_of_added_lines(mesh_vertices, number);
        for (std::vector<Line>* lines : {&fixed_, &candidates_, &replaced_}) {
            for_each_index(lines->size(), [&](std::size_t i) {
                (*lines)[i].p = number[(*lines)[i].p];
                (*lines)[i].q = number[(*lines)[i].q];
            });
        }
        for (ContourCorner& corner : smooth_.contours.corners)
            corner.vertex = number[corner.vertex];
        std::unordered_set<std::uint64_t> known;
        const auto goes = [&](const Line& line) {
            if (line.p == line.q) return true;
            if (line.kind == LineKind::tangent) return false; // whatever else its edge is
            return !is_met.empty() && is_met[line.p] && is_met[line.q] &&
                   !known.insert(pair_key(line.p, line.q)).second;
        };
        std::erase_if(fixed_, goes);
        std::erase_if(candidates_, goes);
    }

    /// By their last numbers; none if there are no intersections. Only such lines may stand where
    /// others do, since every edge of the mesh stands once.
    std::vector<bool> ends_of_added_lines(std::uint32_t mesh_vertices,
                                          std::span<const std::uint32_t> number) const {
        const auto is_intersection = [](const Line& line) {
            return line.kind == LineKind::intersection;
        };
        if (std::ranges::none_of(fixed_, is_intersection)) return {};
        std::vector<bool> is_end(welded_.vertices.size(), false);
        for (const Line& line : fixed_) {
            if (is_intersection(line) || std::max(line.p, line.q) >= mesh_vertices)
                is_end[number[line.p]] = is_end[number[line.q]] = true;
        }
        return is_end;
    }

    /// Frees the tables by which lines were found, which take twice the memory of the lines.
    void forget_edges() {
        const auto empty = [](auto&... each) { ((each = std::decay_t<decltype(each)>{}), ...); };
        islands_.reset();
        empty(edges_, first_face_, normals_, bends_, kinds_, parts_, trees_, object_of_triangle_,
              material_, body_, seams_, undesigned_, ridges_);
    }

    LineSet assemble() {
        renumber();
        add_contours();
        const std::size_t flat = flat_face_count(welded_, normals_);
        forget_edges();
        LineSetBuilder builder{welded_.vertices.size()};
        for (const CutVertex& cut : added_.cuts()) builder.touch(cut.vertex);
        builder.add(welded_.vertices, fixed_, candidates_, options_.chain_angle);
        LineSet result = std::move(builder.result);
        const std::size_t first_contour = result.segments.size() - contour_tags_.size();
        for (std::size_t i = 0; i < contour_tags_.size(); ++i)
            result.segments[first_contour + i].tag |= contour_tags_[i];
        result.left_out = left_out_;
        result.times = times_;
        result.odd = welded_.odd;
        result.odd.flat = flat;
        result.vertices = std::move(welded_.vertices);
        result.triangles = std::move(welded_.triangles);
        result.vertex_sources = std::move(welded_.vertex_sources);
        result.triangle_sources = std::move(welded_.triangle_source);
        result.cut_vertices = added_.cuts();
        result.contours = std::move(smooth_.contours);
        result.precision = mesh_.precision;
        for (std::size_t i = 0; i < objects_.names.size(); ++i) {
            const std::uint32_t first = i > 0 ? welded_.object_ends[i - 1] : 0;
            result.objects.push_back({objects_.names[i], first, welded_.object_ends[i] - first});
        }
        add_colors(mesh_.groups, welded_.triangle_group, result);
        if (!mesh_.groups.empty()) {
            result.groups = mesh_.groups;
            result.triangle_group = std::move(welded_.triangle_group);
        }
        for (const glm::vec3& v : result.vertices) {
            result.bounds.min = glm::min(result.bounds.min, v);
            result.bounds.max = glm::max(result.bounds.max, v);
        }
        return result;
    }

    const Mesh& mesh_;
    const LineOptions& options_;
    ProgressPart done_; ///< shares of the time that a model of a million triangles takes
    float reached_ = 0;
    BetweenPieces asking_{[this] { done_(reached_); }};
    MeshObjects objects_;
    WeldedMesh welded_;
    std::vector<MeshEdge> edges_;
    std::vector<std::uint32_t> first_face_; ///< of edges, before a neighbour stands for a sliver
    std::vector<std::uint32_t> between_bodies_; ///< edges that several meet at
    std::vector<glm::dvec3> normals_;
    std::vector<double> bends_;                  ///< of edges
    std::vector<std::optional<LineKind>> kinds_; ///< nothing: never a line
    std::vector<std::uint32_t> tangents_;        ///< edges
    std::vector<SurfaceShape> plain_shapes_;     ///< per KnownSurfaces::shapes
    MeshParts parts_;
    std::vector<bool> is_open_; ///< parts
    bool has_parts_ = false;
    std::optional<TriangleTrees> trees_;
    std::vector<std::uint32_t> object_of_triangle_;
    std::vector<std::uint32_t> material_; ///< of triangles: materials_of()
    std::vector<std::uint32_t> body_;     ///< of triangles: bodies_of()
    std::optional<Islands> islands_;      ///< if some are copies
    Seams seams_;
    std::vector<std::uint32_t> undesigned_; ///< triangles
    std::vector<Ridge> ridges_;
    AddedVertices added_{welded_};
    FoundContours smooth_;
    std::vector<std::uint32_t> contour_tags_;                     ///< of its faces
    std::vector<Line> fixed_, candidates_, replaced_;             ///< replaced by contours
    std::unordered_map<std::uint64_t, std::size_t> line_of_edge_; ///< of polylines, in `fixed_`
    LeftOut left_out_;
    LineTimes times_;
};

} // namespace

LineSet extract_lines(const Mesh& mesh, const LineOptions& options, const Progress& progress) {
    if (options.crease) check_angle("crease", *options.crease);
    check_angle("chain_angle", options.chain_angle);
    return Extraction{mesh, options, progress}.run();
}

} // namespace lineatlas
