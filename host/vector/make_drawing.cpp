#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "chaining.hpp"
#include "core/check_camera.hpp"
#include "core/check_lines.hpp"
#include "core/depth_tolerance.hpp"
#include "core/line_pens.hpp"
#include "corners.hpp"
#include "curves.hpp"
#include "fair.hpp"
#include "halos.hpp"
#include "junctions.hpp"
#include "lengths.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/vector.hpp"
#include "overlaps.hpp"
#include "paths.hpp"
#include "pieces.hpp"
#include "plotter.hpp"
#include "shared/constants.h"
#include "simplify.hpp"
#include "smooth_joints.hpp"
#include "strips.hpp"
#include "style/settings.hpp"
#include "thin_out.hpp"

namespace lineatlas {
namespace {

/// By LineKind: crease, boundary, material, silhouette, file, intersection, section, hatching,
/// ridge, valley, tangent, centre, trail. What outlines the model is drawn last.
constexpr std::array<int, LA_KIND_COUNT> drawn_rank{5, 7, 4, 8, 9, 6, 12, 0, 3, 2, 1, 11, 10};

void sort_for_drawing(std::vector<VectorPath>& paths) {
    std::ranges::stable_sort(paths, {}, [](const VectorPath& path) {
        const int rank = drawn_rank[static_cast<std::size_t>(path.kind)];
        // Outlines lie over all else, and paths of one pen stand together.
        return std::tuple{path.visible, !path.thinned, path.outline, path.outline ? 0 : rank,
                          path.pen};
    });
}

void drop_hidden(std::vector<Strip>& strips) {
    for (Strip& strip : strips) {
        std::erase_if(strip.strokes, [](const Stroke& stroke) { return !stroke.visible; });
    }
}

bool look_alike(const Pen& a, const Pen& b) {
    return a.mark == b.mark && a.width == b.width && a.color == b.color && a.opacity == b.opacity;
}

/// A centre line whose hidden parts look as the others do is one line, and its dashes run through.
void join_centre_lines(const LineClasses& classes, const LinePens& pens,
                       std::vector<Strip>& strips) {
    for (Strip& strip : strips) {
        if (strip.kind != LineKind::centre) continue;
        const LinePens::OfClass own =
            pens.of_class.empty() ? LinePens::OfClass{}
                                  : pens.of_class[classes.of_segment[strip.steps.front().segment]];
        if (!look_alike(pens.pens[own.inner], pens.hidden[own.hidden])) continue;
        for (Stroke& stroke : strip.strokes) stroke.visible = true;
    }
}

/// Drops paths whose pen has an opacity of 0.
void drop_invisible(VectorDrawing& drawing) {
    std::erase_if(drawing.paths, [&](const VectorPath& path) {
        return (path.visible ? drawing.pens : drawing.hidden_pens)[path.pen].opacity == 0;
    });
}

void apply_filter(const LineSet& lines, const Camera& camera, const Style& style, float widest,
                  const Pieces& pieces, std::vector<Strip>& strips) {
    const StrokeFilter& filter = style.filter;
    std::vector<std::vector<Cut>> cuts(strips.size());
    if (filter.halo > 0) {
        cuts = find_halos(lines, pieces, strips, glm::dvec2{camera.size},
                          {.width = static_cast<double>(filter.halo + 0.5F * widest),
                           .tolerance = static_cast<double>(depth_tolerance(camera))});
    }
    const double crumb = pieces.exact ? 0 : crumb_of_samples;
    const double rough_crumb = std::max(crumb, double{LA_LEAST_ROUGH} * camera.size.y);
    for (std::size_t i = 0; i < strips.size(); ++i) {
        const bool is_rough =
            (lines.segments[strips[i].steps.front().segment].tag & LA_TAG_UNDESIGNED) != 0;
        filter_lengths(strips[i], filter, cuts[i], is_rough ? rough_crumb : crumb);
    }
}

/// Drops short ridges and valleys.
void drop_short(const Camera& camera, std::vector<VectorPath>& paths) {
    const double least = double{LA_LEAST_SHAPE} * camera.size.y;
    std::erase_if(paths, [&](const VectorPath& path) {
        return (mask_of(path.kind) & LA_KINDS_OF_SHAPE) != 0 && length_of(path) < least;
    });
}

double thinned_share(const std::vector<VectorPath>& paths) {
    double all = 0, thinned = 0;
    for (const VectorPath& path : paths) {
        const double length = length_of(path);
        all += length;
        if (path.thinned) thinned += length;
    }
    return all > 0 ? thinned / all : 0;
}

void add_groups(const Mesh& mesh, VectorDrawing& drawing) {
    drawing.groups = mesh.groups;
    for (VectorPath& path : drawing.paths) {
        for (VectorPiece& piece : path.pieces) {
            const std::uint32_t triangle = piece.source.triangle;
            if (triangle >= mesh.triangle_group.size()) continue;
            const std::uint32_t group = mesh.triangle_group[triangle];
            if (group < mesh.groups.size()) piece.group = group;
        }
    }
}

void check(const LineSet& lines, const VectorOptions& options) {
    check_lines(lines);
    if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance))
        throw UsageError("tolerance must be a number of pixels of at least 0");
}

} // namespace

