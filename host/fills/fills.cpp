#include "lineatlas/fills.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "areas.hpp"
#include "base/parallel.hpp"
#include "border_lines.hpp"
#include "core/check_camera.hpp"
#include "core/check_lines.hpp"
#include "core/progress.hpp"
#include "face_looks.hpp"
#include "face_points.hpp"
#include "lineatlas/visibility.hpp"
#include "planar_map.hpp"
#include "seen_triangles.hpp"
#include "snapped_edges.hpp"
#include "style/settings.hpp"
#include "vector/pieces.hpp"

namespace lineatlas {
namespace {

constexpr float finest = 0.01F; ///< VisibilityOptions::step

/// Pixels by which borders continue where something else hides them, so that they surely reach it.
/// If a border is too long, it divides an area whose halves are joined again.
constexpr double overhang = 0.25;

/// Pixels by which areas may be off what is seen.
constexpr double tolerance = 0.002;

/// The most rounds in which missing borders are looked for. Added borders may show that others are
/// missing.
constexpr int most_rounds = 3;

/// The part of the line from a to b that lies in the picture; empty if there is none.
std::vector<std::pair<glm::dvec2, glm::dvec2>> in_picture(glm::dvec2 a, glm::dvec2 b,
                                                          glm::dvec2 size) {
    double from = 0, to = 1;
    const glm::dvec2 way = b - a;
    for (int axis = 0; axis < 2; ++axis) {
        if (way[axis] == 0) {
            if (a[axis] < 0 || a[axis] > size[axis]) return {};
            continue;
        }
        const double low = -a[axis] / way[axis], high = (size[axis] - a[axis]) / way[axis];
        from = std::max(from, std::min(low, high));
        to = std::min(to, std::max(low, high));
    }
    if (!(from < to)) return {};
    const auto at = [&](double share) { return share == 1 ? b : a + way * share; };
    return {{at(from), at(to)}};
}

void add_line(std::vector<GridLine>& lines, glm::dvec2 a, glm::dvec2 b, glm::dvec2 size,
              const GridScale& scale) {
    for (const auto& [from, to] : in_picture(a, b, size)) {
        const GridLine line{scale.place(from), scale.place(to)};
        if (line.a != line.b) lines.push_back(line);
    }
}

void add_piece(std::vector<GridLine>& lines, const Pieces& pieces, const Piece& piece,
               glm::dvec2 size, const GridScale& scale) {
    glm::dvec2 a = pieces.start(piece).at, b = pieces.end(piece).at;
    const double length = glm::distance(a, b);
    const glm::dvec2 beyond = length > 0 ? (b - a) * (overhang / length) : glm::dvec2{0};
    if (!at_vertex(piece.start.kind)) a -= beyond;
    if (!at_vertex(piece.end.kind)) b += beyond;
    add_line(lines, a, b, size, scale);
}

/// The borders that are seen, and that of the picture.
std::vector<GridLine> seen_borders(const Pieces& pieces, glm::dvec2 size, const GridScale& scale) {
    std::vector<GridLine> lines;
    for (const Piece& piece : pieces.list)
        if (piece.visible) add_piece(lines, pieces, piece, size, scale);
    const glm::dvec2 right{size.x, 0}, below{0, size.y};
    for (const auto& [a, b] :
         {std::pair{glm::dvec2{0}, right}, {right, size}, {size, below}, {below, glm::dvec2{0}}})
        add_line(lines, a, b, size, scale);
    return lines;
}

/// A box around a face in which several looks are seen, in pixels: a border is missing there.
struct MixedFace {
    glm::dvec2 low, high;

    bool touches(glm::dvec2 a, glm::dvec2 b) const {
        const glm::dvec2 from = glm::min(a, b), to = glm::max(a, b);
        return from.x <= high.x && from.y <= high.y && to.x >= low.x && to.y >= low.y;
    }
};

/// What is seen in the faces of a map.
struct FacesSeen {
    std::vector<std::uint32_t> looks; ///< per face what most of it shows, or no_area
    std::unordered_map<std::uint32_t, std::vector<MixedFace>> mixed; ///< by each of their looks

