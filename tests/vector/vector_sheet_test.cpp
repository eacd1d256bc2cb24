// Sheets: the places and scales of views, and the content of files.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <tuple>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "core/drawing_scale.hpp"
#include "lineatlas/error.hpp"
#include "lineatlas/sheet.hpp"
#include "vector/clip_drawing.hpp"
#include "vector/drawn_box.hpp"
#include "vector/sheet_frame.hpp"
#include "vector/title_block.hpp"
#include "vector_support.hpp"

namespace lineatlas {
namespace {

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

const SheetView& view_named(const SheetLayout& layout, const std::string& name) {
    return *std::ranges::find(layout.views, name, &SheetView::name);
}

/// The group of an SVG for a view or a layer.
pugi::xml_node group(const pugi::xml_document& svg, const std::string& id) {
    return svg.child("svg").find_child_by_attribute("g", "id", id.c_str());
}

pugi::xml_document parsed(const std::string& svg) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(svg.c_str()));
    return document;
}

struct Lined {
    glm::dvec2 from, to;
    double length() const { return glm::distance(from, to); }
};

/// The LINEs of a DXF by their layers.
std::multimap<std::string, Lined> lines_of(const std::string& dxf) {
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
glm::dvec2 on_paper(const SheetView& view, glm::vec3 point) {
    const glm::dmat4 clip = glm::dmat4{view.camera.projection} * glm::dmat4{view.camera.view};
    const glm::dvec4 at = clip * glm::dvec4{point, 1};
    const glm::dvec2 size{view.camera.size};
    return view.corner +
           view.scale * glm::dvec2{0.5 * (1 + at.x) * size.x, 0.5 * (1 - at.y) * size.y};
}

TEST(Sheet, ViewsStandWhereTheAngleOfProjectionPutsThem) {
    const Box box;
    for (const auto angle : {ProjectionAngle::first, ProjectionAngle::third}) {
        SCOPED_TRACE(name_of(angle));
        const SheetLayout layout = box.layout(
            {.views = {"back", "front", "left", "top", "right", "bottom"}, .angle = angle});
        const double sign = angle == ProjectionAngle::third ? 1 : -1;
        const glm::dvec2 front = view_named(layout, "front").low;
        const auto from_front = [&](const char* name) {
            return view_named(layout, name).low - front;
        };
        EXPECT_LT(sign * from_front("top").y, -50);
        EXPECT_GT(sign * from_front("bottom").y, 50);
        EXPECT_GT(sign * from_front("right").x, 50);
        EXPECT_LT(sign * from_front("left").x, -50);
        EXPECT_GT(from_front("back").x, std::abs(from_front("right").x));
    }
}

TEST(Sheet, ViewsAreAlignedToAThousandthOfAMillimetre) {
    const Box box{{-1031.3F, 217.7F, 95.1F}, {333.3F, 55.7F, 91.9F}};
    for (const std::string page : {"a4", "a0"}) {
        const SheetLayout layout = box.layout({.page = parse_page(page)});
        const SheetView& front = view_named(layout, "front");
        const SheetView& top = view_named(layout, "top");
        const SheetView& right = view_named(layout, "right");
        for (const glm::vec3& corner : box.lines.set.vertices) {
            EXPECT_NEAR(on_paper(front, corner).x, on_paper(top, corner).x, 1e-3);
            EXPECT_NEAR(on_paper(front, corner).y, on_paper(right, corner).y, 1e-3);
        }
    }
}

TEST(Sheet, LengthsAreWhatTheScaleSays) {
    const Box box;
    for (const auto& [scale, factor] :
         {std::pair{"1:1", 1.0}, {"1:2", 0.5}, {"2:1", 2.0}, {"1:10", 0.1}}) {
        SCOPED_TRACE(scale);
        const auto lines = lines_of(to_dxf(box.sheet({.page = parse_page("a1"), .scale = scale})));
        std::multiset<long> found; // thousandths of a millimetre
        for (auto [at, end] = lines.equal_range("front-crease"); at != end; ++at) {
            found.insert(std::lround(at->second.length() * 1000));
        }
        const auto length = [&, own = factor](double size) {
            return std::lround(own * size * 1000);
        };
        EXPECT_EQ(found, (std::multiset<long>{length(50), length(50), length(120), length(120)}));
    }
}

TEST(Sheet, TheUnitOfTheModelCounts) {
    const Box box{{0, 0, 0}, {4, 2, 1}};
    const auto lines = lines_of(to_dxf(box.sheet({.scale = "1:1", .unit = 25.4})));
    std::set<long> found;
    for (auto [at, end] = lines.equal_range("front-crease"); at != end; ++at)
        found.insert(std::lround(at->second.length() * 1000));
    EXPECT_EQ(found, (std::set<long>{50800, 101600}));
}

TEST(Sheet, TheScaleIsTheLargestStandardOneThatFits) {
    EXPECT_EQ(Box{}.layout().scale, "1:1");
    EXPECT_EQ((Box{{0, 0, 0}, {1200, 500, 700}}.layout().scale), "1:10");
    EXPECT_EQ((Box{{0, 0, 0}, {1.2F, 0.5F, 0.7F}}.layout().scale), "100:1");
    EXPECT_EQ(Box{}.layout({.page = parse_page("a4")}).scale, "1:2");
    try {
        Box{}.layout({.scale = "2:1"});
        FAIL() << "not refused";
    } catch (const UsageError& error) {
        EXPECT_NE(std::string{error.what()}.find("1:1 fits"), std::string::npos) << error.what();
    }
}

TEST(Sheet, NoViewMeetsAnotherTheTitleBlockOrTheFrame) {
    for (const std::string page : {"a3", "a4", "a0", "a6", "tabloid", "900x200mm"}) {
        for (const glm::vec3 size : {glm::vec3{120, 50, 70}, {10, 200, 10}, {300, 10, 300}}) {
            SCOPED_TRACE(page);
            const SheetLayout layout = Box{{0, 0, 0}, size}.layout({.page = parse_page(page)});
            std::vector<SheetView> boxes = layout.views;
            SheetView block;
            block.low = layout.size;
            for (const SheetLine& line : layout.lines) {
                if (line.layer != "title-block") continue;
                for (const glm::dvec2 point : line.points) {
                    block.low = glm::min(block.low, point);
                    block.high = glm::max(block.high, point);
                }
            }
            boxes.push_back(block);
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                EXPECT_GE(boxes[i].low.x, 20) << i;
                EXPECT_GE(boxes[i].low.y, 10) << i;
                EXPECT_LE(boxes[i].high.x, layout.size.x - 10) << i;
                EXPECT_LE(boxes[i].high.y, layout.size.y - 10) << i;
                for (std::size_t k = 0; k < i; ++k)
                    EXPECT_TRUE(
                        boxes[i].low.x > boxes[k].high.x || boxes[k].low.x > boxes[i].high.x ||
                        boxes[i].low.y > boxes[k].high.y || boxes[k].low.y > boxes[i].high.y)
                        << i << " meets " << k;
            }
        }
    }
}