VectorDrawing make_vector_drawing(const LineSet& lines, const Camera& camera,
                                  std::span<const Interval> intervals, const Style& given,
                                  const VectorOptions& options) {
    check_style(given);
    check_camera(camera);
    check(lines, options);
    Style style = given;
    scale_lengths(style, camera.size);
    LineClasses classes;
    LinePens pens{.pens = {style.pen}, .hidden = {style.hidden_pen}, .of_class = {}};
    if (!style.pens.empty()) {
        classes = line_classes(lines);
        pens = line_pens(classes, style);
    }
    const PathPens by_rule{classes, pens};
    const glm::dvec2 picture{camera.size};
    Pieces pieces = make_pieces(lines, camera, intervals);
    drop_flickers(pieces);
    hide_beyond_corners(lines, camera, pieces);
    meet_junctions(lines, camera, pieces);
    std::vector<Strip> strips = make_strips(lines, pieces);
    if (pens.tell_outlines() && !options.outlines.empty())
        mark_outlines(strips, pieces, options.outlines, picture, {lines, camera});
    if (style.hidden)
        join_centre_lines(classes, pens, strips);
    else
        drop_hidden(strips);
    apply_filter(lines, camera, style, widest(pens.pens), pieces, strips);

    VectorDrawing drawing{.size = camera.size, .style = style, .groups = {}, .paths = {}};
    drawing.pens = pens.pens;
    drawing.hidden_pens = pens.hidden;
    drawing.paths = chain_strips(lines, pieces, strips, style.pens.empty() ? nullptr : &by_rule);
    drop_invisible(drawing);
    fair(lines, drawing.paths);
    const PathCurves curves{lines, options.mesh, camera};
    curves.bend(drawing.paths);
    simplify(drawing.paths, options.tolerance, curves);
    curves.name(drawing.paths);
    curves.keep_shared_chords(drawing.paths);
    const std::vector<std::uint32_t> along = curves.numbers(drawing.paths);
    drawing.paths = remove_overlaps(std::move(drawing.paths), picture, along);
    join_smoothly(drawing.paths);
    drop_short(camera, drawing.paths);

    drawing.paths = thin_out(std::move(drawing.paths), style, picture);
    drawing.thinned_share = thinned_share(drawing.paths);
    sort_for_drawing(drawing.paths);
    if (options.mesh != nullptr) add_groups(*options.mesh, drawing);
    if (options.plotter) {
        std::erase_if(drawing.paths, [](const VectorPath& path) { return path.thinned; });
        drawing.travel = order_for_plotter(drawing.paths);
    }
    curves.find(drawing.paths);
    return drawing;
}

} // namespace lineatlas
