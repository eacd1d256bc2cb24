#include "svg_document.hpp"

#include <cstddef>
#include <utility>

#include "path_data.hpp"
#include "svg_groups.hpp"
#include "xml_text.hpp"

namespace lineatlas {
namespace {

struct TextWriter : pugi::xml_writer {
    void write(const void* bytes, std::size_t size) override {
        text.append(static_cast<const char*>(bytes), size);
    }
    std::string text;
};

} // namespace

void set(pugi::xml_node& node, const char* name, const std::string& value) {
    node.append_attribute(name) = value.c_str();
}

void add_text(pugi::xml_node& node, const char* name, const std::string& text) {
    node.append_child(name).text() = xml_text(text).c_str();
}

void mark_layer(pugi::xml_node& group, const std::string& label) {
    set(group, "inkscape:groupmode", "layer");
    set(group, "inkscape:label", label);
}

pugi::xml_node add_svg(pugi::xml_document& document, glm::dvec2 size, const SvgPage& page) {
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    set(declaration, "version", "1.0");
    set(declaration, "encoding", "UTF-8");
    pugi::xml_node svg = document.append_child("svg");
    set(svg, "xmlns", "http://www.w3.org/2000/svg");
    if (page.layers) set(svg, "xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
    set(svg, "version", "1.1");
    const std::string width = number_text(size.x, page.digits);
    const std::string height = number_text(size.y, page.digits);
    set(svg, "width", width + page.unit);
    set(svg, "height", height + page.unit);
    set(svg, "viewBox", "0 0 " + width + " " + height);
    return svg;
}

void add_background(pugi::xml_node& svg, const Style& style, glm::dvec2 size, int digits) {
    const std::string color = color_text(style.paper.color);
    if (color == "#ffffff") return;
    pugi::xml_node rect = svg.append_child("rect");
    set(rect, "id", "paper");
    set(rect, "width", number_text(size.x, digits));
    set(rect, "height", number_text(size.y, digits));
    set(rect, "fill", color);
}

std::string svg_text(const pugi::xml_document& document) {
    TextWriter out;
    document.save(out, " ", pugi::format_indent | pugi::format_save_file_text, pugi::encoding_utf8);
    return std::move(out.text);
}

} // namespace lineatlas
