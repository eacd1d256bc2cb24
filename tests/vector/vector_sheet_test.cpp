// Sheets: the places and scales of views, and the content of files.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "lineatlas/error.hpp"
#include "lineatlas/sheet.hpp"
#include "sheet_support.hpp"
#include "vector/drawn_box.hpp"
#include "vector/sheet_frame.hpp"
#include "vector/title_block.hpp"

namespace lineatlas {
namespace {

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

TEST(Sheet, ASheetNeedsADrawingForEachView) {
    VectorSheet sheet = Box{}.sheet();
    sheet.drawings.pop_back();
    EXPECT_THROW(to_svg(sheet), UsageError);
    EXPECT_THROW(to_dxf(sheet), UsageError);
}

} // namespace
} // namespace lineatlas