TEST(Sheet, APageStandsOrLiesAsIso5457HasIt) {
    EXPECT_EQ(Box{}.layout({.page = parse_page("a4")}).size, (glm::dvec2{210, 297}));
    EXPECT_EQ(Box{}.layout({.page = parse_page("a3")}).size, (glm::dvec2{420, 297}));
    EXPECT_EQ(Box{}.layout({.page = parse_page("300x400mm")}).size, (glm::dvec2{300, 400}));
}

TEST(Sheet, ViewsAreNamedInAList) {
    EXPECT_EQ(parse_views("front,top"), (std::vector<std::string>{"front", "top"}));
    EXPECT_EQ(parse_views("30,-20.5,back"), (std::vector<std::string>{"30,-20.5", "back"}));
    EXPECT_EQ(parse_views("front,section:-x=5%,30,20"),
              (std::vector<std::string>{"front", "section:-x=5%", "30,20"}));
    EXPECT_EQ(parse_views("front,section:1,2,3/0,-1,1,30,20"),
              (std::vector<std::string>{"front", "section:1,2,3/0,-1,1", "30,20"}));
    for (const char* wrong : {"section:1,2,3", "section:1,2,3/0,1", "section:1,2,3/0,0,0"})
        EXPECT_THROW(parse_views(wrong), UsageError) << wrong;
    for (const char* wrong : {"", "front,", "front,,top", "middle", "front,30", "front,top,front"})
        EXPECT_THROW(parse_views(wrong), UsageError) << wrong;
    EXPECT_THROW(lay_out_sheet({}), UsageError);
    EXPECT_THROW(Box{}.layout({.unit = 0}), UsageError);
    EXPECT_THROW(Box{}.layout({.page = parse_page("80x80mm")}), UsageError);
    try {
        Box{}.layout({.views = {"front", "30,20", "40,20", "50,20", "back", "left"},
                      .page = parse_page("a6"),
                      .measures = true});
        FAIL() << "not refused";
    } catch (const UsageError& error) {
        EXPECT_NE(std::string{error.what()}.find("no room for so many views"), std::string::npos)
            << error.what();
    }
}

TEST(Sheet, SvgHasAGroupForEachView) {
    const pugi::xml_document svg = parsed(
        to_svg(Box{}.sheet({.views = {"front", "30,20"}, .fields = {.title = "Box & lid"}})));
    EXPECT_STREQ(svg.child("svg").attribute("width").value(), "420mm");
    EXPECT_STREQ(svg.child("svg").child("title").text().get(), "Box & lid");
    const pugi::xml_node front = group(svg, "front");
    EXPECT_EQ(std::ranges::distance(front.child("g").children("path")), 4);
    EXPECT_STREQ(front.child("g").attribute("id").value(), "front-crease");
    EXPECT_TRUE(group(svg, "view_30_20"));
    EXPECT_TRUE(group(svg, "frame"));
    std::set<std::string> texts;
    for (const pugi::xml_node text : group(svg, "title-block").children("text"))
        texts.insert(text.text().get());
    for (const char* text : {"Box & lid", "1:1", "A3"}) EXPECT_TRUE(texts.contains(text)) << text;
}

TEST(Sheet, PensAreAsWideOnEveryPage) {
    Style style;
    style.pen.width = 2;
    style.made_for = 100;
    for (const std::string page : {"a4", "a1"}) {
        const pugi::xml_document svg =
            parsed(to_svg(Box{}.sheet({.page = parse_page(page)}, style)));
        EXPECT_NEAR(group(svg, "front").child("g").attribute("stroke-width").as_double(),
                    2 * 25.4 / 96, 1e-4);
    }
}

TEST(Sheet, ViewsShareALinetype) {
    Style style;
    style.pen.mark = "chain";
    const SheetOptions options{.views = {"front", "top", "right", "isometric", "30,20"}};
    const std::string dxf = to_dxf(Box{}.sheet(options, style));
    EXPECT_NE(dxf.find("\nCENTER\n"), std::string::npos);
    EXPECT_EQ(dxf.find("\nCENTER2\n"), std::string::npos);
}

TEST(Sheet, PictorialViewsShowNoHiddenLines) {
    Style style;
    style.hidden = true;
    const SheetLayout layout = Box{}.layout();
    EXPECT_TRUE(style_of_view(style, view_named(layout, "front")).hidden);
    EXPECT_FALSE(style_of_view(style, view_named(layout, "isometric")).hidden);
}

TEST(Sheet, TheSymbolSaysTheAngle) {
    const auto side_of_rings = [](ProjectionAngle angle) {
        const SheetLayout layout = Box{}.layout({.angle = angle});
        const auto cone = std::ranges::find_if(layout.lines, [](const SheetLine& line) {
            return line.layer == "title-block" && line.points.size() == 5 &&
                   line.points[0].y != line.points[1].y && line.points[0].x != line.points[1].x;
        });
        return layout.circles.front().center.x - cone->points.front().x;
    };
    EXPECT_LT(side_of_rings(ProjectionAngle::third), 0);
    EXPECT_GT(side_of_rings(ProjectionAngle::first), 0);
    EXPECT_EQ(parse_projection_angle("first"), ProjectionAngle::first);
    EXPECT_THROW(parse_projection_angle("second"), UsageError);
}

