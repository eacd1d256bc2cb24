#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "lineatlas/sheet.hpp"
#include "vector_support.hpp"

// Sheets of a box, and what tests read of sheets and of their files.
namespace lineatlas {

/// The edges of a box as lines that nothing hides. The coordinates of its corners are no round
/// floats.
struct Box {
    explicit Box(glm::vec3 low = {-31.3F, 17.7F, 5.1F}, glm::vec3 size = {120, 50, 70})
        : low(low), high(low + size) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const auto& [u, v] : {std::pair{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
                glm::vec3 a = low, b = low;
                const int other = (axis + 1) % 3, last = (axis + 2) % 3;
                a[other] = b[other] = u == 0 ? low[other] : high[other];
                a[last] = b[last] = v == 0 ? low[last] : high[last];
                b[axis] = high[axis];
                lines.add(LineKind::crease, {a, b});
            }
        }
    }

    SheetLayout layout(const SheetOptions& options = {}) const {
        return lay_out_sheet(lines.set.vertices, options);
    }
    VectorSheet sheet(const SheetOptions& options = {}, const Style& style = {}) const {
        const auto find = [&](const SheetView& view) {
            test::Cuts cuts{lines.set, view.camera};
            cuts.add_all();
            SeenLines seen{cuts.intervals};
            if (view.cut) seen.lines = &lines.set; // as if nothing were cut away
            return seen;
        };
        return make_vector_sheet(lines.set, layout(options), find, style);
    }

    glm::vec3 low, high;
    test::Lines lines;
};

inline const SheetView& view_named(const SheetLayout& layout, const std::string& name) {
    return *std::ranges::find(layout.views, name, &SheetView::name);
}

/// The group of an SVG for a view or a layer.
inline pugi::xml_node group(const pugi::xml_document& svg, const std::string& id) {
    return svg.child("svg").find_child_by_attribute("g", "id", id.c_str());
}

inline pugi::xml_document parsed(const std::string& svg) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(svg.c_str()));
    return document;
}

struct Lined {
    glm::dvec2 from, to;
    double length() const { return glm::distance(from, to); }
};

/// The LINEs of a DXF by their layers.
inline std::multimap<std::string, Lined> lines_of(const std::string& dxf) {
    std::multimap<std::string, Lined> found;
    std::istringstream text{dxf};
    std::string code, value, type, layer;
    std::map<int, double> numbers;
    while (std::getline(text, code) && std::getline(text, value)) {
        const int number = std::stoi(code);
        if (number == 0) {
            if (type == "LINE")
                found.emplace(layer, Lined{{numbers[10], numbers[20]}, {numbers[11], numbers[21]}});
            type = value;
            numbers.clear();
        } else if (number == 8) {
            layer = value;
        } else if (number >= 10 && number < 40) {
            numbers[number] = std::stod(value);
        }
    }
    return found;
}

/// The place of a point of the model on paper, by the view's own camera.
inline glm::dvec2 on_paper(const SheetView& view, glm::vec3 point) {
    const glm::dmat4 clip = glm::dmat4{view.camera.projection} * glm::dmat4{view.camera.view};
    const glm::dvec4 at = clip * glm::dvec4{point, 1};
    const glm::dvec2 size{view.camera.size};
    return view.corner +
           view.scale * glm::dvec2{0.5 * (1 + at.x) * size.x, 0.5 * (1 - at.y) * size.y};
}

inline std::set<std::string> texts_of(const SheetLayout& layout, const std::string& layer) {
    std::set<std::string> found;
    for (const SheetText& text : layout.texts)
        if (text.layer == layer) found.insert(text.text);
    return found;
}

inline std::vector<SheetLine> lines_on(const SheetLayout& layout, const std::string& layer,
                                       double width) {
    std::vector<SheetLine> found;
    for (const SheetLine& line : layout.lines)
        if (line.layer == layer && line.width == width) found.push_back(line);
    return found;
}

} // namespace lineatlas
