#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "core/pens.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/vector.hpp"
#include "vector/path_data.hpp"
#include "vector/paths.hpp"
#include "vector/sheet.hpp"
#include "vector/xml_text.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

Outline straight(const std::vector<glm::dvec2>& points, bool closed = false) {
    Outline outline{.points = {}, .closed = closed};
    for (const glm::dvec2 point : points) outline.points.push_back({point});
    return outline;
}

// --- numbers and paths

TEST(PathData, NumbersHaveNoDigitToSpare) {
    EXPECT_EQ(number_text(1, 2), "1");
    EXPECT_EQ(number_text(-1.5, 2), "-1.5");
    EXPECT_EQ(number_text(0.004, 2), "0");
    EXPECT_EQ(number_text(-0.004, 2), "0");
    EXPECT_EQ(number_text(0.25, 2), ".25");
    EXPECT_EQ(number_text(-0.05, 2), "-.05");
    EXPECT_EQ(number_text(120, 0), "120");
    EXPECT_EQ(number_text(100, 3), "100");
}

TEST(PathData, IsRelativeOrNot) {
    const std::vector<glm::dvec2> points{{10, 20}, {15, 20}, {15, 30}, {12.5, 30.25}};
    EXPECT_EQ(path_data(straight(points), 2, true), "m10 20h5v10l-2.5 .25");
    EXPECT_EQ(path_data(straight(points), 2, false), "M10 20H15V30L12.5 30.25");
    const std::vector<glm::dvec2> loop{{10, 20}, {15, 25}, {10, 30}, {10, 20}};
    EXPECT_EQ(path_data(straight(loop, true), 2, true), "m10 20 5 5-5 5z");
    EXPECT_EQ(path_data(straight({{1, 1}, {1.001, 1.001}}), 2, true), "");
}

TEST(PathData, Arcs) {
    const Outline half{.points = {{{10, 20}, 1}, {{30, 20}}}};
    EXPECT_EQ(path_data(half, 2, false), "M10 20A10 10 0 0 1 20 10 10 10 0 0 1 30 20");
    EXPECT_EQ(path_data(half, 2, true), "m10 20a10 10 0 0 1 10-10 10 10 0 0 1 10 10");
    const Outline circle{.points = {{{10, 20}, -1}, {{30, 20}, -1}}, .closed = true};
    EXPECT_EQ(path_data(circle, 2, true),
              "m10 20a10 10 0 0 0 10 10 10 10 0 0 0 10-10 10 10 0 0 0-10-10 10 10 0 0 0-10 10z");
    // Three quarters of a circle, and a straight way back.
    const double bulge = std::tan(3 * std::numbers::pi / 8);
    const Outline most{.points = {{{10, 0}, bulge}, {{0, -10}}}, .closed = true};
    EXPECT_EQ(path_data(most, 2, true),
              "m10 0a10 10 0 0 1-10 10 10 10 0 0 1-10-10 10 10 0 0 1 10-10z");
}

/// Programs that read SVG find the centre of an arc from its rounded ends.
TEST(PathData, ArcsAreWhereTheyBelong) {
    const glm::dvec2 center{512.0296351, 409.2964947};
    for (const double radius : {463.8009, 31.4159, 2000.7}) {
        for (const double sweep : {0.5, 2.0, 3.0, std::numbers::pi, 3.3, 5.0, 6.2}) {
            const VectorArc arc{
                .center = center, .major = {radius, 0}, .from = 0.7, .sweep = sweep};
            const Outline outline{
                .points = {{.at = arc.at(0.7), .bulge = std::tan(sweep / 4), .arc = arc},
                           {arc.at(0.7 + sweep)}}};
            std::string data = path_data(outline, 2, false);
            std::ranges::replace_if(
                data, [](char c) { return c == 'M' || c == 'A'; }, ' ');
            std::istringstream numbers{data};
            glm::dvec2 from{0};
            numbers >> from.x >> from.y;
            double rx = 0, ry = 0, turn = 0, large = 0, onwards = 0;
            glm::dvec2 to{0};
            while (numbers >> rx >> ry >> turn >> large >> onwards >> to.x >> to.y) {
                ASSERT_EQ(large, 0);
                const glm::dvec2 half = 0.5 * (to - from);
                const double rest = std::sqrt(std::max(0.0, rx * rx - glm::dot(half, half)));
                const glm::dvec2 found =
                    from + half + rest * glm::normalize(glm::dvec2{-half.y, half.x});
                EXPECT_LE(glm::distance(found, center), 0.02) << radius << ' ' << sweep;
                from = to;
            }
        }
    }
}