TEST(Sheet, LongTextsStayInTheirFields) {
    SheetFields fields;
    set_field(fields, "title", std::string(500, 'W'));
    set_field(fields, "owner", "Ärzte & Söhne");
    EXPECT_THROW(set_field(fields, "colour", "red"), UsageError);
    const SheetLayout layout = Box{}.layout({.fields = fields});
    const auto title = std::ranges::find_if(
        layout.texts, [](const SheetText& text) { return text.text.ends_with("W..."); });
    ASSERT_NE(title, layout.texts.end());
    EXPECT_LT(static_cast<double>(title->text.size()) * 0.85 * title->height, 110);
    EXPECT_NE(to_dxf(Box{}.sheet({.fields = fields})).find("\\U+00C4rzte & S\\U+00F6hne"),
              std::string::npos);
}

std::set<std::string> texts_of(const SheetLayout& layout, const std::string& layer) {
    std::set<std::string> found;
    for (const SheetText& text : layout.texts)
        if (text.layer == layer) found.insert(text.text);
    return found;
}

TEST(Sheet, MeasuresAreTheSizesOfTheModel) {
    const Box box{{-31.3F, 17.7F, 5.1F}, {120.25F, 50, 70.5F}};
    for (const char* scale : {"1:1", "1:10"}) {
        const VectorSheet sheet =
            box.sheet({.page = parse_page("a1"), .scale = scale, .measures = true});
        EXPECT_EQ(sheet.model_size, (glm::dvec3{120.25, 50, 70.5}));
        EXPECT_EQ(texts_of(sheet.layout, "dimensions"),
                  (std::set<std::string>{"120.25", "50", "70.5"}));
        EXPECT_EQ(texts_of(sheet.layout, "axes"), (std::set<std::string>{"X", "Y", "Z"}));
    }
    const VectorSheet inches = box.sheet({.scale = "1:50", .unit = 25.4, .measures = true});
    EXPECT_NEAR(inches.model_size.y, 1270, 1e-3);
    // Depth is measured only if a view shows it.
    EXPECT_EQ(box.sheet({.views = {"front"}, .measures = true}).model_size.z, 0);
    const VectorSheet lying = box.sheet({.views = {"front"}, .up = {0, 0, 1}, .measures = true});
    EXPECT_EQ(lying.model_size, (glm::dvec3{120.25, 0, 70.5}));
    EXPECT_EQ(box.sheet({.views = {"isometric"}, .measures = true}).model_size, glm::dvec3{0});
    EXPECT_EQ(texts_of(box.sheet().layout, "dimensions").size(), 0U);
}

TEST(Sheet, ANumberWithoutRoomStandsBehindItsDimension) {
    const auto anchor = [](const char* scale) {
        const SheetLayout layout =
            Box{{0, 0, 0}, {12.25F, 30, 30}}.sheet({.scale = scale, .measures = true}).layout;
        return std::ranges::find(layout.texts, "12.25", &SheetText::text)->anchor;
    };
    EXPECT_EQ(anchor("2:1"), TextAnchor::middle);
    EXPECT_EQ(anchor("1:2"), TextAnchor::start);
}

TEST(Sheet, WhatIsFlatHasNoDimension) {
    const VectorSheet sheet = Box{{0, 0, 0}, {12, 50, 0}}.sheet({.measures = true});
    EXPECT_EQ(sheet.model_size, (glm::dvec3{12, 50, 0}));
    EXPECT_EQ(texts_of(sheet.layout, "dimensions"), (std::set<std::string>{"12", "50"}));
}

TEST(Sheet, TheScaleBarStandsClearOfTheTitleBlock) {
    for (const char* page : {"a4", "a3", "a6", "297x210mm"}) {
        SCOPED_TRACE(page);
        const SheetLayout layout = Box{}.sheet({.page = parse_page(page), .measures = true}).layout;
        const SheetBox block = title_block_of(frame_of(layout.size));
        for (const SheetLine& line : layout.lines) {
            if (line.layer != "scale-bar") continue;
            for (const glm::dvec2 point : line.points)
                EXPECT_FALSE(block.meets({point, point}, 1)) << point.x << " " << point.y;
        }
    }
}

TEST(Sheet, TheScaleBarIsToScale) {
    const SheetLayout layout = Box{}.sheet({.scale = "1:2", .measures = true}).layout;
    const auto bar = std::ranges::find(layout.lines, "scale-bar", &SheetLine::layer);
    EXPECT_NEAR(glm::distance(bar->points[0], bar->points[1]), 50, 1e-9);
    EXPECT_TRUE(texts_of(layout, "scale-bar").contains("100 mm"));
}

TEST(Sheet, WhatIsRoundIsMeasuredAsItIs) {
    VectorDrawing drawing{.size = {100, 100}, .groups = {}, .paths = {}};
    VectorPath arc; // a third of a circle, its highest point in the middle
    for (const double x : {41.34, 58.66}) arc.points.push_back({.at = {x, 45}});
    arc.curves.push_back({.first = 0,
                          .last = 1,
                          .arc = {.center = {50, 50},
                                  .major = {10, 0},
                                  .from = -5 * std::numbers::pi / 6,
                                  .sweep = 2 * std::numbers::pi / 3}});
    drawing.paths = {arc};
    EXPECT_NEAR(drawn_box(drawing).low.y, 40, 1e-9);
    EXPECT_NEAR(drawn_box(drawing).high.y, 45, 1e-9);
    EXPECT_TRUE(drawn_box(drawing).exact);
    arc.curves[0].cubic = {{41.34, 35}, {58.66, 35}};
    drawing.paths = {arc};
    EXPECT_NEAR(drawn_box(drawing).low.y, 45 - 0.75 * 10, 1e-9);
    EXPECT_FALSE(drawn_box(drawing).exact);
}

std::vector<SheetLine> lines_on(const SheetLayout& layout, const std::string& layer, double width) {
    std::vector<SheetLine> found;
    for (const SheetLine& line : layout.lines)
        if (line.layer == layer && line.width == width) found.push_back(line);
    return found;
}

