// Drawings that are read from files.

#include "truth/drawing_file.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lineatlas/error.hpp"
#include "temporary_folder.hpp"
#include "truth/svg_path.hpp"

namespace lineatlas {
namespace {

VectorPath path(std::vector<glm::dvec2> points, bool visible = true) {
    VectorPath result;
    result.visible = visible;
    for (const glm::dvec2 at : points) result.points.push_back({.at = at});
    for (std::uint32_t i = 0; i + 1 < points.size(); ++i)
        result.pieces.push_back({.point = i, .segment = i, .source = {.from = 7 + i, .to = 8 + i}});
    return result;
}

class DrawingFileTest : public testing::Test {
  protected:
    DrawingFileTest() {
        drawing_.size = {640, 480};
        VectorPath closed = path({{10.25, 20}, {310.5, 20}, {310.5, 200.75}, {10.25, 20}});
        closed.closed = true;
        drawing_.paths = {path({{1, 1}, {600, 400}}, false), closed, path({{5, 5}, {5.5, 470}})};
        // The drawing has paths that are left out because lines are dense, and hidden paths.
        drawing_.paths.front().thinned = drawing_.paths.back().thinned = true;
    }

    DrawingFile through(const std::string& name, const std::string& text) const {
        std::ofstream{folder_ / name} << text;
        return read_drawing(folder_ / name);
    }

    void expect_legs(const DrawingFile& file, double tolerance) const {
        const std::vector<DrawnPiece> wanted = drawn_lines(drawing_).legs;
        ASSERT_EQ(wanted.size(), 4U);
        ASSERT_EQ(file.legs.size(), 4U);
        for (std::size_t i = 0; i < 4; ++i) {
            for (int axis = 0; axis < 2; ++axis) {
                EXPECT_NEAR(file.legs[i].from[axis], wanted[i].from[axis], tolerance);
                EXPECT_NEAR(file.legs[i].to[axis], wanted[i].to[axis], tolerance);
            }
        }
    }