TEST(PathData, ErrorsDoNotAddUp) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < 5000; ++i) {
        points.emplace_back(i * 0.1234567, std::sin(i) * 50 + i % 2 * 200); // no two level
    }
    const std::string data = path_data(straight(points), 2, true);
    glm::dvec2 at{0, 0};
    std::size_t k = 0;
    const std::regex number{"-?[0-9]*\\.?[0-9]+"};
    for (auto it = std::sregex_iterator{data.begin(), data.end(), number};
         it != std::sregex_iterator{}; ++it, ++k) {
        at[k % 2 == 0 ? 0 : 1] += std::stod(it->str());
        if (k % 2 == 1) {
            ASSERT_LE(std::abs(at.x - points[k / 2].x), 0.00501);
            ASSERT_LE(std::abs(at.y - points[k / 2].y), 0.00501);
        }
    }
    EXPECT_EQ(k, 10000U);
}

// --- pages

TEST(Pages, LengthsAndUnits) {
    EXPECT_EQ(parse_unit("MM"), Unit::mm);
    EXPECT_EQ(parse_length("12", Unit::in).unit, Unit::in);
    EXPECT_EQ(parse_length("12.5mm", Unit::px).value, 12.5);
    EXPECT_NEAR(length_in(parse_length("1in", Unit::px), Unit::mm), 25.4, 1e-12);
    EXPECT_NEAR(length_in({96, Unit::px}, Unit::in), 1, 1e-12);
    for (const char* wrong : {"", "mm", "10cm", "-3mm", "1e99mm", "nan", "10 mm", "10mmx"}) {
        EXPECT_THROW(parse_length(wrong, Unit::mm), UsageError) << wrong;
    }
    EXPECT_THROW(parse_unit("cm"), UsageError);
}

TEST(Pages, NamesAndSizes) {
    EXPECT_EQ(parse_page("A4").width.value, 210);
    EXPECT_EQ(parse_page("a0").height.value, 1189);
    EXPECT_EQ(parse_page("letter").height.unit, Unit::in);
    const Page own = parse_page("300x200.5mm");
    EXPECT_EQ(own.width.value, 300);
    EXPECT_EQ(own.height.value, 200.5);
    EXPECT_FALSE(own.turns);
    for (const char* wrong : {"", "a7", "300x200", "0x20mm", "x20mm", "20xmm", "20x30cm"}) {
        EXPECT_THROW(parse_page(wrong), UsageError) << wrong;
    }
    try {
        parse_page("a9");
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(),
                     "unknown page \"a9\"; there is a0, a1, a2, a3, a4, a5, a6, letter, legal, "
                     "tabloid, or width and height as in 300x200mm");
    }
}

TEST(Pages, ThePictureIsCentredAndTurnsThePage) {
    const SvgOptions options{.units = Unit::mm, .page = parse_page("a4"), .margin = {10, Unit::mm}};
    const Sheet sheet = lay_out({1600, 900}, options);
    EXPECT_EQ(sheet.size, (glm::dvec2{297, 210}));
    EXPECT_NEAR(sheet.scale, 277.0 / 1600, 1e-12);
    EXPECT_NEAR(sheet.corner.x, 10, 1e-9);
    EXPECT_NEAR(sheet.corner.y, 0.5 * (210 - 900 * 277.0 / 1600), 1e-9);
    EXPECT_EQ(lay_out({900, 1600}, options).size, (glm::dvec2{210, 297}));
    EXPECT_EQ(sheet.digits, 3);
    const SvgOptions pixels{.margin = {4, Unit::px}};
    EXPECT_EQ(lay_out({100, 50}, pixels).size, (glm::dvec2{108, 58}));
    EXPECT_EQ(lay_out({100, 50}, pixels).digits, 2);
    Style style{.pen = {.width = 2}, .made_for = 768};
    // A width of 277 mm for 1600 pixels.
    const Style on_page = style_on_page(style, {1600, 900}, *options.page, options.margin);
    EXPECT_NEAR(on_page.pen.width * 277 / 1600, 2 * 25.4 / 96, 1e-6);
    EXPECT_EQ(on_page.made_for, 0);
    style.made_for = 0;
    EXPECT_EQ(style_on_page(style, {1600, 900}, *options.page).pen.width, 2);
    const SvgOptions narrow{.page = parse_page("a6"), .margin = {60, Unit::mm}};
    EXPECT_THROW(lay_out({100, 50}, narrow), UsageError);
}