TEST(Sheet, ASectionStandsWhereItsSideWould) {
    const Box box;
    const glm::vec3 corner = box.high;
    const auto layout = [&](std::vector<std::string> views) {
        return box.layout({.views = std::move(views)});
    };
    const SheetLayout alone = layout({"front", "section:x=10"});
    const SheetView& section = alone.views[1];
    EXPECT_EQ(section.letter, "A");
    EXPECT_EQ(section.cut->normal, (glm::dvec3{1, 0, 0})); // looks as the right does
    EXPECT_GT(section.low.x, alone.views[0].high.x);
    EXPECT_NEAR(on_paper(alone.views[0], corner).y, on_paper(section, corner).y, 1e-3);
    const SheetLayout left = layout({"front", "section:-x=10"});
    EXPECT_EQ(left.views[1].cut->normal, (glm::dvec3{-1, 0, 0}));
    EXPECT_LT(left.views[1].high.x, left.views[0].low.x);
    const SheetLayout above = layout({"front", "section:y=50%"});
    EXPECT_LT(above.views[1].high.y, above.views[0].low.y);
    EXPECT_NEAR(on_paper(above.views[0], corner).x, on_paper(above.views[1], corner).x, 1e-3);
    // The right is taken, so the section is on the right of that.
    const SheetLayout taken = layout({"section:x=10", "section:x=20", "front", "right"});
    EXPECT_GT(view_named(taken, "section:x=10").low.x, view_named(taken, "right").high.x);
    EXPECT_GT(taken.views[1].low.x, taken.views[0].high.x);
    EXPECT_EQ(taken.views[1].letter, "B");
    EXPECT_EQ(texts_of(taken, "sections"), (std::set<std::string>{"A", "B", "A-A", "B-B"}));
}

TEST(Sheet, ThePlaneOfASectionIsALineWithArrows) {
    const Box box;
    for (const char* scale : {"1:1", "1:2"}) {
        SCOPED_TRACE(scale);
        const SheetLayout layout = box.layout(
            {.views = {"front", "section:x=10"}, .page = parse_page("a2"), .scale = scale});
        const SheetView& front = layout.views[0];
        const double x = on_paper(front, {10, 0, 0}).x;
        const double top = on_paper(front, box.high).y, bottom = on_paper(front, box.low).y;
        std::vector<SheetLine> thick = lines_on(layout, "sections", 0.5);
        std::erase_if(thick, [](const SheetLine& line) { return line.points.size() > 2; }); // heads
        ASSERT_EQ(thick.size(), 4U); // two ends and two arrows
        for (const std::size_t end : {0U, 1U}) {
            const SheetLine& line = thick[end];
            EXPECT_NEAR(line.points[0].x, x, 1e-3);
            EXPECT_NEAR(line.points[1].x, x, 1e-3);
            EXPECT_NEAR(line.points[0].y, end == 0 ? top - 3 : bottom + 3, 1e-3);
            EXPECT_NEAR(line.points[1].y, end == 0 ? top - 10 : bottom + 10, 1e-3);
        }
        for (const std::size_t arrow : {2U, 3U}) { // looks to the left, as the right view does
            EXPECT_NEAR(thick[arrow].points[0].x, x, 1e-3);
            EXPECT_NEAR(thick[arrow].points[1].x, x + 9, 1e-3);
        }
        double dashes = 0, longest = 0, dots = 0;
        for (const SheetLine& line : lines_on(layout, "sections", 0.25)) {
            EXPECT_NEAR(line.points[0].x, x, 1e-3);
            const double length = glm::distance(line.points[0], line.points[1]);
            (length < 0.2 ? dots : dashes) += 1;
            longest = std::max(longest, length);
        }
        EXPECT_EQ(dashes, dots + 1);
        EXPECT_NEAR(longest, 6, 1); // 24 times the width
        for (const SheetText& text : layout.texts) {
            if (text.layer != "sections") continue;
            const bool is_title = text.text == "A-A";
            EXPECT_TRUE(is_title ? text.at.y < layout.views[1].low.y : text.at.x > x + 9);
        }
    }
}

TEST(Sheet, TheLineOfASectionOfAFlatModelHasALength) {
    const Box flat{{0, 0, 0}, {120, 0, 70}};
    const SheetLayout layout = flat.layout({.views = {"front", "section:x=50%"}});
    const std::vector<SheetLine> thin = lines_on(layout, "sections", 0.25);
    EXPECT_FALSE(thin.empty());
    for (const SheetLine& line : layout.lines)
        for (const glm::dvec2 point : line.points)
            EXPECT_TRUE(std::isfinite(point.x) && std::isfinite(point.y)) << line.layer;
    for (const SheetText& text : layout.texts) EXPECT_TRUE(std::isfinite(text.at.y)) << text.text;
}

TEST(Sheet, SixtyFourViewsAreTheMost) {
    const Box box;
    SheetOptions options{.views = {"front"}};
    for (int i = 0; i < 64; ++i) options.views.push_back(std::to_string(i + 1) + ",10");
    try {
        (void)box.layout(options);
        ADD_FAILURE() << "65 views are taken";
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), "a sheet has 65 views and 0 details; 64 of each at most");
    }
}

TEST(Sheet, ASectionHasAGroupAndLayers) {
    const Box box;
    const SheetOptions options{.views = {"front", "section:z=25%"}};
    EXPECT_THROW(box.layout(options), UsageError); // the front shows no line
    const SheetOptions cut{.views = {"front", "section:y=25%"}};
    const pugi::xml_document svg = parsed(to_svg(box.sheet(cut)));
    EXPECT_TRUE(group(svg, "section_A").find_child_by_attribute("id", "section_A-crease"));
    EXPECT_TRUE(group(svg, "sections"));
    // Areas of views do not cover the line.
    EXPECT_STREQ(svg.child("svg").last_child().attribute("id").value(), "sections");
    EXPECT_NE(to_dxf(box.sheet(cut)).find("\nsection_A-crease\n"), std::string::npos);
    EXPECT_FALSE(style_of_view(Style{.hidden = true}, box.layout(cut).views[1]).hidden);
    EXPECT_THROW(make_vector_sheet(box.lines.set, box.layout(cut),
                                   [](const SheetView&) { return SeenLines{}; }, {}),
                 UsageError);
}

