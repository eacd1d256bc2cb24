#include "svg_document.hpp"

#include "path_data.hpp"
#include "svg_groups.hpp"
#include "xml_text.hpp"

namespace lineatlas {

void add_text(XmlElement& node, const char* name, const std::string& text) {
    node.add(name).set_text(xml_text(text));
}

void mark_layer(XmlElement& group, const std::string& label) {
    group.set("inkscape:groupmode", "layer");
    group.set("inkscape:label", label);
}

XmlElement svg_root(glm::dvec2 size, const SvgPage& page) {
    XmlElement svg{"svg"};
    svg.set("xmlns", "http://www.w3.org/2000/svg");
    if (page.layers) svg.set("xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape");
    svg.set("version", "1.1");
    const std::string width = number_text(size.x, page.digits);
    const std::string height = number_text(size.y, page.digits);
    svg.set("width", width + page.unit);
    svg.set("height", height + page.unit);
    svg.set("viewBox", "0 0 " + width + " " + height);
    return svg;
}

void add_background(XmlElement& svg, const Style& style, glm::dvec2 size, int digits) {
    const std::string color = color_text(style.paper.color);
    if (color == "#ffffff") return;
    XmlElement& rect = svg.add("rect");
    rect.set("id", "paper");
    rect.set("width", number_text(size.x, digits));
    rect.set("height", number_text(size.y, digits));
    rect.set("fill", color);
}

} // namespace lineatlas
