#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

#include "lineatlas/vector.hpp"
#include "vector/dxf_text.hpp"
#include "vector/paths.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

struct Group {
    int code;
    std::string value;
    bool operator==(const Group&) const = default;
};

std::vector<Group> groups_of(const std::string& dxf) {
    std::vector<Group> groups;
    std::istringstream text{dxf};
    std::string code, value;
    while (std::getline(text, code) && std::getline(text, value))
        groups.push_back({std::stoi(code), value});
    return groups;
}

/// The groups of each object of this type in a section.
std::vector<std::vector<Group>> objects(const std::string& dxf, const std::string& section,
                                        const std::string& type) {
    std::vector<std::vector<Group>> found;
    std::string within;
    bool taken = false;
    const std::vector<Group> groups = groups_of(dxf);
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i].code == 0) {
            if (groups[i].value == "SECTION") within = groups[i + 1].value;
            taken = within == section && groups[i].value == type;
            if (taken) found.emplace_back();
        } else if (taken) {
            found.back().push_back(groups[i]);
        }
    }
    return found;
}

std::string value(const std::vector<Group>& object, int code) {
    for (const Group& group : object)
        if (group.code == code) return group.value;
    return {};
}

double number(const std::vector<Group>& object, int code) {
    return std::stod(value(object, code));
}

/// 400 by 200 pixels: a hidden line, a visible corner, a visible circle.
VectorDrawing example() {
    VectorDrawing drawing;
    drawing.size = {400, 200};
    drawing.style.hidden = true;
    drawing.paths.push_back(path_through(LineKind::crease, false, {{10, 10}, {110, 10}}));
    drawing.paths.push_back(path_through(LineKind::crease, true, {{10, 20}, {50, 20}, {50, 60}}));
    std::vector<glm::dvec2> circle;
    for (int i = 0; i <= 32; ++i)
        circle.emplace_back(300 + 50 * std::cos(i * std::acos(-1) / 16),
                            100 + 50 * std::sin(i * std::acos(-1) / 16));
    circle.back() = circle.front();
    drawing.paths.push_back(path_through(LineKind::silhouette, true, circle));
    drawing.paths.back().closed = true;
    return drawing;
}

const DxfOptions on_page{.page = parse_page("200x100mm"),
                         .margin = {}}; // half a millimetre a pixel

TEST(Dxf, NumbersAndNames) {
    DxfText text;
    text.add(40, 0.5);
    text.add(40, -1e-9);
    text.add(40, 12.0);
    text.add(70, 4);
    text.add_handle(5, 255);
    EXPECT_EQ(text.take(), " 40\n0.5\n 40\n0.0\n 40\n12.0\n 70\n4\n  5\nFF\n");
    EXPECT_EQ(dxf_line("T\xC3\xBCr\n\xE2\x82\xAC \xF0\x9F\x9A\xAA"), "T\\U+00FCr \\U+20AC ?");
}

TEST(Dxf, LayersHaveThePensOfTheirLines) {
    const auto layers = objects(to_dxf(example(), on_page), "TABLES", "LAYER");
    ASSERT_EQ(layers.size(), 4U);
    EXPECT_EQ(value(layers[0], 2), "0");
    EXPECT_EQ(value(layers[1], 2), "crease-hidden");
    EXPECT_EQ(value(layers[1], 6), "DASHED");
    EXPECT_EQ(value(layers[1], 62), "252");                           // grey
    EXPECT_EQ(value(layers[1], 420), std::to_string(115 * 0x010101)); // the pen's color
    EXPECT_EQ(value(layers[1], 370), "50");                           // 1 pixel
    EXPECT_EQ(value(layers[2], 2), "crease");
    EXPECT_EQ(value(layers[2], 6), "CONTINUOUS");
    EXPECT_EQ(value(layers[2], 62), "7");
    EXPECT_EQ(value(layers[2], 420), "");
    EXPECT_EQ(value(layers[2], 370), "100"); // 2 pixels
    EXPECT_EQ(value(layers[3], 2), "silhouette");
    const auto types = objects(to_dxf(example(), on_page), "TABLES", "LTYPE");
    ASSERT_EQ(types.size(), 4U);
    EXPECT_EQ(value(types[3], 2), "DASHED");
    EXPECT_NEAR(number(types[3], 40), 7.5, 1e-9); // 12 and 3 pixels
    EXPECT_NEAR(number(types[3], 49), 6, 1e-9);
}