TEST(Sheet, AnObliqueSectionIsTurnedAboutTheLineOfItsPlane) {
    const Box box;
    const glm::vec3 middle = 0.5F * (box.low + box.high);
    // From above the plane is a line from the lower left to the upper right.
    const SheetLayout layout =
        box.layout({.views = {"section:28.7,42.7,40.1/1,0,1", "top"}, .page = parse_page("a2")});
    const SheetView &section = layout.views[0], &top = layout.views[1];
    const glm::dvec2 toward_eye = glm::normalize(glm::dvec2{1, 1});
    const auto way = [&](const SheetView& view, glm::vec3 along) {
        return on_paper(view, middle + 10.0F * glm::normalize(along)) - on_paper(view, middle);
    };
    const double length = glm::length(way(top, {1, 0, -1}));
    EXPECT_LT(glm::distance(way(section, {1, 0, -1}), way(top, {1, 0, -1})), 1e-3);
    EXPECT_LT(glm::distance(way(section, {0, 1, 0}), -length * toward_eye), 1e-3);
    EXPECT_LT(glm::length(way(section, {1, 0, 1})), 1e-3);
    EXPECT_NEAR(glm::length(section.cut->normal), 1, 1e-12);
    std::vector<SheetLine> thick = lines_on(layout, "sections", 0.5);
    std::erase_if(thick, [](const SheetLine& line) { return line.points.size() > 2; }); // heads
    ASSERT_EQ(thick.size(), 4U); // two ends and two arrows
    const glm::dvec2 at = on_paper(top, middle);
    const SheetBox around{top.low, top.high};
    for (const SheetLine& line : thick)
        EXPECT_FALSE(around.meets({line.points[1], line.points[1]}, 0.5));
    for (const std::size_t end : {0U, 1U}) {
        for (const glm::dvec2 point : thick[end].points)
            EXPECT_NEAR(glm::dot(point - at, toward_eye), 0, 1e-3);
        const std::vector<glm::dvec2>& arrow = thick[2 + end].points;
        EXPECT_LT(glm::distance(arrow[0], thick[end].points[1]), 1e-9);
        EXPECT_LT(glm::distance(arrow[1], arrow[0] + 9.0 * toward_eye), 1e-6);
    }
    for (const SheetText& text : layout.texts) {
        if (text.text != "A") continue;
        const glm::dvec2 half{2.5, 2.5}, center = text.at - glm::dvec2{0, 2.5};
        EXPECT_FALSE(around.meets({center - half, center + half}, 0));
    }
    // Pictorial views show the line of a plane that no aligned view shows.
    const SheetLayout pictorial =
        box.layout({.views = {"-45,0", "section:0,20,20/1,1,1"}, .page = parse_page("a2")});
    EXPECT_EQ(pictorial.views[1].letter, "A");
    // A plane across an axis stands where its side would, however it is written.
    const SheetLayout across =
        box.layout({.views = {"front", "section:10,0,0/2,0,0"}, .page = parse_page("a2")});
    EXPECT_GT(across.views[1].low.x, across.views[0].high.x);
    EXPECT_FALSE(across.views[1].pictorial);
}

TEST(Sheet, SectionsThatCannotBeAreRefused) {
    const auto refused = [](std::vector<std::string> views, const std::string& words) {
        try {
            Box{}.layout({.views = std::move(views), .page = parse_page("a0"), .scale = "1:100"});
            ADD_FAILURE() << "not refused: " << words;
        } catch (const UsageError& error) {
            EXPECT_NE(std::string{error.what()}.find(words), std::string::npos) << error.what();
        }
    };
    refused({"front", "section:x=200"},
            "section:x=200 misses the model, which goes from x=-31.3 to 88.7");
    refused({"front", "section:z=40"}, "section:z=40: no view shows its plane as a line; add top");
    refused({"top", "isometric", "section:y=50%"}, "add front");
    refused({"front", "section:0,20,20/0,1,1"}, "no view shows its plane as a line; add right");
    refused({"top", "section:0,20,20/1,1,0"}, "no view shows its plane as a line; add front");
    refused({"front", "section:0,20,20/1,1,1"}, "no view shows its plane as a line; add -45,0");
    refused({"right", "section:0,0,0/0,3,4"},
            "misses the model, which goes from 14.7 to 100.7 along the plane's normal");
    refused({"front", "section:w=1"}, "section \"w=1\" is none");
    refused({"front", "section:x=1", "section:x=1"}, "named twice");
    std::vector<std::string> many{"front"};
    for (int i = 0; i < 25; ++i) many.push_back("section:x=" + std::to_string(i));
    refused(many, "letters for 24 sections");
    many.pop_back();
    EXPECT_EQ(Box{}
                  .layout({.views = many, .page = parse_page("a0"), .scale = "1:100"})
                  .views.back()
                  .letter,
              "Z");
}

TEST(Sheet, SectionsAreInTheCoordinatesOfTheFile) {
    const SheetOptions options{.views = {"front", "section:x=1010", "section:x=50%"},
                               .page = parse_page("a2"),
                               .origin = {1000, 0, 0}};
    const SheetLayout layout = Box{}.layout(options);
    EXPECT_NEAR(layout.views[1].cut->point.x, 10, 1e-9);
    EXPECT_NEAR(layout.views[2].cut->point.x, 28.7, 1e-4);
}