// --- SVG

TEST(XmlText, HoldsOnlyWhatXmlKnows) {
    EXPECT_EQ(xml_text("T\xC3\xBCr \xF0\x9F\x9A\xAA"), "T\xC3\xBCr \xF0\x9F\x9A\xAA");
    EXPECT_EQ(xml_text("T\xFCr"), "T?r"); // Latin-1
    EXPECT_EQ(xml_text("a\tb\x01"), "a b ");
    EXPECT_EQ(xml_text("\xC3"), "?");
    EXPECT_EQ(xml_text("\xC0\xAF"), "??");           // too long
    EXPECT_EQ(xml_text("\xED\xA0\x80"), "???");      // half a surrogate pair
    EXPECT_EQ(xml_text("\xEF\xBF\xBF"), "???");      // no character
    EXPECT_EQ(xml_text("\xF4\x90\x80\x80"), "????"); // beyond Unicode
}

VectorDrawing example() {
    VectorDrawing drawing{.size = {100, 80}, .style = {}, .groups = {}, .paths = {}};
    drawing.groups = {{.object = "door", .material = "oak"},
                      {.object = "<wall> & \x01", .material = ""}};
    drawing.paths.push_back(path_through(LineKind::crease, false, {{10, 10}, {50, 10}}));
    drawing.paths.push_back(
        path_through(LineKind::crease, true, {{10, 20}, {50, 20}, {50, 60}, {10, 20}}));
    drawing.paths.push_back(path_through(LineKind::silhouette, true, {{5, 5}, {95, 75}}));
    std::uint32_t from = 12;
    for (VectorPath& path : drawing.paths) {
        for (VectorPiece& piece : path.pieces) {
            piece.source = {.from = from, .to = from + 1, .triangle = 3};
            ++from;
        }
    }
    drawing.paths[1].pieces[0].group = 0;
    drawing.paths[1].pieces[1].group = 0;
    drawing.paths[1].pieces[2].group = 1;
    return drawing;
}

pugi::xml_document parsed(const std::string& svg) {
    pugi::xml_document document;
    const pugi::xml_parse_result result = document.load_string(svg.c_str());
    EXPECT_TRUE(result) << result.description();
    return document;
}

TEST(Svg, HasAGroupPerKindAndHiddenLinesUnderVisibleOnes) {
    const pugi::xml_document document = parsed(to_svg(example()));
    const pugi::xml_node svg = document.child("svg");
    EXPECT_STREQ(svg.attribute("width").value(), "100px");
    EXPECT_STREQ(svg.attribute("viewBox").value(), "0 0 100 80");
    std::vector<std::string> ids;
    for (const pugi::xml_node group : svg.children("g"))
        ids.emplace_back(group.attribute("id").value());
    EXPECT_EQ(ids, (std::vector<std::string>{"crease-hidden", "crease", "silhouette"}));
    const pugi::xml_node hidden = svg.child("g");
    EXPECT_STREQ(hidden.attribute("class").value(), "crease hidden");
    EXPECT_STREQ(hidden.attribute("inkscape:groupmode").value(), "layer");
    EXPECT_STREQ(hidden.attribute("inkscape:label").value(), "crease (hidden)");
    EXPECT_STREQ(hidden.attribute("stroke").value(), "#737373");
    EXPECT_STREQ(hidden.attribute("stroke-dasharray").value(), "12 3");
    EXPECT_STREQ(hidden.child("path").attribute("d").value(), "m10 10h40");
    const pugi::xml_node visible = hidden.next_sibling("g");
    EXPECT_STREQ(visible.attribute("stroke-width").value(), "2");
    EXPECT_STREQ(visible.attribute("stroke-linejoin").value(), "miter");
    EXPECT_STREQ(visible.attribute("stroke-miterlimit").value(), "4");
    EXPECT_STREQ(visible.attribute("stroke-linecap").value(), "round");
    EXPECT_STREQ(visible.child("path").attribute("d").value(), "m10 20h40v40z");
    EXPECT_STREQ(visible.child("path").child("desc").text().get(),
                 "object door, <wall> &  ; material oak; edges 13-14 14-15 15-16");
    EXPECT_FALSE(svg.child("rect"));
}