TEST(Dxf, ChainsAreDashesAndDots) {
    VectorDrawing drawing = example();
    drawing.style.pen.mark = "chain";
    drawing.pens = {drawing.style.pen};
    const std::string dxf = to_dxf(drawing, on_page);
    const auto types = objects(dxf, "TABLES", "LTYPE");
    ASSERT_EQ(types.size(), 5U);
    EXPECT_EQ(value(types[4], 2), "CENTER2");
    EXPECT_EQ(value(types[4], 73), "4");
    EXPECT_NEAR(number(types[4], 40), 30.5, 1e-9); // 24, 3, a half and 3 widths of a millimetre
    std::vector<double> lengths;
    for (const Group& group : types[4])
        if (group.code == 49) lengths.push_back(std::stod(group.value));
    EXPECT_EQ(lengths, (std::vector<double>{24, -3, 0.5, -3}));
    EXPECT_EQ(value(objects(dxf, "TABLES", "LAYER").back(), 6), "CENTER2");
}

TEST(Dxf, ChainsBeginAndEndWithADash) {
    VectorDrawing drawing{.size = {400, 200}, .style = {}, .groups = {}, .paths = {}};
    drawing.style.pen.mark = "chain";
    drawing.pens = {drawing.style.pen};       // 1 mm
    for (const double length : {130.0, 60.0}) // half millimetres
        drawing.paths.push_back(
            path_through(LineKind::centre, true, {{20, length}, {20 + length, length}}));
    const auto lines = objects(to_dxf(drawing, on_page), "ENTITIES", "LINE");
    ASSERT_EQ(lines.size(), 2U);
    const double scale = number(lines[0], 48);
    EXPECT_NEAR(scale * (2 * 30.5 + 24), number(lines[0], 11) - number(lines[0], 10), 1e-3);
    EXPECT_EQ(value(lines[0], 6), "");
    EXPECT_EQ(value(lines[1], 6), "CONTINUOUS"); // a dot would be lost
    EXPECT_EQ(value(lines[1], 48), "");
}

TEST(Dxf, DashesGoOnAroundCorners) {
    const auto flags = [](const std::string& mark) {
        VectorDrawing drawing = example();
        drawing.style.pen.mark = mark;
        drawing.pens = {drawing.style.pen};
        drawing.paths.push_back(
            path_through(LineKind::crease, true, {{10, 80}, {90, 80}, {90, 160}, {10, 80}}));
        std::string all;
        for (const auto& line : objects(to_dxf(drawing, on_page), "ENTITIES", "LWPOLYLINE"))
            all += value(line, 70) + " ";
        return all;
    };
    EXPECT_EQ(flags("solid").substr(0, 4), "0 1 ");
    EXPECT_EQ(flags("dashed").substr(0, 8), "128 129 ");
}

TEST(Dxf, EveryEntityOfADashedPathBeginsAndEndsWithADash) {
    VectorDrawing drawing{.size = {400, 200}, .style = {}, .groups = {}, .paths = {}};
    drawing.style.pen.mark = "dashed";
    drawing.pens = {drawing.style.pen}; // 1 mm, so dashes of 12 mm and gaps of 3 mm
    std::vector<glm::dvec2> points{{20, 100}};
    const VectorArc arc{.center = {240, 100},
                        .major = {80, 0},
                        .ratio = 0.5,
                        .from = std::acos(-1),
                        .sweep = std::acos(-1)};
    for (int i = 0; i <= 32; ++i) points.push_back(arc.at(arc.from + arc.sweep * i / 32));
    VectorPath path = path_through(LineKind::crease, true, points);
    path.curves.push_back({.first = 1, .last = 33, .arc = arc});
    drawing.paths = {path};
    const std::string dxf = to_dxf(drawing, on_page);
    const auto lines = objects(dxf, "ENTITIES", "LINE");
    const auto ellipses = objects(dxf, "ENTITIES", "ELLIPSE");
    ASSERT_EQ(lines.size(), 1U);
    ASSERT_EQ(ellipses.size(), 1U);
    const auto periods = [](double length, double scale) { return (length / scale - 12) / 15; };
    EXPECT_NEAR(periods(70, number(lines[0], 48)), 4, 1e-3);
    // Half an ellipse of half axes of 40 and 20 mm is 96.884 mm long.
    EXPECT_NEAR(periods(96.884, number(ellipses[0], 48)), 6, 1e-3);
}

