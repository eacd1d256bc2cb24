#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "core/drawing_scale.hpp"
#include "core/picture_size.hpp"
#include "lineatlas/error.hpp"
#include "page_name.hpp"
#include "sheet_frame.hpp"
#include "sheet_grid.hpp"
#include "sheet_measures.hpp"
#include "sheet_options.hpp"
#include "sheet_pixels.hpp"
#include "sheet_sections.hpp"
#include "sheet_sides.hpp"
#include "title_block.hpp"

namespace lineatlas {
namespace {

/// Least gaps along an axis of the page, in millimetres: before the first view, between two, behind
/// the last.
struct Gaps {
    double first, between, last;

    double sum(std::size_t views) const {
        if (views == 0) return 0;
        return first + between * static_cast<double>(views - 1) + last;
    }
};

constexpr double least_gap = 10;

/// The sides of a model in a grid, but for those that were placed by hand.
struct Grid {
    std::vector<SheetSide> sides;
    std::vector<SheetCell> cells;
    Gaps across, upwards;
};

std::vector<SheetCell> cells_of(const std::vector<SheetSide>& sides, ProjectionAngle angle) {
    std::vector<WantedCell> wanted;
    for (const SheetSide& side : sides)
        if (!side.at) wanted.push_back({.side = side.side, .yields = side.cut.has_value()});
    return sheet_cells(wanted, angle);
}

Grid grid_of(std::vector<SheetSide> sides, const SheetOptions& options) {
    const bool named =
        std::ranges::any_of(sides, [](const SheetSide& side) { return !side.letter.empty(); });
    const double least = named ? space_for_letters : least_gap;
    // Measures stand below views and on their left.
    const double measured = options.measures ? std::max(least, space_for_measures) : least;
    Grid grid{.sides = std::move(sides),
              .cells = {},
              .across = {measured, measured, least},
              .upwards = {least, measured, measured}};
    const std::vector<SheetCell> cells = cells_of(grid.sides, options.angle);
    auto next = cells.begin();
    for (const SheetSide& side : grid.sides) grid.cells.push_back(side.at ? SheetCell{} : *next++);
    return grid;
}

/// Millimetres of paper per unit of the model, for each side.
using PaperScales = std::vector<double>;

/// Half of each column and row on paper.
struct Halves {
    std::vector<double> columns, rows;
};

Halves halves_of(const Grid& grid, const PaperScales& scales) {
    Halves halves;
    const auto widen = [](std::vector<double>& all, int at, double half) {
        const auto place = static_cast<std::size_t>(at);
        if (all.size() <= place) all.resize(place + 1, 0);
        all[place] = std::max(all[place], half);
    };
    for (std::size_t i = 0; i < grid.sides.size(); ++i) {
        if (grid.sides[i].at) continue;
        const glm::dvec2 reach = scales[i] * grid.sides[i].reach();
        widen(halves.columns, grid.cells[i].column, reach.x);
        widen(halves.rows, grid.cells[i].row, reach.y);
    }
    return halves;
}

/// The scale of each side on a sheet of this scale. Throws UsageError for a detail that is not
/// larger than its view.
std::vector<std::string> scales_of(const Grid& grid, const std::string& sheet) {
    std::vector<std::string> scales;
    for (const SheetSide& side : grid.sides) {
        const std::string of_view = side.detail ? scales[side.shown_on] : sheet;
        const double value = parse_scale("the scale", of_view);
        const std::string usual = side.detail ? enlarging_scale(2 * value) : sheet;
        if (side.scale.empty() && usual.empty())
            throw UsageError(
                fmt::format("a detail of \"{}\": ISO 5455 has no scale twice as large "
                            "as {}; give the detail a scale, or the view a smaller one",
                            side.detail->view, of_view));
        scales.push_back(side.scale.empty() ? usual : side.scale);
        if (!side.detail || parse_scale("the scale of a detail", scales.back()) > value) continue;
        throw UsageError(fmt::format("the scale {} of a detail of \"{}\" must be larger than {}, "
                                     "that of the view",
                                     scales.back(), side.detail->view, of_view));
    }
    return scales;
}

PaperScales paper_scales(const std::vector<std::string>& scales, double unit) {
    PaperScales result;
    for (const std::string& scale : scales)
        result.push_back(unit * parse_scale("the scale", scale));
    return result;
}

double sum(const std::vector<double>& halves) {
    double total = 0;
    for (const double half : halves) total += 2 * half;
    return total;
}

/// The middles of columns, or rows, that are spread evenly from `low` to `high`; nothing if there
/// is no room for the gaps.
std::optional<std::vector<double>> spread(const std::vector<double>& halves, double low,
                                          double high, const Gaps& gaps) {
    const double left = high - low - sum(halves) - gaps.sum(halves.size());
    if (!(left >= 0)) return {};
    const double more = left / static_cast<double>(halves.size() + 1);
    std::vector<double> middles;
    double at = low + gaps.first + more;
    for (const double half : halves) {
        middles.push_back(at + half);
        at = middles.back() + half + gaps.between + more;
    }
    return middles;
}

/// Middles of the cells of all sides in this space, and places by hand; nothing if the cells have
/// no room.
std::optional<std::vector<glm::dvec2>> places_in(const Grid& grid, const PaperScales& scales,
                                                 const SheetBox& space) {
    const Halves halves = halves_of(grid, scales);
    const auto columns = spread(halves.columns, space.low.x, space.high.x, grid.across);
    const auto rows = spread(halves.rows, space.low.y, space.high.y, grid.upwards);
    if (!columns || !rows) return {};
    std::vector<glm::dvec2> places;
    for (std::size_t i = 0; i < grid.sides.size(); ++i) {
        const SheetSide& side = grid.sides[i];
        if (side.at) {
            const glm::dvec2 middle = 0.5 * (side.low + side.high) - side.middle;
            places.push_back(*side.at - scales[i] * middle);
        } else {
            places.push_back({(*columns)[static_cast<std::size_t>(grid.cells[i].column)],
                              (*rows)[static_cast<std::size_t>(grid.cells[i].row)]});
        }
    }
    return places;
}

SheetBox box_on_paper(const SheetSide& side, glm::dvec2 place, double scale) {
    return {place + scale * (side.low - side.middle), place + scale * (side.high - side.middle)};
}

/// Middles of the cells on a page beside the title block, or above it if a view in a cell would
/// meet the block.
std::optional<std::vector<glm::dvec2>> places_on(const Grid& grid, const PaperScales& scales,
                                                 const SheetBox& frame, const SheetBox& block) {
    auto places = places_in(grid, scales, frame);
    if (!places) return {};
    for (std::size_t i = 0; i < places->size(); ++i)
        if (!grid.sides[i].at &&
            box_on_paper(grid.sides[i], (*places)[i], scales[i]).meets(block, grid.upwards.last))
            return places_in(grid, scales, {frame.low, {frame.high.x, block.low.y}});
    return places;
}

/// Which views those that were placed by hand must not meet.
enum class Others { all, placed_by_hand };

/// What is wrong with views that were placed by hand; empty: nothing.
std::string trouble_by_hand(const Grid& grid, const PaperScales& scales,
                            const std::vector<glm::dvec2>& places, const SheetBox& frame,
                            const SheetBox& block, Others others = Others::all) {
    const auto box = [&](std::size_t i) {
        return box_on_paper(grid.sides[i], places[i], scales[i]);
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
        const SheetSide& side = grid.sides[i];
        if (!side.at) continue;
        const auto trouble = [&](const std::string& what) {
            return fmt::format("\"{}\", placed at {:g},{:g} mm, {}", side.name, side.at->x,
                               side.at->y, what);
        };
        const SheetBox own = box(i);
        const bool within = own.low.x >= frame.low.x && own.low.y >= frame.low.y &&
                            own.high.x <= frame.high.x && own.high.y <= frame.high.y;
        if (!within) return trouble("leaves the frame");
        if (own.meets(block, 0)) return trouble("meets the title block");
        for (std::size_t k = 0; k < places.size(); ++k)
            if (k != i && (others == Others::all || grid.sides[k].at) && own.meets(box(k), 0))
                return trouble(fmt::format("meets \"{}\"", grid.sides[k].name));
    }
    return {};
}

struct Fit {
    std::string scale;
    std::vector<std::string> scales; ///< of all sides
    std::vector<glm::dvec2> places;
};

/// An upper bound of the scales that fit: that of the sheet if views with scales of their own had
/// no size.
double largest_scale(const Grid& grid, double unit, const SheetBox& frame) {
    glm::dvec2 largest{0}; // view
    PaperScales one;
    for (const SheetSide& side : grid.sides) {
        const bool counts = !side.detail && side.scale.empty();
        one.push_back(counts ? unit : 0);
        if (counts) largest = glm::max(largest, unit * (side.high - side.low));
    }
    const Halves halves = halves_of(grid, one);
    largest = glm::max(largest, {sum(halves.columns), sum(halves.rows)});
    return std::min(frame.size().x / largest.x, frame.size().y / largest.y);
}

/// Scales by which only views and details with a scale of their own have a size.
PaperScales own_scales_alone(const Grid& grid, double unit) {
    PaperScales scales;
    for (const SheetSide& side : grid.sides)
        scales.push_back(side.scale.empty() ? 0 : unit * parse_scale("the scale", side.scale));
    return scales;
}

/// Whether each detail is larger than its view on a sheet of this scale.
bool enlarges_details(const Grid& grid, double scale) {
    const auto scale_of = [&](const SheetSide& side) {
        return side.scale.empty() ? scale : parse_scale("the scale", side.scale);
    };
    return std::ranges::all_of(grid.sides, [&](const SheetSide& side) {
        return !side.detail || side.scale.empty() ||
               scale_of(side) > scale_of(grid.sides[side.shown_on]);
    });
}

/// Throws UsageError if no scale of the sheet can make the views fit. Looks only at the sizes of
/// views with a scale of their own, because all other views stand elsewhere at other scales.
void check_room(const Grid& grid, double unit, const SheetBox& frame, const SheetBox& block) {
    if (!places_on(grid, PaperScales(grid.sides.size(), 0), frame, block))
        throw UsageError("the page has no room for so many views; take a larger page");
    const PaperScales least = own_scales_alone(grid, unit);
    const auto places = places_on(grid, least, frame, block);
    if (!places)
        throw UsageError("the page has no room for views and details of their own scales; give "
                         "them smaller ones, or take a larger page");
    const std::string trouble =
        trouble_by_hand(grid, least, *places, frame, block, Others::placed_by_hand);
    if (!trouble.empty()) throw UsageError(trouble + "; place it elsewhere");
}

/// The layout at the largest scale of ISO 5455 that fits. Throws UsageError if none does.
Fit largest_fit(const Grid& grid, double unit, const SheetBox& frame, const SheetBox& block) {
    check_room(grid, unit, frame, block);
    double largest = largest_scale(grid, unit, frame);
    std::string trouble;
    for (;;) {
        const std::string scale = standard_scale(largest);
        if (scale.empty() && !trouble.empty()) throw UsageError(trouble + "; place it elsewhere");
        if (scale.empty())
            throw UsageError("the model is too large for any scale on this page; take a larger "
                             "page, or another unit of the model");
        const double value = parse_scale("the scale", scale);
        constexpr double smaller = 0.99; // than the scale of the series
        largest = smaller * value;
        if (!enlarges_details(grid, value)) continue;
        std::vector<std::string> scales = scales_of(grid, scale);
        const PaperScales on_paper = paper_scales(scales, unit);
        auto places = places_on(grid, on_paper, frame, block);
        if (!places) continue;
        trouble = trouble_by_hand(grid, on_paper, *places, frame, block);
        if (trouble.empty()) return {scale, std::move(scales), std::move(*places)};
    }
}

/// The scale of the sheet as it is given: if all views have scales of their own, that of the first.
std::string given_scale(const Grid& grid, const SheetOptions& options) {
    const auto has_own = [](const SheetSide& side) { return side.detail || !side.scale.empty(); };
    const bool all = options.scale.empty() && std::ranges::all_of(grid.sides, has_own);
    return all ? grid.sides.front().scale : options.scale;
}

Fit fit(const Grid& grid, const SheetOptions& options, const SheetBox& frame,
        const SheetBox& block) {
    const std::string given = given_scale(grid, options);
    if (given.empty()) return largest_fit(grid, options.unit, frame, block);
    std::vector<std::string> scales = scales_of(grid, given);
    const PaperScales on_paper = paper_scales(scales, options.unit);
    if (auto places = places_on(grid, on_paper, frame, block)) {
        const std::string trouble = trouble_by_hand(grid, on_paper, *places, frame, block);
        if (!trouble.empty())
            throw UsageError(trouble + "; place it elsewhere, or take a smaller scale");
        return {given, std::move(scales), std::move(*places)};
    }
    const Halves halves = halves_of(grid, on_paper);
    const auto paper = [&](const std::vector<double>& all, const Gaps& gaps) {
        return sum(all) + gaps.sum(all.size());
    };
    throw UsageError(fmt::format(
        "the scale {}: the views take {:.4g} x {:.4g} mm and the page has {:.4g} x {:.4g} mm "
        "within its frame, less the title block; {} fits",
        given, paper(halves.columns, grid.across), paper(halves.rows, grid.upwards), frame.size().x,
        frame.size().y, largest_fit(grid, options.unit, frame, block).scale));
}

/// The pixels of a camera's picture, and pixels per unit of the model.
struct Pixels {
    glm::dmat4 clip_from_world;
    glm::dvec2 size;

