#include "pdf.hpp"

#include <numbers>
#include <stdexcept>
#include <utility>

#include <glm/common.hpp>

#include "core/picture_size.hpp"
#include "io/module_files.hpp"
#include "lineatlas/error.hpp"
#include "pdf_module.hpp"
#include "vector/check_drawing.hpp"
#include "vector/line_groups.hpp"
#include "vector/outline.hpp"
#include "vector/paths.hpp"
#include "vector/pen_stroke.hpp"
#include "vector/sheet_writing.hpp"
#include "vector/xml_text.hpp"

namespace lineatlas {
namespace {

const pdf::Module& pdf_module() {
    static const auto& module =
        *static_cast<const pdf::Module*>(load_module(module_files::pdf, pdf::module_symbol));
    return module;
}

constexpr double points_per_inch = 72;

/// A sheet in points. `unit`: points per unit of the sheet.
Sheet in_points(Sheet sheet, double unit) {
    sheet.size *= unit;
    sheet.scale *= unit;
    sheet.corner *= unit;
    return sheet;
}

pdf::Join join_of(Join join) {
    switch (join) {
    case Join::round:
        return pdf::Join::round;
    case Join::bevel:
        return pdf::Join::bevel;
    case Join::mitre:
        break;
    }
    return pdf::Join::mitre;
}

pdf::Way way_of(const Outline& outline) {
    const std::vector<OutlinePoint>& points = outline.points;
    pdf::Way way{.start = points.front().at, .steps = {}, .closed = outline.closed};
    const std::size_t steps = points.size() - (outline.closed ? 0 : 1);
    for (std::size_t i = 0; i < steps; ++i) {
        const glm::dvec2 to = points[(i + 1) % points.size()].at;
        if (const std::optional<VectorCubic>& cubic = points[i].cubic) {
            way.steps.push_back({.cubic = true,
                                 .to = to,
                                 .first_control = cubic->first_control,
                                 .last_control = cubic->last_control});
        } else if (!points[i].is_straight()) {
            const VectorArc arc = arc_between(points[i], to);
            way.steps.push_back({.arc = true,
                                 .center = arc.center,
                                 .major = arc.major,
                                 .ratio = arc.ratio,
                                 .from = arc.from,
                                 .sweep = arc.sweep});
        } else if (i + 1 < points.size()) { // closing draws the last step
            way.steps.push_back({.to = to});
        }
    }
    return way;
}

pdf::Strokes strokes_of(const LineGroup& group, const Sheet& sheet, const ArcChoice& arcs) {
    const PenStroke stroke = pen_stroke(group.pen, sheet);
    pdf::Strokes strokes{.color = stroke.color,
                         .opacity = stroke.opacity,
                         .width = stroke.width,
                         .join = join_of(stroke.join),
                         .mitre_limit = stroke.mitre_limit,
                         .round_caps = stroke.round,
                         .dashes = stroke.dashes,
                         .ways = {}};
    for (const VectorPath& path : group.paths) {
        const Outline outline = outline_of(path, sheet, arcs);
        strokes.ways.push_back(way_of(outline));
        strokes.ways.back().dash_scale = dash_scale(stroke, outline);
    }
    return strokes;
}

void add_areas(const VectorDrawing& drawing, const Sheet& sheet, pdf::Page& page) {
    for (const VectorFill& fill : drawing.fills) {
        pdf::Area& area = page.areas.emplace_back(pdf::Area{.color = fill.color, .borders = {}});
        for (const Outline& ring : outlines_of(fill, sheet)) area.borders.push_back(way_of(ring));
    }
}

/// What `work` makes with the module. Throws FileError.
template <class Work>
auto with_module(const Work& work) {
    const pdf::Module& module = pdf_module();
    try {
        return work(module);
    } catch (const std::runtime_error& error) {
        throw FileError(std::string{"cannot write PDF: "} + error.what());
    }
}

std::string written(const pdf::Page& page) {
    return with_module([&](const pdf::Module& module) { return module.write(page); });
}

constexpr double points_per_millimetre = points_per_inch / 25.4;

/// Strokes for a line or a circle of the sheet itself.
pdf::Strokes own_strokes(glm::vec3 color, double width, pdf::Way way) {
    return {.color = color,
            .width = width * points_per_millimetre,
            .dashes = {},
            .ways = {std::move(way)}};
}

pdf::Way way_of(const SheetLine& line) {
    pdf::Way way{.start = points_per_millimetre * line.points.front(), .steps = {}};
    way.closed = line.points.size() > 2 && line.points.front() == line.points.back();
    for (std::size_t i = 1; i < line.points.size() - (way.closed ? 1 : 0); ++i)
        way.steps.push_back({.to = points_per_millimetre * line.points[i]});
    return way;
}

pdf::Way way_of(const SheetCircle& circle) {
    const glm::dvec2 right{points_per_millimetre * circle.radius, 0};
    const glm::dvec2 center = points_per_millimetre * circle.center;
    return {
        .start = center + right,
        .steps = {{.arc = true, .center = center, .major = right, .sweep = 2 * std::numbers::pi}},
        .closed = true};
}

pdf::Text text_of(const SheetText& text, glm::vec3 color) {
    return {.color = color,
            .at = points_per_millimetre * text.at,
            .height = points_per_millimetre * text.height,
            .text = xml_text(text.text),
            .before = 0.5 * static_cast<int>(text.anchor),
            .upward = text.upward};
}

/// Adds the sheet's own lines and circles, under its views.
void add_own(const SheetLayout& layout, glm::vec3 color, pdf::Page& page) {
    for (const SheetLine& line : layout.lines)
        page.strokes.push_back(own_strokes(color, line.width, way_of(line)));
    for (const SheetCircle& circle : layout.circles)
        page.strokes.push_back(own_strokes(color, circle.width, way_of(circle)));
    for (const SheetText& text : layout.texts) page.texts.push_back(text_of(text, color));
}

pdf::Page page_of(const VectorSheet& sheet, const SheetWriting& writing) {
    check_sheet(sheet);
    const SheetLayout& layout = sheet.layout;
    const Style& style = style_of(sheet);
    pdf::Page page{.size = points_per_millimetre * layout.size,
                   .background = {},
                   .title = xml_text(layout.title),
                   .subject = xml_text(writing.description),
                   .areas = {},
                   .strokes = {},
                   .texts = {}};
    if (writing.background && style.paper.color != glm::vec3{1})
        page.background = style.paper.color;
    add_own(layout, style.pen.color, page);
    for (std::size_t i = 0; i < layout.views.size(); ++i) {
        const Sheet place =
            in_points(place_of(layout.views[i], layout.size), points_per_millimetre);
        add_areas(sheet.drawings[i], place, page);
        for (const LineGroup& group : line_groups(sheet.drawings[i]))
            if (!group.thinned)
                page.strokes.push_back(
                    strokes_of(group, place, {writing.curves, writing.fit_arcs}));
    }
    return page;
}

} // namespace

void check_pdf_module() {
    find_module(module_files::pdf);
}

std::string to_pdf(const VectorDrawing& drawing, const PdfOptions& options) {
    check_drawing(drawing);
    const Sheet sheet =
        in_points(lay_out(drawing.size, options.page, options.margin, Unit::in), points_per_inch);
    pdf::Page page{.size = sheet.size,
                   .background = {},
                   .title = xml_text(options.title),
                   .subject = xml_text(options.description),
                   .areas = {},
                   .strokes = {},
                   .texts = {}};
    if (!options.certificate.empty()) page.subject += "; " + xml_text(options.certificate);
    if (options.background && drawing.style.paper.color != glm::vec3{1})
        page.background = drawing.style.paper.color;
    add_areas(drawing, sheet, page);
    for (const LineGroup& group : line_groups(drawing))
        if (!group.thinned)
            page.strokes.push_back(strokes_of(group, sheet, {options.curves, options.fit_arcs}));
    return written(page);
}

std::string to_pdf(const VectorSheet& sheet, const SheetWriting& writing) {
    return written(page_of(sheet, writing));
}

Image to_image(const VectorSheet& sheet, double dpi, const SheetWriting& writing) {
    pdf::Page page = page_of(sheet, writing);
    if (writing.background) page.background = style_of(sheet).paper.color;
    check_picture(glm::ivec2{glm::round(page.size / points_per_inch * dpi)});
    pdf::Pixels pixels = with_module(
        [&](const pdf::Module& module) { return module.paint(page, dpi / points_per_inch); });
    return {.size = {pixels.width, pixels.height}, .pixels = std::move(pixels.values)};
}

} // namespace lineatlas
