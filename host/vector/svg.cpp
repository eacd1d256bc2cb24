#include <cstddef>
#include <string>
#include <utility>

#include <fmt/core.h>
#include <pugixml.hpp>

#include "check_drawing.hpp"
#include "line_groups.hpp"
#include "lineatlas/vector.hpp"
#include "outline.hpp"
#include "path_data.hpp"
#include "sheet.hpp"
#include "svg_groups.hpp"
#include "tags.hpp"
#include "xml_text.hpp"

namespace lineatlas {
namespace {

constexpr const char* unit_names[] = {"px", "mm", "in"};

void set(pugi::xml_node& node, const char* name, const std::string& value) {
    node.append_attribute(name) = value.c_str();
}

void add_text(pugi::xml_node& node, const char* name, const std::string& text) {
    node.append_child(name).text() = xml_text(text).c_str();
}

pugi::xml_node add_svg(pugi::xml_document& document, const Sheet& sheet,
                       const SvgOptions& options) {
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    set(declaration, "version", "1.0");
    set(declaration, "encoding", "UTF-8");
    pugi::xml_node svg = document.append_child("svg");
    set(svg, "xmlns", "http://www.w3.org/2000/svg");
    if (options.layers) set(svg, "xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
    set(svg, "version", "1.1");
    const std::string unit = unit_names[static_cast<std::size_t>(options.units)];
    const std::string width = number_text(sheet.size.x, sheet.digits);
    const std::string height = number_text(sheet.size.y, sheet.digits);
    set(svg, "width", width + unit);
    set(svg, "height", height + unit);
    set(svg, "viewBox", "0 0 " + width + " " + height);
    return svg;
}

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

void add_background(pugi::xml_node& svg, const Style& style, const Sheet& sheet) {
    const std::string color = color_text(style.paper.color);
    if (color == "#ffffff") return;
    pugi::xml_node rect = svg.append_child("rect");
    set(rect, "id", "paper");
    set(rect, "width", number_text(sheet.size.x, sheet.digits));
    set(rect, "height", number_text(sheet.size.y, sheet.digits));
    set(rect, "fill", color);
}

class PathWriter {
  public:
    PathWriter(pugi::xml_node svg, const VectorDrawing& drawing, const Sheet& sheet,
               const SvgOptions& options)
        : svg_(svg), drawing_(drawing), sheet_(sheet), options_(options) {}

    void write_all() {
        for (const LineGroup& group : line_groups(drawing_)) {
            group_ = add_group(svg_, group, sheet_, options_.layers);
            for (const VectorPath& path : group.paths) write(path);
        }
    }

  private:
    void write(const VectorPath& path) {
        const std::string data =
            path_data(outline_of(path, sheet_, {options_.curves, options_.fit_arcs}), sheet_.digits,
                      options_.relative);
        if (data.empty()) return;
        pugi::xml_node node = group_.append_child("path");
        set(node, "d", data);
        const bool tagged = options_.tags && !drawing_.travel;
        if (tagged) add_text(node, "desc", tags_text(drawing_, path));
    }

    pugi::xml_node svg_;
    const VectorDrawing& drawing_;
    const Sheet& sheet_;
    const SvgOptions& options_;
    pugi::xml_node group_;
};

struct TextWriter : pugi::xml_writer {
    void write(const void* bytes, std::size_t size) override {
        text.append(static_cast<const char*>(bytes), size);
    }
    std::string text;
};

} // namespace

std::string to_svg(const VectorDrawing& drawing, const SvgOptions& options) {
    check_drawing(drawing);
    const Sheet sheet = lay_out(drawing.size, options);
    pugi::xml_document document;
    pugi::xml_node svg = add_svg(document, sheet, options);
    add_text(svg, "title", options.title);
    add_text(svg, "desc", description_of(drawing, options));
    if (!options.certificate.empty()) add_text(svg, "metadata", options.certificate);
    if (options.background) add_background(svg, drawing.style, sheet);
    PathWriter{svg, drawing, sheet, options}.write_all();
    TextWriter out;
    document.save(out, " ", pugi::format_indent | pugi::format_save_file_text, pugi::encoding_utf8);
    return std::move(out.text);
}

} // namespace lineatlas