    explicit Pixels(const Camera& camera)
        : clip_from_world(glm::dmat4{camera.projection} * glm::dmat4{camera.view}),
          size(camera.size) {}

    glm::dvec2 at(glm::dvec3 point) const {
        const glm::dvec4 clip = clip_from_world * glm::dvec4{point, 1};
        return {0.5 * (1 + clip.x) * size.x, 0.5 * (1 - clip.y) * size.y};
    }
    double per_unit() const {
        const glm::dvec3 row{clip_from_world[0][1], clip_from_world[1][1], clip_from_world[2][1]};
        return 0.5 * size.y * glm::length(row);
    }
};

/// Pixels per millimetre of a detail, in whose picture all of its view takes `paper` millimetres.
double pixels_of_detail(glm::dvec2 paper) {
    constexpr double longest = 32768; // pixels
    return std::min(sheet_pixels, longest / std::max(paper.x, paper.y));
}

/// The view of a side whose cell has its middle at `place`. Scale and corner make up for the
/// rounding of floats in the camera, so that views are aligned.
SheetView view_of(const SheetSide& side, glm::dvec2 place, double scale, glm::dvec3 center,
                  const Bounds& bounds) {
    constexpr double around = 8; // pixels, so that no stroke is cut off
    const glm::dvec2 paper = scale * (side.picture_high - side.picture_low);
    const double density = side.detail ? pixels_of_detail(paper) : sheet_pixels;
    const glm::ivec2 size{glm::ceil(density * paper + 2 * around)};
    check_picture(size);
    const glm::dvec2 middle = 0.5 * (side.picture_low + side.picture_high);
    const glm::dvec3 target = center + middle.x * side.right + middle.y * side.down;
    const double height = size.y / (density * scale);
    const double distance = 0.5 * height / std::tan(0.5 * double{View{}.fov_y});
    const View view{.eye = target + distance * glm::dvec3{side.direction.toward_eye},
                    .target = target,
                    .up = side.direction.up,
                    .projection = Projection::orthographic};
    SheetView result{.name = side.name,
                     .letter = side.letter,
                     .pictorial = side.pictorial,
                     .detail = side.detail.has_value(),
                     .cut = side.cut,
                     .camera = make_camera(view, size, bounds)};
    const Pixels pixels{result.camera};
    result.scale = scale / pixels.per_unit();
    const glm::dvec2 center_place = place - scale * side.middle;
    result.corner = center_place - result.scale * pixels.at(center);
    const SheetBox box = box_on_paper(side, place, scale);
    result.low = box.low;
    result.high = box.high;
    return result;
}

/// Width and height of the sheet in millimetres, as it lies.
glm::dvec2 page_size(const Page& page) {
    constexpr double widest_upright = 216; // A4, Letter and Legal
    const glm::dvec2 size{length_in(page.width, Unit::mm), length_in(page.height, Unit::mm)};
    if (!(std::min(size.x, size.y) > 0) || !std::isfinite(size.x) || !std::isfinite(size.y))
        throw UsageError("the page must have a width and a height");
    if (!page.turns) return size;
    const double shorter = std::min(size.x, size.y), longer = std::max(size.x, size.y);
    return shorter <= widest_upright ? glm::dvec2{shorter, longer} : glm::dvec2{longer, shorter};
}

Bounds bounds_around(std::span<const glm::vec3> points) {
    if (points.empty()) throw UsageError("a sheet: the model has no points to frame");
    Bounds bounds;
    for (const glm::vec3& point : points) {
        bounds.min = glm::min(bounds.min, point);
        bounds.max = glm::max(bounds.max, point);
    }
    return bounds;
}

} // namespace

SheetLayout lay_out_sheet(std::span<const glm::vec3> points, const SheetOptions& options) {
    check_sheet_options(options);
    const Bounds bounds = bounds_around(points);
    const glm::dvec3 center = 0.5 * (glm::dvec3{bounds.min} + glm::dvec3{bounds.max});
    const Grid grid = grid_of(sheet_sides(points, bounds, options), options);

    SheetLayout layout{.size = page_size(options.page),
                       .title = options.fields.title,
                       .measures = options.measures};
    const SheetBox frame = frame_of(layout.size);
    const SheetBox block = title_block_of(frame);
    const Fit found = fit(grid, options, frame, block);
    layout.scale = found.scale;
    const PaperScales scales = paper_scales(found.scales, options.unit);
    for (std::size_t i = 0; i < grid.sides.size(); ++i) {
        layout.views.push_back(view_of(grid.sides[i], found.places[i], scales[i], center, bounds));
        if (found.scales[i] != found.scale || grid.sides[i].detail)
            layout.views.back().own_scale = found.scales[i];
    }
    add_frame(layout);
    add_sections(layout, grid.sides, found.places, scales, center);
    add_details(layout, grid.sides, found.places, scales);
    add_title_block(
        layout, block, options.fields,
        {.scale = layout.scale, .page = page_name(options.page), .angle = options.angle});
    return layout;
}

} // namespace lineatlas