TEST(Svg, OptionsLeaveThingsOut) {
    VectorDrawing drawing = example();
    drawing.style.paper.color = {0, 0, 0.5F};
    const std::string plain =
        to_svg(drawing, {.background = false, .tags = false, .layers = false, .title = "A & B"});
    EXPECT_EQ(plain.find("inkscape"), std::string::npos);
    EXPECT_EQ(plain.find("rect"), std::string::npos);
    EXPECT_EQ(plain.find("edges"), std::string::npos);
    EXPECT_STREQ(parsed(plain).child("svg").child("title").text().get(), "A & B");
    const pugi::xml_document document = parsed(to_svg(drawing, {.description = "style ink"}));
    EXPECT_STREQ(document.child("svg").child("rect").attribute("fill").value(), "#000080");
    EXPECT_STREQ(document.child("svg").child("desc").text().get(),
                 "style ink; 3 paths, seen at 100x80 pixels");
    drawing.travel = PenTravel{};
    EXPECT_EQ(to_svg(drawing).find("edges"), std::string::npos) << "tags for a plotter";
}

TEST(Svg, LengthsAreThoseOfThePage) {
    VectorDrawing drawing = example();
    drawing.style.pen.mark = "dotted";
    drawing.style.pen.opacity = 0.5F;
    drawing.style.pen.join = Join::round;
    const pugi::xml_document document =
        parsed(to_svg(drawing, {.units = Unit::mm, .page = parse_page("100x80mm"), .margin = {}}));
    const pugi::xml_node svg = document.child("svg");
    EXPECT_STREQ(svg.attribute("width").value(), "100mm");
    const pugi::xml_node visible = svg.child("g").next_sibling("g");
    EXPECT_STREQ(visible.attribute("stroke-dasharray").value(), "0 5");
    EXPECT_STREQ(visible.attribute("stroke-linecap").value(), "round");
    EXPECT_STREQ(visible.attribute("stroke-opacity").value(), ".5");
    EXPECT_FALSE(visible.attribute("stroke-miterlimit"));
    const pugi::xml_document inches = parsed(to_svg(drawing, {.units = Unit::in}));
    EXPECT_STREQ(inches.child("svg").attribute("width").value(), "1.0417in");
}

/// The lengths by which a straight path of a mark is dashed, if the path has its own.
std::string own_dashes(const char* mark, double length) {
    VectorDrawing drawing{.size = {600, 100}, .style = {}, .groups = {}, .paths = {}};
    drawing.style.pen.mark = mark;
    drawing.style.pen.width = 1;
    drawing.pens = {drawing.style.pen};
    drawing.paths = {path_through(LineKind::centre, true, {{10, 50}, {10 + length, 50}})};
    const pugi::xml_document svg = parsed(to_svg(drawing));
    const pugi::xml_node path = svg.child("svg").child("g").child("path");
    EXPECT_FALSE(path.attribute("stroke-dashoffset"));
    return path.attribute("stroke-dasharray").value();
}

// A dash is 12 widths long, that of a chain 24.
TEST(Svg, DashedLinesBeginAndEndWithADash) {
    for (const double length : {43.0, 60.0, 85.5, 110.0, 120.0, 148.0, 500.0}) {
        for (const char* mark : {"dashed", "chain"}) {
            SCOPED_TRACE(std::string{mark} + " " + std::to_string(length));
            const bool is_chain = std::string{mark} == "chain";
            std::istringstream text{own_dashes(mark, length)};
            const std::vector<double> dashes{std::istream_iterator<double>{text}, {}};
            ASSERT_EQ(dashes.size(), is_chain ? 4U : 2U);
            const double scale = dashes[0] / (is_chain ? 24 : 12);
            EXPECT_TRUE(scale > 0.5 && scale < 1.4) << scale;
            const double period = std::accumulate(dashes.begin(), dashes.end(), 0.0);
            const double periods = (length - dashes[0]) / period;
            const double step = is_chain ? 2 : 1; // an even number: a dash in the middle
            EXPECT_NEAR(periods, step * std::round(periods / step), 0.02);
            EXPECT_GT(periods, 0.9 * step);
        }
    }
}

