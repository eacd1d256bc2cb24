#include <cstddef>
#include <string>

#include <fmt/core.h>

#include "check_drawing.hpp"
#include "lineatlas/vector.hpp"
#include "sheet.hpp"
#include "svg_document.hpp"
#include "svg_groups.hpp"

namespace lineatlas {
namespace {

constexpr const char* unit_names[] = {"px", "mm", "in"};

std::string description_of(const VectorDrawing& drawing, const SvgOptions& options) {
    std::string text = options.description;
    if (!text.empty()) text += "; ";
    text += fmt::format("{} paths, seen at {}x{} pixels", drawing.paths.size(), drawing.size.x,
                        drawing.size.y);
    if (drawing.travel) {
        text += fmt::format("; ordered for a plotter: the pen travels {:.0f} pixels between paths",
                            drawing.travel->after);
    }
    return text;
}

} // namespace

std::string to_svg(const VectorDrawing& drawing, const SvgOptions& options) {
    check_drawing(drawing);
    const Sheet sheet = lay_out(drawing.size, options);
    const std::string unit = unit_names[static_cast<std::size_t>(options.units)];
    XmlElement svg = svg_root(sheet.size, {unit, sheet.digits, options.layers});
    add_text(svg, "title", options.title);
    add_text(svg, "desc", description_of(drawing, options));
    if (!options.certificate.empty()) add_text(svg, "metadata", options.certificate);
    if (options.background) add_background(svg, drawing.style, sheet.size, sheet.digits);
    write_paths(svg, drawing, sheet,
                {.tags = options.tags && !drawing.travel,
                 .layers = options.layers,
                 .relative = options.relative,
                 .arcs = {options.curves, options.fit_arcs}});
    return xml_document(svg);
}

} // namespace lineatlas