TEST(Sheet, ADetailIsLargerAndHasALetter) {
    const Box box;
    for (const auto& [scale, own, factor] :
         {std::tuple{"1:1", "2:1", 2.0}, {"1:2", "1:1", 1.0}, {"1:5", "1:2", 0.5}}) {
        SCOPED_TRACE(scale);
        const glm::vec3 corner = box.high;
        const SheetLayout layout = box.layout({.views = {"front", "section:x=10"},
                                               .details = {{"front", corner, 12}},
                                               .page = parse_page("a2"),
                                               .scale = scale});
        ASSERT_EQ(layout.views.size(), 3U);
        const SheetView& detail = layout.views[2];
        EXPECT_EQ(detail.letter, "B");
        const glm::dvec2 size = detail.high - detail.low;
        EXPECT_NEAR(size.x, 24 * factor, 1e-9);
        EXPECT_NEAR(size.y, 24 * factor, 1e-9);
        const glm::dvec2 middle = detail.low + 0.5 * size;
        EXPECT_LT(glm::distance(on_paper(detail, corner), middle), 1e-3);
        const auto length = [&](const SheetView& view) {
            return glm::distance(on_paper(view, corner), on_paper(view, {0, corner.y, 0}));
        };
        const double of_sheet = parse_scale("", scale);
        EXPECT_NEAR(length(detail), factor / of_sheet * length(layout.views[0]), 2e-3);
        std::vector<SheetCircle> circles;
        for (const SheetCircle& circle : layout.circles)
            if (circle.layer == "details") circles.push_back(circle);
        ASSERT_EQ(circles.size(), 2U);
        EXPECT_LT(glm::distance(circles[0].center, on_paper(layout.views[0], corner)), 1e-3);
        EXPECT_NEAR(circles[0].radius, 12 * of_sheet, 1e-9);
        EXPECT_NEAR(circles[1].radius, 12 * factor, 1e-9);
        EXPECT_EQ(texts_of(layout, "details"),
                  (std::set<std::string>{"B", std::string{"B ("} + own + ")"}));
    }
}

TEST(Sheet, ViewsArePlacedByHand) {
    const Box box;
    const glm::vec3 middle = 0.5F * (box.low + box.high);
    const SheetLayout layout = box.layout(
        {.views = {"front", "isometric", "section:x=10"},
         .placements = {{"front", glm::dvec2{120, 200}}, {"isometric", glm::dvec2{300, 80}, "1:5"}},
         .details =
             {{.view = "isometric", .center = box.high, .radius = 10, .at = glm::dvec2{50, 50}}},
         .page = parse_page("a2"),
         .scale = "1:1"});
    EXPECT_LT(glm::distance(on_paper(layout.views[0], middle), {120, 200}), 1e-3);
    EXPECT_LT(glm::distance(0.5 * (layout.views[1].low + layout.views[1].high), {300, 80}), 1e-9);
    EXPECT_LT(glm::distance(on_paper(layout.views[3], box.high), {50, 50}), 1e-3);
    EXPECT_NEAR(layout.views[3].high.x - layout.views[3].low.x, 20 * 0.5, 1e-9); // 1:2 is next
    EXPECT_EQ(layout.views[0].own_scale, "");
    EXPECT_EQ(layout.views[1].own_scale, "1:5");
    EXPECT_EQ(texts_of(layout, "sections"), (std::set<std::string>{"A", "A-A", "(1:5)"}));
    // The line of the section goes where the front went.
    EXPECT_NEAR(lines_on(layout, "sections", 0.5)[0].points[0].x,
                on_paper(layout.views[0], {10, 0, 0}).x, 1e-3);
    const auto refused = [&](SheetOptions options, const std::string& words) {
        try {
            box.layout(options);
            ADD_FAILURE() << "not refused: " << words;
        } catch (const UsageError& error) {
            EXPECT_NE(std::string{error.what()}.find(words), std::string::npos) << error.what();
        }
    };
    const auto front_at = [](glm::dvec2 at, const char* scale) {
        return SheetOptions{
            .views = {"front", "top"}, .placements = {{"front", at}}, .scale = scale};
    };
    refused(front_at({30, 100}, "1:1"), "\"front\", placed at 30,100 mm, leaves the frame");
    refused(front_at({350, 250}, "1:1"), "meets the title block");
    refused(front_at({500, 250}, ""), "leaves the frame; place it elsewhere");
    refused({.views = {"front", "top"},
             .placements = {{"front", glm::dvec2{150, 100}}, {"top", glm::dvec2{150, 110}}},
             .scale = "1:1"},
            "meets \"top\"");
    refused({.views = {"front"}, .placements = {{.view = "top"}}}, "the sheet does not have it");
    refused({.views = {"front"}, .placements = {{.view = "front"}, {.view = "front"}}},
            "placed twice");
    // Views without a place may leave it at the scale of the sheet, wherever they begin.
    const Box flat{{0, 0, 0}, {300, 50, 10}};
    EXPECT_EQ((flat.layout({.views = {"top", "right", "front"},
                            .placements = {{"front", glm::dvec2{280, 194.7}, "1:10"}}})
                   .scale),
              "1:1");
    refused({.views = {"top", "front"}, .placements = {{"front", glm::dvec2{215, 148.5}, "1:5"}}},
            "meets \"top\"; place it elsewhere");
    refused({.views = {"front"},
             .details = {{.view = "front", .center = box.high, .radius = 10}},
             .scale = "5000000000:1"},
            "ISO 5455 has no scale twice as large as 5000000000:1; give the detail a scale");
    // The scale of a sheet is the largest that fits, or that of its views.
    EXPECT_EQ(box.layout(front_at({90, 100}, "")).scale, "1:1");
    EXPECT_EQ(box.layout(front_at({60, 100}, "")).scale, "1:2");
    EXPECT_EQ((box.layout({.views = {"front"}, .placements = {{"front", {}, "1:3"}}}).scale),
              "1:3");
}

TEST(Sheet, ADetailEndsAtItsCircle) {
    const Box box;
    const SheetOptions options{.views = {"front"},
                               .details = {{"front", box.high, 12, "5:1"}},
                               .page = parse_page("a2"),
                               .scale = "1:1"};
    const auto lines = lines_of(to_dxf(box.sheet(options)));
    EXPECT_EQ(lines.count("detail_A-crease"), 2U); // the two edges that meet in the corner
    for (auto [at, end] = lines.equal_range("detail_A-crease"); at != end; ++at)
        EXPECT_NEAR(at->second.length(), 60, 1e-3);
    EXPECT_TRUE(group(parsed(to_svg(box.sheet(options))), "detail_A"));
}

