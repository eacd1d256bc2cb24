// Sections on sheets: their places, their lines on other views, and what is refused.
#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "lineatlas/error.hpp"
#include "lineatlas/sheet.hpp"
#include "sheet_support.hpp"
#include "vector/sheet_frame.hpp"
#include "vector/title_block.hpp"

namespace lineatlas {
namespace {

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
    refused({"front", "section:w=1"}, "section \"w=1\" must be an axis");
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

} // namespace
} // namespace lineatlas