TEST(Dxf, MillimetresFromTheLowerLeftCorner) {
    const std::string dxf = to_dxf(example(), on_page);
    const auto lines = objects(dxf, "ENTITIES", "LINE");
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(value(lines[0], 8), "crease-hidden");
    EXPECT_NEAR(number(lines[0], 10), 5, 1e-9);
    EXPECT_NEAR(number(lines[0], 20), 95, 1e-9);
    EXPECT_NEAR(number(lines[0], 11), 55, 1e-9);
    const auto polylines = objects(dxf, "ENTITIES", "LWPOLYLINE");
    ASSERT_EQ(polylines.size(), 2U);
    EXPECT_EQ(value(polylines[0], 90), "3");
    EXPECT_EQ(value(polylines[0], 70), "0");
    EXPECT_EQ(value(polylines[1], 90), "32");
    EXPECT_EQ(value(polylines[1], 70), "1");
    const std::vector<Group> all = groups_of(dxf);
    for (const Group& wanted : {Group{9, "$INSUNITS"}, Group{70, "4"}, Group{1, "AC1018"}})
        EXPECT_NE(std::ranges::find(all, wanted), all.end()) << wanted.value;
    EXPECT_EQ(all.back(), (Group{0, "EOF"}));
}

TEST(Dxf, ArcsIfTheyAreWanted) {
    DxfOptions options = on_page;
    options.fit_arcs = true;
    const auto circles = objects(to_dxf(example(), options), "ENTITIES", "CIRCLE");
    ASSERT_EQ(circles.size(), 1U);
    EXPECT_NEAR(number(circles[0], 10), 150, 1e-6);
    EXPECT_NEAR(number(circles[0], 20), 50, 1e-6);
    EXPECT_NEAR(number(circles[0], 40), 25, 1e-6);

    // A quarter circle from the right to the top, and the same after a straight line.
    VectorDrawing drawing;
    drawing.size = {400, 200};
    std::vector<glm::dvec2> quarter;
    for (int i = 0; i <= 8; ++i)
        quarter.emplace_back(100 + 50 * std::cos(i * std::acos(-1) / 16),
                             100 - 50 * std::sin(i * std::acos(-1) / 16));
    drawing.paths.push_back(path_through(LineKind::crease, true, quarter));
    quarter.insert(quarter.begin(), {150, 180});
    drawing.paths.push_back(path_through(LineKind::crease, true, quarter));
    const std::string dxf = to_dxf(drawing, options);
    const auto arcs = objects(dxf, "ENTITIES", "ARC");
    ASSERT_EQ(arcs.size(), 1U);
    EXPECT_NEAR(number(arcs[0], 10), 50, 1e-6);
    EXPECT_NEAR(number(arcs[0], 20), 50, 1e-6);
    EXPECT_NEAR(number(arcs[0], 40), 25, 1e-6);
    EXPECT_NEAR(number(arcs[0], 50), 0, 1e-4);
    EXPECT_NEAR(number(arcs[0], 51), 90, 1e-4);
    const auto polylines = objects(dxf, "ENTITIES", "LWPOLYLINE");
    ASSERT_EQ(polylines.size(), 1U);
    EXPECT_EQ(value(polylines[0], 90), "3");
    EXPECT_NEAR(number(polylines[0], 42), std::tan(std::acos(-1) / 8), 1e-6);
}

TEST(Dxf, CommentsSayWhatMadeIt) {
    const std::vector<Group> groups =
        groups_of(to_dxf({}, {.description = std::string(300, 'a'), .certificate = "none wrong"}));
    EXPECT_EQ(groups[0], (Group{999, std::string(250, 'a')}));
    EXPECT_EQ(groups[1], (Group{999, std::string(50, 'a')}));
    EXPECT_EQ(groups[2], (Group{999, "none wrong"}));
}

TEST(Dxf, NoHandleIsThereTwice) {
    std::vector<std::string> handles;
    std::string variable;
    unsigned long seed = 0, largest = 0;
    for (const Group& group : groups_of(to_dxf(example()))) {
        if (group.code == 9) variable = group.value;
        if (group.code != 5 && group.code != 105) continue;
        const unsigned long handle = std::stoul(group.value, nullptr, 16);
        if (seed == 0 && variable == "$HANDSEED") {
            seed = handle;
            continue;
        }
        largest = std::max(largest, handle);
        EXPECT_EQ(std::ranges::count(handles, group.value), 0) << group.value;
        handles.push_back(group.value);
    }
    EXPECT_GT(seed, largest);
}

} // namespace
} // namespace lineatlas