    VectorDrawing drawing_;
    test::TemporaryFolder temporary_;
    std::filesystem::path folder_ = temporary_.path();
};

TEST_F(DrawingFileTest, SvgIsReadInPixelsWhateverItsPage) {
    for (const bool relative : {true, false}) {
        const DrawingFile file =
            through("a.svg", to_svg(drawing_, {.relative = relative, .description = "draw a.obj"}));
        EXPECT_EQ(file.size, (glm::ivec2{640, 480}));
        expect_legs(file, 0.006);
        EXPECT_EQ(file.tags.size(), 0U);
    }
    const SvgOptions on_page{.units = Unit::mm,
                             .page = parse_page("a4"),
                             .margin = parse_length("10mm", Unit::mm),
                             .description = "draw a.obj --page=a4 --margin=10mm --fov 40"};
    expect_legs(through("b.svg", to_svg(drawing_, on_page)), 0.02);
    const SvgOptions in_inches{.units = Unit::in, .description = "draw a.obj --units=in"};
    expect_legs(through("c.svg", to_svg(drawing_, in_inches)), 0.02);
}

/// Borders of fills are no lines.
TEST_F(DrawingFileTest, FillsAreLeftOut) {
    drawing_.fills = {{.object = "door",
                       .color = {1, 0.5F, 0},
                       .rings = {{{20, 30}, {300, 30}, {300, 190}, {20, 190}}}}};
    const std::string svg = to_svg(drawing_, {.description = "draw a.obj"});
    ASSERT_NE(svg.find("class=\"fill\""), std::string::npos);
    for (const DrawingFile& file :
         {through("a.svg", svg), through("a.json", to_json(drawing_, {}))}) {
        expect_legs(file, 0.006);
        EXPECT_EQ(file.path_ends, (std::vector<std::size_t>{3, 4}));
    }
}

TEST_F(DrawingFileTest, JsonHasTags) {
    const DrawingFile file = through("a.json", to_json(drawing_, {.description = "draw a.obj"}));
    EXPECT_EQ(file.size, (glm::ivec2{640, 480}));
    EXPECT_EQ(file.description, "draw a.obj");
    expect_legs(file, 0.001);
    ASSERT_EQ(file.tags.size(), 4U);
    EXPECT_EQ(file.tags[1].p, 8U);
    EXPECT_EQ(file.tags[1].q, 9U);
    LineSet lines;
    lines.sources = {{.from = 9, .to = 8}, {.from = 7, .to = 8}};
    const DrawnLines drawn = find_segments(file, lines);
    EXPECT_EQ(drawn.pieces[0].segment, 1U);
    EXPECT_EQ(drawn.pieces[1].segment, 0U); // in either direction
    EXPECT_EQ(drawn.pieces[2].segment, DrawnPiece::unknown);
}

TEST_F(DrawingFileTest, RefusesWhatIsNoDrawing) {
    const auto refused = [&](const std::string& name, const std::string& text) -> std::string {
        try {
            through(name, text);
        } catch (const FileError& error) {
            return error.what();
        }
        return "it was read";
    };
    EXPECT_NE(refused("a.svg", "<svg><desc>of another program</desc></svg>").find("no drawing of"),
              std::string::npos);
    EXPECT_NE(refused("b.svg", "hello").find("no XML"), std::string::npos);
    const std::string curved = "<svg><desc>seen at 9x9 pixels</desc><g><path d=\"m0 0q1 1 2 2\"/>"
                               "</g></svg>";
    EXPECT_NE(refused("c.svg", curved).find("no drawing of"), std::string::npos);
    EXPECT_NE(refused("a.json", "{}").find("no drawing of"), std::string::npos);
    EXPECT_NE(refused("b.json", "{\"format\":").find("damaged"), std::string::npos);
    const std::string pieces = R"({"format":"lineatlas-drawing","size":[9,9],"paths":[{"visible":)"
                               R"(true,"points":[[0,0],[1,1]],"pieces":[{"point":5}]}]})";
    EXPECT_NE(refused("c.json", pieces).find("not there"), std::string::npos);
    EXPECT_NE(refused("a.png", "x").find(".svg or .json"), std::string::npos);
}

TEST_F(DrawingFileTest, RefusesWhatNoPictureShows) {
    const auto svg = [](const std::string& told, const std::string& data) {
        return "<svg><desc>draw a.obj" + told + "</desc><g><path d=\"" + data + "\"/></g></svg>";
    };
    const std::string seen = "; 1 path, seen at 9x9 pixels";
    const std::vector<std::string> drawings{svg(seen, "M0 0L1e300 0"),
                                            svg(seen, "M0 0L1e8 0"),
                                            svg(seen, "Mnan 0L1 1"),
                                            svg(seen, "M0 0A1e300 1e300 0 0 0 1 1"),
                                            svg(seen, "M0 0Ainf inf 0 0 0 1 1"),
                                            svg("; seen at 99999999999x9 pixels", "M0 0L1 1"),
                                            svg("; seen at 65537x9 pixels", "M0 0L1 1"),
                                            svg("; seen at 9x-9 pixels", "M0 0L1 1"),
                                            svg("; seen at 9", "M0 0L1 1"),
                                            svg(" --units=ell" + seen, "M0 0L1 1"),
                                            svg(" --page=a4 --margin=1000mm" + seen, "M0 0L1 1"),
                                            svg(" --page=two\nlines" + seen, "M0 0L1 1"),
                                            svg(" --page=1e-323x1mm" + seen, "M0 0L1 1")};
    for (const std::string& text : drawings) {
        try {
            through("a.svg", text);
            ADD_FAILURE() << "read: " << text;
        } catch (const FileError& error) {
            const std::string message = error.what();
            EXPECT_NE(message.find("a.svg"), std::string::npos) << message;
            EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        }
    }
    EXPECT_EQ(through("a.svg", svg(seen, "M0 0L1 1")).legs.size(), 1U);

    const auto json = [](const std::string& size, const std::string& points,
                         const std::string& piece) {
        return R"({"format":"lineatlas-drawing","size":)" + size +
               R"(,"paths":[{"visible":true,"points":)" + points + R"(,"pieces":[{)" + piece +
               "}]}]}";
    };
    const std::string size = "[9,9]", points = "[[0,0],[1,1]]", piece = R"("point":0)";
    for (const std::string& text :
         {json("[1e300,9]", points, piece), json("[0,9]", points, piece),
          json(size, "[[0,0],[1e300,1]]", piece), json(size, points, R"("point":-1)"),
          json(size, points, R"("point":1e300)"), json(size, points, R"("point":0,"from":-1)"),
          json(size, points, R"("point":0,"part":[0,1e300])")}) {
        EXPECT_THROW(through("a.json", text), FileError) << text;
    }
    EXPECT_EQ(through("a.json", json(size, points, piece)).tags.size(), 1U);
}

TEST_F(DrawingFileTest, OptionsAreFoundInADescription) {
    const std::string text = "draw a.obj --crease=12 --style='my own' --fov 40; 3 paths";
    EXPECT_EQ(described(text, "--crease"), "12");
    EXPECT_EQ(described(text, "--style"), "my own");
    EXPECT_EQ(described(text, "--fov"), "40");
    EXPECT_EQ(described(text, "--eye"), std::nullopt);
}

TEST(SvgPath, CommandsOfStraightLines) {
    const auto lines = parse_path("M1 2L3-4h1V.5m1,1 2 2z");
    ASSERT_TRUE(lines);
    const std::vector<std::pair<glm::dvec2, glm::dvec2>> wanted{{{1, 2}, {3, -4}},
                                                                {{3, -4}, {4, -4}},
                                                                {{4, -4}, {4, .5}},
                                                                {{5, 1.5}, {7, 3.5}},
                                                                {{7, 3.5}, {5, 1.5}}};
    EXPECT_EQ(*lines, wanted);
    EXPECT_FALSE(parse_path("M1 2L3"));
    EXPECT_FALSE(parse_path("M1 2A3 0 0 0 0 5 6"));
    EXPECT_FALSE(parse_path("1 2"));
}

TEST(SvgPath, ArcsAreChords) {
    for (const auto& [data, sweep] : {std::pair{"M20 10a10 10 0 0 1-10 10", 90.0},
                                      {"M20 10A10 10 0 0 0 10 0", -90.0},
                                      {"M20 10a10 10 0 1 1-10-10", 270.0},
                                      {"M20 10A9 9 0 0 1 0 10", 180.0}}) {
        SCOPED_TRACE(data);
        const auto lines = parse_path(data);
        ASSERT_TRUE(lines);
        EXPECT_EQ(lines->front().first, (glm::dvec2{20, 10}));
        double turned = 0;
        for (const auto& [from, to] : *lines) {
            const glm::dvec2 a = from - 10.0, b = to - 10.0;
            EXPECT_NEAR(glm::length(b), 10, 1e-9);
            EXPECT_NEAR(glm::length(0.5 * (a + b)), 10, 0.002);
            turned += std::asin((a.x * b.y - a.y * b.x) / 100) * 180 / std::numbers::pi;
        }
        EXPECT_NEAR(turned, sweep, 1e-6);
    }
}

/// A quarter of an ellipse, half as wide as high, by its axes along x and y and by turned ones.
TEST(SvgPath, ArcsOfEllipsesAreToo) {
    for (const char* data :
         {"M10 0A10 20 0 0 1 0 20", "M10 0A20 10 90 0 1 0 20", "M10 0a20 10-90 0 1-10 20"}) {
        SCOPED_TRACE(data);
        const auto lines = parse_path(data);
        ASSERT_TRUE(lines);
        for (const auto& [from, to] : *lines) {
            EXPECT_NEAR(to.x * to.x / 100 + to.y * to.y / 400, 1, 1e-9);
            const glm::dvec2 middle = 0.5 * (from + to);
            EXPECT_NEAR(middle.x * middle.x / 100 + middle.y * middle.y / 400, 1, 0.002 / 5);
            EXPECT_LT(to.x, from.x);
            EXPECT_GT(to.y, from.y);
        }
    }
}

/// The cubics are a parabola.
TEST(SvgPath, CubicsAreChords) {
    for (const char* data : {"M0 0C1 0 2 3 3 9", "m0 0c1 0 2 3 3 9", "M1 1M0 0c1,0,2,3,3,9"}) {
        SCOPED_TRACE(data);
        const auto lines = parse_path(data);
        ASSERT_TRUE(lines);
        for (const auto& [from, to] : *lines) {
            EXPECT_NEAR(to.y, to.x * to.x, 1e-9);
            const glm::dvec2 middle = 0.5 * (from + to);
            EXPECT_NEAR(middle.y, middle.x * middle.x, 0.002 * (1 + 2 * middle.x));
        }
        EXPECT_EQ(lines->back().second, (glm::dvec2{3, 9}));
    }
    EXPECT_FALSE(parse_path("M0 0C1 0 2 3 3"));
}

} // namespace
} // namespace lineatlas