// The rim of a cylinder of 24 sides. Chords are shorter than the circle by 5.4 pixels.
TEST(Svg, DashesAreMeasuredAlongCurves) {
    constexpr double radius = 300;
    const double turn = 2 * std::acos(-1);
    std::vector<glm::dvec2> points;
    for (int i = 0; i <= 24; ++i)
        points.emplace_back(400 + radius * std::cos(turn * (i % 24) / 24),
                            400 + radius * std::sin(turn * (i % 24) / 24));
    VectorDrawing drawing{.size = {800, 800}, .style = {}, .groups = {}, .paths = {}};
    drawing.style.pen.mark = "dashed";
    drawing.style.pen.width = 2;
    drawing.pens = {drawing.style.pen};
    VectorPath path = path_through(LineKind::crease, true, points);
    for (const bool known : {true, false}) {
        SCOPED_TRACE(known);
        path.curves.clear();
        if (known)
            path.curves.push_back({.first = 0,
                                   .last = 24,
                                   .arc = {.center = {400, 400},
                                           .major = {radius, 0},
                                           .ratio = 1,
                                           .from = 0,
                                           .sweep = turn}});
        drawing.paths = {path};
        const pugi::xml_document svg = parsed(to_svg(drawing, {.fit_arcs = true}));
        std::istringstream text{
            svg.child("svg").child("g").child("path").attribute("stroke-dasharray").value()};
        double dash = 0, gap = 0;
        text >> dash >> gap;
        const double periods = turn * radius / (dash + gap);
        EXPECT_NEAR(periods, std::round(periods), 0.01);
    }
}

TEST(Svg, LinesTooShortForGapsAreSolid) {
    EXPECT_EQ(own_dashes("chain", 42), "none");
    EXPECT_NE(own_dashes("dashed", 7), "none");
    EXPECT_EQ(own_dashes("dashed", 6.5), "none");
    EXPECT_EQ(own_dashes("dotted", 3), "") << "that of the group";
}

TEST(Svg, DashesAreAsLongAsThePensAre) {
    for (const float width : {0.5F, 2.0F, 7.0F}) {
        for (const char* mark : {"dashed", "dotted"}) {
            const std::optional<DashLengths> dashes = dash_lengths(mark, width);
            ASSERT_TRUE(dashes);
            const PenMark pen = make_pen(mark, width);
            EXPECT_NEAR(pen.repeat_length, dashes->dash + dashes->gap, 1e-4F);
            // The covered share of the period along the spine.
            const auto columns = static_cast<std::size_t>(pen.size.x);
            const std::size_t row = static_cast<std::size_t>(pen.size.y) / 2;
            double covered = 0;
            for (std::size_t x = 0; x < columns; ++x) covered += pen.coverage[row * columns + x];
            covered *= static_cast<double>(pen.repeat_length) / 255 / static_cast<double>(columns);
            const float round = dashes->round ? std::max(1.0F, width) : 0;
            EXPECT_NEAR(covered, static_cast<double>(dashes->dash + round), 0.1 * covered) << mark;
        }
    }
    EXPECT_FALSE(dash_lengths("pencil", 2));
}

// --- JSON

TEST(Json, HasAllOfThePaths) {
    const VectorDrawing drawing = example();
    const nlohmann::json json = nlohmann::json::parse(to_json(drawing, {.description = "x"}));
    EXPECT_EQ(json["format"], "lineatlas-drawing");
    EXPECT_EQ(json["version"], 1);
    EXPECT_EQ(json["size"], nlohmann::json({100, 80}));
    EXPECT_EQ(json["groups"][0]["object"], "door");
    ASSERT_EQ(json["paths"].size(), 3U);
    const nlohmann::json& path = json["paths"][1];
    EXPECT_EQ(path["kind"], "crease");
    EXPECT_EQ(path["visible"], true);
    EXPECT_EQ(path["closed"], true);
    EXPECT_EQ(path["points"][2], nlohmann::json({50, 60}));
    EXPECT_EQ(path["world"][2], nlohmann::json({50, 60, 0.5}));
    EXPECT_EQ(path["arc"][1], 40);
    EXPECT_EQ(path["pieces"][2]["point"], 2);
    EXPECT_EQ(path["pieces"][2]["from"], 15);
    EXPECT_EQ(path["pieces"][2]["to"], 16);
    EXPECT_EQ(path["pieces"][2]["triangle"], 3);
    EXPECT_EQ(path["pieces"][2]["group"], 1);
    for (const char* key : {"points", "depth", "world", "arc"}) EXPECT_EQ(path[key].size(), 4U);
}

TEST(Json, OfNothingIsJson) {
    const nlohmann::json json = nlohmann::json::parse(to_json({}, {.tags = false}));
    EXPECT_TRUE(json["paths"].empty());
    EXPECT_FALSE(json.contains("groups"));
}

TEST(Json, FloatsAreShort) {
    VectorDrawing drawing = example();
    drawing.paths[0].points[0].world = {0.1F, -2.7F, 1e-9F};
    const std::string text = to_json(drawing);
    EXPECT_NE(text.find("[0.1,-2.7,1e-09]"), std::string::npos);
}

} // namespace
} // namespace lineatlas