TEST(Sheet, DetailsThatCannotBeAreRefused) {
    const SheetDetail parsed = parse_detail("section:x=1/20,-35,0.5/8/5:1");
    EXPECT_EQ(parsed.view, "section:x=1");
    EXPECT_EQ(parsed.center, (glm::dvec3{20, -35, 0.5}));
    EXPECT_EQ(parsed.radius, 8);
    EXPECT_EQ(parsed.scale, "5:1");
    const std::string oblique = "section:1,2,3/0,1,1";
    EXPECT_EQ(parse_detail(oblique + "/4,5,6/2").view, oblique);
    EXPECT_EQ(parse_detail(oblique + "/4,5,6/2").radius, 2);
    for (const char* wrong : {"", "front", "front/1,2/8", "front/1,2,3", "front/1,2,3/0",
                              "front/1,2,3/-2", "front/1,2,3/8/big", "front/1,2,3,4/8"})
        EXPECT_THROW(parse_detail(wrong), UsageError) << wrong;
    const auto refused = [](SheetDetail detail, const std::string& words) {
        try {
            Box{}.layout(
                {.views = {"front", "top"}, .details = {std::move(detail)}, .scale = "1:2"});
            ADD_FAILURE() << "not refused: " << words;
        } catch (const UsageError& error) {
            EXPECT_NE(std::string{error.what()}.find(words), std::string::npos) << error.what();
        }
    };
    refused({"right", {0, 20, 10}, 5}, "a detail of \"right\": the sheet has no such view");
    refused({"front", {200, 20, 10}, 5}, "its circle about 200,20,10 lies beside the model");
    refused({"front", {0, 20, 10}, 5, "1:2"}, "must be larger than 1:2");
    refused({"front", {0, 20, 10}, 0}, "radius must be above 0");
    refused({"front", {0, 20, 10}, 50, "10:1"},
            "no room for views and details of their own scales");
    // A detail with a scale of its own keeps the sheet's below that.
    EXPECT_EQ((Box{}.layout({.details = {{"front", {0, 20, 10}, 5, "1:1"}}}).scale), "1:2");
}

/// A drawing with one path.
VectorDrawing drawing_of(VectorPath path) {
    VectorDrawing drawing{.size = {100, 100}, .groups = {}, .paths = {}};
    drawing.paths.push_back(std::move(path));
    return drawing;
}

TEST(Sheet, AnArcThatIsClippedStaysAnArc) {
    VectorPath whole{.closed = true, .points = {}, .pieces = {}};
    constexpr int chords = 24;
    const VectorArc arc{.center = {50, 50}, .major = {10, 0}, .sweep = 2 * std::numbers::pi};
    for (int i = 0; i <= chords; ++i) {
        whole.points.push_back({.at = arc.at(2 * std::numbers::pi * i / chords)});
        if (i < chords) whole.pieces.push_back({.point = static_cast<std::uint32_t>(i)});
    }
    whole.curves.push_back({.first = 0, .last = chords, .arc = arc});
    for (const double side : {1.0, -1.0}) { // its first point is within the circle, or is not
        VectorDrawing drawing = drawing_of(whole);
        clip_to_circle(drawing, {50 + 10 * side, 50}, 10);
        ASSERT_EQ(drawing.paths.size(), 1U);
        const VectorPath& path = drawing.paths[0];
        EXPECT_FALSE(path.closed);
        ASSERT_EQ(path.curves.size(), 1U);
        const VectorArc& part = path.curves[0].arc;
        EXPECT_NEAR(part.sweep, 2 * std::numbers::pi / 3, 1e-9);
        for (const VectorPoint& end : {path.points.front(), path.points.back()}) {
            EXPECT_NEAR(end.at.x, 50 + 5 * side, 1e-9);
            EXPECT_NEAR(glm::distance(end.at, arc.center), 10, 1e-9);
        }
        EXPECT_LT(glm::distance(part.at(part.from), path.points.front().at), 1e-9);
        EXPECT_LT(glm::distance(part.at(part.from + part.sweep), path.points.back().at), 1e-9);
        EXPECT_EQ(path.curves[0].last, path.points.size() - 1);
        EXPECT_EQ(path.pieces.size(), path.points.size() - 1);
        for (std::size_t i = 0; i < path.pieces.size(); ++i) EXPECT_EQ(path.pieces[i].point, i);
    }
    VectorDrawing within = drawing_of(whole), beside = drawing_of(whole);
    clip_to_circle(within, {50, 50}, 11);
    clip_to_circle(beside, {50, 50}, 9);
    EXPECT_TRUE(within.paths.at(0).closed);
    EXPECT_TRUE(beside.paths.empty());
}

VectorPath arc_path(const VectorArc& arc, std::uint32_t chords) {
    VectorPath path{.closed = std::abs(arc.sweep) > 6.28, .points = {}, .pieces = {}};
    for (std::uint32_t i = 0; i <= chords; ++i)
        path.points.push_back({.at = arc.at(arc.from + arc.sweep * i / chords)});
    path.curves.push_back({.first = 0, .last = chords, .arc = arc});
    return path;
}

TEST(Sheet, ASmallDetailOfALargeCurveHasIt) {
    constexpr double large = 3000, small = 10, radians = 2 * std::numbers::pi;
    for (const double ratio : {1.0, 0.5}) {
        const VectorArc arc{.major = {large, 0}, .ratio = ratio, .sweep = -radians};
        for (int i = 0; i < 100; ++i) {
            SCOPED_TRACE(i);
            const glm::dvec2 center = arc.at(0.05 + 0.0601 * i);
            VectorDrawing drawing = drawing_of(arc_path(arc, 48));
            clip_to_circle(drawing, center, small);
            ASSERT_EQ(drawing.paths.size(), 1U);
            const VectorPath& part = drawing.paths[0];
            EXPECT_NEAR(glm::distance(part.points.front().at, center), small, 1e-7);
            EXPECT_NEAR(glm::distance(part.points.back().at, center), small, 1e-7);
            EXPECT_NEAR(glm::distance(part.points.front().at, part.points.back().at), 2 * small,
                        0.001);
        }
    }
    VectorPath curve{.points = {{.at = {0, 0}}, {.at = {3000, 0}}},
                     .pieces = {{.point = 0}},
                     .curves = {{.first = 0, .last = 1}}};
    curve.curves[0].cubic = {{1000, 400}, {2000, 400}}; // x is 3000 t
    for (int i = 1; i < 100; ++i) {
        SCOPED_TRACE(i);
        const double t = i / 100.0;
        VectorDrawing drawing = drawing_of(curve);
        clip_to_circle(drawing, {3000 * t, 1200 * t * (1 - t)}, 2);
        ASSERT_EQ(drawing.paths.size(), 1U);
        const VectorPath& part = drawing.paths[0];
        EXPECT_NEAR(glm::distance(part.points.front().at, part.points.back().at), 4, 0.001);
    }
}