    bool is_mixed_at(const MixedFace& box) const {
        for (const auto& [look, faces] : mixed)
            for (const MixedFace& face : faces)
                if (face.touches(box.low, box.high)) return true;
        return false;
    }
};

/// How long the lines are along which looks are seen, of one face.
using Votes = std::vector<std::pair<std::uint32_t, double>>;

void vote(Votes& votes, std::uint32_t look, double room) {
    const auto known = std::ranges::find(votes, look, &Votes::value_type::first);
    if (known == votes.end())
        votes.emplace_back(look, room);
    else
        known->second += room;
}

std::vector<MixedFace> boxes_of_faces(const PlanarMap& map, const GridScale& scale) {
    constexpr double far = std::numeric_limits<double>::infinity();
    std::vector<MixedFace> boxes(map.face_count(), {glm::dvec2{far}, glm::dvec2{-far}});
    for (std::uint32_t h = 0; h < map.half_edge_count(); ++h) {
        if (map.face(h) == PlanarMap::outside) continue;
        MixedFace& box = boxes[map.face(h)];
        const glm::dvec2 at = scale.pixels(map.start(h));
        box = {glm::min(box.low, at), glm::max(box.high, at)};
    }
    return boxes;
}

/// Looks closely at faces that touch those that were mixed before, or at all faces.
FacesSeen look_at_faces(const PlanarMap& map, const GridScale& scale, const LineSet& lines,
                        const Camera& camera, const FaceLooks& looks, const FacesSeen* before) {
    const std::vector<MixedFace> boxes = boxes_of_faces(map, scale);
    std::vector<bool> closely(boxes.size(), before == nullptr);
    for (std::size_t i = 0; before != nullptr && i < boxes.size(); ++i) {
        ask_between_pieces();
        closely[i] = before->is_mixed_at(boxes[i]);
    }
    const std::vector<FacePoint> points = face_points(map, scale.per_pixel, closely);
    std::vector<glm::dvec2> places;
    for (const FacePoint& point : points) places.push_back(point.at / scale.per_pixel);
    const std::vector<std::uint32_t> seen = seen_triangles(lines, camera, places);
    FacesSeen result{std::vector<std::uint32_t>(map.face_count(), no_area), {}};
    Votes votes;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t face = points[i].face;
        vote(votes, seen[i] == no_triangle ? no_area : looks.of_triangle[seen[i]], points[i].room);
        if (i + 1 < points.size() && points[i + 1].face == face) continue;
        result.looks[face] = std::ranges::max_element(votes, {}, &Votes::value_type::second)->first;
        if (votes.size() > 1)
            for (const auto& [look, room] : votes) result.mixed[look].push_back(boxes[face]);
        votes.clear();
    }
    return result;
}

/// Takes the hidden borders of looks that are mixed in a face for seen ones: what touches another
/// surface, or lies within it, counts as hidden. Returns whether there are any.
bool show_missing(Pieces& pieces, const LineSet& borders, const FaceLooks& looks,
                  const FacesSeen& faces) {
    const auto is_missing = [&](const Piece& piece) {
        const Segment& segment = borders.segments[piece.segment];
        for (const std::uint32_t side : {segment.face_a, segment.face_b}) {
            if (side == LA_NO_FACE) continue;
            const auto mixed = faces.mixed.find(looks.of_triangle[side & LA_FACE_INDEX]);
            if (mixed == faces.mixed.end()) continue;
            const glm::dvec2 a = pieces.start(piece).at, b = pieces.end(piece).at;
            for (const MixedFace& face : mixed->second)
                if (face.touches(a, b)) return true;
        }
        return false;
    };
    bool any = false;
    for (Piece& piece : pieces.list) {
        ask_between_pieces();
        if (!piece.visible && is_missing(piece)) any = piece.visible = true;
    }
    return any;
}

PlanarMap map_of(const std::vector<GridLine>& lines, glm::ivec2 size, const GridScale& scale) {
    SnappedEdges edges = snap_lines(lines, size, scale);
    drop_free_ends(edges);
    return {std::move(edges), size, scale};
}

VectorFill fill_of(const Area& area, const Look& look, const GridScale& scale) {
    VectorFill fill{.object = look.object, .color = glm::vec3{look.color} / 255.0F, .rings = {}};
    for (const std::vector<GridPlace>& ring : area.rings) {
        std::vector<glm::dvec2>& points = fill.rings.emplace_back();
        for (const GridPlace place : ring) points.push_back(scale.pixels(place));
    }
    return fill;
}

void check(const Fill& fill) {
    Style style;
    style.fill = fill;
    check_style(style);
}

/// Does work that is stopped between its pieces, too. reached: the share that is done before it.
template <class Work>
auto asking(const ProgressPart& done, float reached, const Work& work) {
    done(reached);
    const BetweenPieces between{[&] { done(reached); }};
    return work();
}

/// Which lines are to be found, and what they lie between.
struct Wanted {
    FaceLooks looks;
    LineSet borders;
};

Wanted wanted_of(const LineSet& lines, const Camera& camera, const Fill& fill) {
    FaceLooks looks = face_looks(lines, camera, fill);
    LineSet borders = border_lines(lines, looks.of_triangle, camera);
    return {std::move(looks), std::move(borders)};
}

/// found: intervals of Wanted::borders, hidden ones too.
std::vector<VectorFill> fills_between(const LineSet& lines, const Camera& camera,
                                      const Wanted& wanted, const std::vector<Interval>& found) {
    const auto& [looks, borders] = wanted;
    Pieces pieces = make_pieces(borders, camera, found);
    const GridScale scale{camera.size};
    PlanarMap map =
        map_of(seen_borders(pieces, glm::dvec2{camera.size}, scale), camera.size, scale);
    FacesSeen faces = look_at_faces(map, scale, lines, camera, looks, nullptr);
    for (int round = 0; round < most_rounds && show_missing(pieces, borders, looks, faces);
         ++round) {
        map = map_of(seen_borders(pieces, glm::dvec2{camera.size}, scale), camera.size, scale);
        faces = look_at_faces(map, scale, lines, camera, looks, &faces);
    }
    std::vector<VectorFill> fills;
    for (const Area& area : join_faces(map, faces.looks, tolerance * scale.per_pixel))
        fills.push_back(fill_of(area, looks.looks[area.kind], scale));
    return fills;
}

} // namespace

std::vector<VectorFill> find_fills(const LineSet& lines, const Camera& camera, const Fill& fill,
                                   const DeviceOptions& device, const Progress& progress) {
    constexpr float before = 0.125F, found_by = 0.625F; // shares of the time, about
    check(fill);
    if (fill.mode == FillMode::none) return {};
    check_lines(lines);
    check_camera(camera);
    const ProgressPart done{progress, "finding fills"};
    const Wanted wanted = asking(done, 0, [&] { return wanted_of(lines, camera, fill); });
    const std::vector<Interval> found = LineVisibility{wanted.borders, device}.find(
        camera, {.lines = all_line_kinds, .hidden = true, .step = finest},
        part_of(progress, before, found_by));
    std::vector<VectorFill> fills =
        asking(done, found_by, [&] { return fills_between(lines, camera, wanted, found); });
    done(1);
    return fills;
}

} // namespace lineatlas
