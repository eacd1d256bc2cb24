#include "pdf.hpp"

#include "io/module_files.hpp"
#include "lineatlas/error.hpp"
#include "pdf_module.hpp"
#include "vector/check_drawing.hpp"
#include "vector/line_groups.hpp"
#include "vector/outline.hpp"
#include "vector/pen_stroke.hpp"
#include "vector/xml_text.hpp"

namespace lineatlas {
namespace {

const pdf::Module& pdf_module() {
    static const auto& module =
        *static_cast<const pdf::Module*>(load_module(module_files::pdf, pdf::module_symbol));
    return module;
}

constexpr double points_per_inch = 72;

/// A sheet in points.
Sheet in_points(Sheet sheet) {
    sheet.size *= points_per_inch;
    sheet.scale *= points_per_inch;
    sheet.corner *= points_per_inch;
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
        } else if (i + 1 < points.size()) { // closing draws the last one
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
                         .dashes = {},
                         .ways = {}};
    if (stroke.dashes) strokes.dashes = {stroke.dashes->dash, stroke.dashes->gap};
    for (const VectorPath& path : group.paths)
        strokes.ways.push_back(way_of(outline_of(path, sheet, arcs)));
    return strokes;
}

} // namespace

void check_pdf_module() {
    find_module(module_files::pdf);
}

std::string to_pdf(const VectorDrawing& drawing, const PdfOptions& options) {
    check_drawing(drawing);
    const Sheet sheet = in_points(lay_out(drawing.size, options.page, options.margin, Unit::in));
    pdf::Page page{.size = sheet.size,
                   .background = {},
                   .title = xml_text(options.title),
                   .subject = xml_text(options.description),
                   .strokes = {}};
    if (!options.certificate.empty()) page.subject += "; " + xml_text(options.certificate);
    if (options.background && drawing.style.paper.color != glm::vec3{1})
        page.background = drawing.style.paper.color;
    for (const LineGroup& group : line_groups(drawing))
        page.strokes.push_back(strokes_of(group, sheet, {options.curves, options.fit_arcs}));
    const pdf::Module& module = pdf_module();
    try {
        return module.write(page);
    } catch (const std::runtime_error& error) {
        throw FileError(std::string{"cannot write PDF: "} + error.what());
    }
}

} // namespace lineatlas
