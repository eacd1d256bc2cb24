#include <string>

#include <fmt/format.h>

#include "path_data.hpp"
#include "sheet_writing.hpp"
#include "svg_document.hpp"
#include "svg_groups.hpp"

namespace lineatlas {
namespace {

constexpr int digits = 4; // a tenth of a micrometre

/// Height of capital letters in usual fonts without serifs, by the font's size.
constexpr double capital_height = 0.72;

constexpr const char* anchor_names[] = {"start", "middle", "end"};

std::string number(double value) {
    return number_text(value, digits);
}

std::string point(glm::dvec2 at) {
    return number(at.x) + " " + number(at.y);
}

void add_line(XmlElement& group, const SheetLine& line) {
    XmlElement& path = group.add("path");
    const bool closed = line.points.size() > 2 && line.points.front() == line.points.back();
    const std::size_t count = line.points.size() - (closed ? 1 : 0);
    std::string data;
    for (std::size_t i = 0; i < count; ++i)
        data.append(i == 0 ? "M" : "L").append(point(line.points[i]));
    path.set("d", data + (closed ? "z" : ""));
    path.set("stroke-width", number(line.width));
}

void add_circle(XmlElement& group, const SheetCircle& circle) {
    XmlElement& node = group.add("circle");
    node.set("cx", number(circle.center.x));
    node.set("cy", number(circle.center.y));
    node.set("r", number(circle.radius));
    node.set("stroke-width", number(circle.width));
}

void add_words(XmlElement& group, const SheetText& text, const std::string& color) {
    add_text(group, "text", text.text);
    XmlElement& node = group.last_child();
    node.set("x", number(text.at.x));
    node.set("y", number(text.at.y));
    if (text.upward) node.set("transform", "rotate(-90 " + point(text.at) + ")");
    node.set("font-size", number(text.height / capital_height));
    if (text.anchor != TextAnchor::start)
        node.set("text-anchor", anchor_names[static_cast<std::size_t>(text.anchor)]);
    node.set("stroke", "none");
    node.set("fill", color);
}

/// Adds the sheet's own lines, circles and texts of one layer.
void add_own(XmlElement& svg, const SheetLayout& layout, const std::string& layer,
             const std::string& color, bool layers) {
    XmlElement& group = svg.add("g");
    group.set("id", layer);
    if (layers) mark_layer(group, layer);
    group.set("fill", "none");
    group.set("stroke", color);
    group.set("font-family", "sans-serif");
    for (const SheetLine& line : layout.lines)
        if (line.layer == layer) add_line(group, line);
    for (const SheetCircle& circle : layout.circles)
        if (circle.layer == layer) add_circle(group, circle);
    for (const SheetText& text : layout.texts)
        if (text.layer == layer) add_words(group, text, color);
}

/// Whether marks of a layer lie on views, whose areas must not cover them.
bool lies_on_views(const std::string& layer) {
    return layer == "sections" || layer == "details";
}

void add_view(XmlElement& svg, const SheetView& view, const VectorDrawing& drawing, glm::dvec2 page,
              const SheetWriting& writing) {
    XmlElement& group = svg.add("g");
    const std::string name = name_in_file(view);
    group.set("id", name);
    group.set("class", "view");
    if (writing.layers) mark_layer(group, name);
    write_paths(group, drawing, place_of(view, page),
                {.tags = writing.tags && !drawing.travel,
                 .layers = writing.layers,
                 .relative = true,
                 .arcs = {writing.curves, writing.fit_arcs},
                 .prefix = name + "-"});
}

} // namespace

std::string to_svg(const VectorSheet& sheet, const SheetWriting& writing) {
    check_sheet(sheet);
    const SheetLayout& layout = sheet.layout;
    XmlElement svg = svg_root(layout.size, {"mm", digits, writing.layers});
    add_text(svg, "title", layout.title);
    add_text(svg, "desc", writing.description);
    if (writing.background) add_background(svg, style_of(sheet), layout.size, digits);
    const std::string color = color_text(style_of(sheet).pen.color);
    const auto add_layers = [&](bool on_views) {
        for (const std::string& layer : own_layers(layout))
            if (lies_on_views(layer) == on_views)
                add_own(svg, layout, layer, color, writing.layers);
    };
    add_layers(false);
    for (std::size_t i = 0; i < layout.views.size(); ++i)
        add_view(svg, layout.views[i], sheet.drawings[i], layout.size, writing);
    add_layers(true);
    return xml_document(svg);
}

} // namespace lineatlas