TEST(Sheet, APathThatStartsOnTheCircleOfADetailIsNotTurnedInsideOut) {
    const glm::dvec2 center{1234.5, 678.9};
    constexpr double radius = 37.7;
    const auto at = [&](double distance, double angle) {
        return center + distance * glm::dvec2{std::cos(angle), std::sin(angle)};
    };
    for (int i = 0; i < 200; ++i) {
        SCOPED_TRACE(i);
        const double angle = 0.03 * i;
        VectorDrawing drawing = drawing_of({.points = {{.at = at(radius, angle)},
                                                       {.at = at(2 * radius, angle)},
                                                       {.at = at(2 * radius, angle + 0.5)},
                                                       {.at = at(radius, angle + 0.5)},
                                                       {.at = center}},
                                            .pieces = {}});
        clip_to_circle(drawing, center, radius);
        ASSERT_EQ(drawing.paths.size(), 1U);
        const std::vector<VectorPoint>& points = drawing.paths[0].points;
        ASSERT_EQ(points.size(), 2U);
        EXPECT_LT(glm::distance(points[0].at, at(radius, angle + 0.5)), 1e-6);
        EXPECT_EQ(points[1].at, center);
    }
}

TEST(Sheet, WhatTouchesTheCircleOfADetailStaysWhole) {
    const VectorPath touching{.points = {{.at = {0, 10}}, {.at = {100, 10}}}, .pieces = {}};
    VectorDrawing outside = drawing_of(touching);
    clip_to_circle(outside, {50, 50}, 40);
    EXPECT_TRUE(outside.paths.empty());
    for (const double radius : {40.0, 15.0}) { // the same circle, and one that touches it within
        const VectorArc arc{
            .center = {90 - radius, 50}, .major = {radius, 0}, .sweep = 2 * std::numbers::pi};
        for (const double from : {0.0, 1.0}) {
            VectorArc turned = arc;
            turned.from = from;
            VectorDrawing drawing = drawing_of(arc_path(turned, 24));
            clip_to_circle(drawing, {50, 50}, 40);
            ASSERT_EQ(drawing.paths.size(), 1U);
            EXPECT_TRUE(drawing.paths[0].closed);
            EXPECT_EQ(drawing.paths[0].curves[0].arc.sweep, arc.sweep);
        }
    }
}

TEST(Sheet, CubicsLinesAndAreasAreClipped) {
    VectorPath curve{.points = {{.at = {40, 50}}, {.at = {50, 43.875}}, {.at = {60, 50}}},
                     .pieces = {{.point = 0}, {.point = 1}},
                     .curves = {{.first = 0, .last = 2}}};
    curve.curves[0].cubic = {{42, 41.8}, {58, 41.9}};
    VectorDrawing drawing = drawing_of(curve);
    clip_to_circle(drawing, {60, 50}, 8);
    const VectorPath& part = drawing.paths.at(0);
    EXPECT_NEAR(glm::distance(part.points.front().at, {60, 50}), 8, 1e-9);
    EXPECT_EQ(part.points.back().at, (glm::dvec2{60, 50}));
    ASSERT_TRUE(part.curves.at(0).cubic);
    const auto at = [](glm::dvec2 a, const VectorCubic& c, glm::dvec2 d, double t) {
        const double s = 1 - t;
        return s * s * s * a + 3 * s * s * t * c.first_control + 3 * s * t * t * c.last_control +
               t * t * t * d;
    };
    double nearest = 1e9; // the middle of the part lies on the whole
    const glm::dvec2 middle =
        at(part.points.front().at, *part.curves[0].cubic, part.points.back().at, 0.5);
    for (int i = 0; i <= 100000; ++i)
        nearest = std::min(nearest, glm::distance(middle, at({40, 50}, *curve.curves[0].cubic,
                                                             {60, 50}, i / 100000.0)));
    EXPECT_LT(nearest, 1e-4);

    VectorPath line{.points = {{.at = {0, 50}, .depth = 0.25}, {.at = {100, 50}, .depth = 0.75}},
                    .pieces = {{.point = 0, .from = 0, .to = 0.5F}, {.point = 0, .from = 0.5F}}};
    VectorDrawing straight = drawing_of(line);
    straight.fills.push_back({.object = {}, .rings = {{{0, 0}, {100, 0}, {100, 100}, {0, 100}}}});
    straight.fills.push_back({.object = {}, .rings = {{{0, 0}, {10, 0}, {10, 10}}}});
    clip_to_circle(straight, {60, 50}, 20);
    ASSERT_EQ(straight.paths.size(), 1U);
    const VectorPath& rest = straight.paths[0];
    EXPECT_NEAR(rest.points[0].at.x, 40, 1e-9);
    EXPECT_NEAR(rest.points[1].at.x, 80, 1e-9);
    EXPECT_NEAR(rest.points[0].depth, 0.45, 1e-9);
    ASSERT_EQ(rest.pieces.size(), 2U);
    EXPECT_NEAR(rest.pieces[0].to, 0.25F, 1e-6F);
    EXPECT_NEAR(rest.pieces[1].from, 0.25F, 1e-6F);
    ASSERT_EQ(straight.fills.size(), 1U);
    double area = 0;
    const std::vector<glm::dvec2>& ring = straight.fills[0].rings.at(0);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        area += 0.5 * (a.x * b.y - a.y * b.x);
    }
    EXPECT_NEAR(area, std::numbers::pi * 400, 0.05);
}

TEST(Sheet, ASheetNeedsADrawingForEachView) {
    VectorSheet sheet = Box{}.sheet();
    sheet.drawings.pop_back();
    EXPECT_THROW(to_svg(sheet), UsageError);
    EXPECT_THROW(to_dxf(sheet), UsageError);
}

} // namespace
} // namespace lineatlas
