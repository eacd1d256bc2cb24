// Drawings as SVG in other programs: rasterised by librsvg and Chromium, and as PDF by poppler,
// compared with the tool's own picture. Also the messages about wrong options of drawings.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "ink.hpp"
#include "tool.hpp"

namespace lineatlas::test {
namespace {

class DrawingTest : public Tool {
  protected:
    /// Draws all lines, as paths do. Pictures leave out some dense lines by default.
    void draw(const std::string& what) {
        for (const char* extension : {".png", ".svg"}) {
            const Result result =
                run("draw " + what + " --density 0 -o " + path(std::string{"a"} + extension));
            ASSERT_EQ(result.exit_code, 0) << result.output;
        }
    }

    void expect_same(const std::string& raster, double least) {
        expect_same_ink(Ink{path("a.png")}, Ink{path(raster)}, least);
    }

    void rasterise() {
        const std::string command = "rsvg-convert -o " + path("r.png") + " " + path("a.svg");
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
    }

    void rasterise_pdf() {
        const std::string command =
            "pdftocairo -png -r 96 -singlefile " + path("a.pdf") + " " + path("p");
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
    }

    std::string text_of(const std::string& name) {
        std::ostringstream text;
        text << std::ifstream{path(name)}.rdbuf();
        return text.str();
    }
};

TEST_F(DrawingTest, LibrsvgAndPopplerShowWhatWeDraw) {
    if (!is_installed("rsvg-convert") || !is_installed("pdftocairo"))
        GTEST_SKIP() << "rsvg-convert or pdftocairo is not installed";
    for (const char* scene : {"clevis", "house", "ship", "office"}) {
        SCOPED_TRACE(scene);
        draw(std::string{"--scene "} + scene);
        rasterise();
        expect_same("r.png", 0.995);
        ASSERT_EQ(run(std::string{"draw --density 0 --scene "} + scene + " -o " + path("a.pdf"))
                      .exit_code,
                  0);
        rasterise_pdf();
        expect_same("p.png", 0.995);
    }
}

TEST_F(DrawingTest, DashesAndPaperOfAPdfAreThoseOfTheSvg) {
    if (!is_installed("pdftocairo") || !is_installed("rsvg-convert"))
        GTEST_SKIP() << "pdftocairo or rsvg-convert is not installed";
    for (const char* extension : {".svg", ".pdf"}) {
        ASSERT_EQ(run("draw --scene house --hidden --set paper=#ffffd0 --set hidden-width=3 "
                      "--set hidden-color=#000000 -o " +
                      path(std::string{"a"} + extension))
                      .exit_code,
                  0);
    }
    rasterise();
    rasterise_pdf();
    expect_same_ink(Ink{path("r.png")}, Ink{path("p.png")}, 0.995);
    const Image ours = read_image(path("r.png")), theirs = read_image(path("p.png"));
    EXPECT_EQ(ours.pixels[2], 0xd0);
    EXPECT_EQ(theirs.pixels[2], 0xd0);
}

TEST_F(DrawingTest, SeesALineThatIsMissing) {
    if (!is_installed("rsvg-convert")) GTEST_SKIP() << "rsvg-convert is not installed";
    draw("--scene clevis");
    std::string text = text_of("a.svg");
    const std::size_t first = text.find("  <path");
    text.erase(first, text.find("</path>", first) + 7 - first);
    std::ofstream{path("a.svg")} << text;
    rasterise();
    EXPECT_LT(Ink{path("a.png")}.share_near(Ink{path("r.png")}), 0.995);
}

TEST_F(DrawingTest, ChromiumShowsWhatWeDraw) {
    if (!is_installed("chromium")) GTEST_SKIP() << "chromium is not installed";
    draw("--scene house --size 800x600");
    const std::string command = "chromium --headless --no-sandbox --disable-gpu --hide-scrollbars "
                                "--window-size=800,600 --user-data-dir=" +
                                path("profile") + " --screenshot=" + path("c.png") + " file://" +
                                path("a.svg") + " >/dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    expect_same("c.png", 0.995);
}

TEST_F(DrawingTest, HiddenLinesHaveLayersOfTheirOwn) {
    draw("--scene clevis --size 300x200 --hidden");
    const std::string text = text_of("a.svg");
    for (const char* part : {"id=\"crease\"", "id=\"crease-hidden\"", "stroke-dasharray"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part;
    }
}

TEST_F(DrawingTest, APlottersDrawingOnPaperHasTheSizeOfThePage) {
    const Result result = run(
        "draw --scene clevis --size 300x200 --page a4 --margin 10mm --plotter -o " + path("p.svg"));
    EXPECT_EQ(result.exit_code, 0) << result.output;
    const std::string text = text_of("p.svg");
    EXPECT_NE(text.find("width=\"297mm\" height=\"210mm\" viewBox=\"0 0 297 210\""),
              std::string::npos)
        << text.substr(0, 400);
    EXPECT_EQ(text.find("edges"), std::string::npos);
}

TEST_F(DrawingTest, WidthsArePapersOnAnyPage) {
    for (const std::string page : {"a6", "a4", "a0"}) {
        const Result result = run("draw --scene clevis --size 300x200 --style technical --page " +
                                  page + " -o " + path("p.svg"));
        EXPECT_EQ(result.exit_code, 0) << result.output;
        const std::string text = text_of("p.svg");
        for (const char* width : {"stroke-width=\".5\"", "stroke-width=\".25\""})
            EXPECT_NE(text.find(width), std::string::npos) << page << ": " << width;
    }
}

TEST_F(DrawingTest, JsonHasTheKindsOfLines) {
    const Result result = run("draw --scene clevis --size 300x200 -o " + path("c.json"));
    EXPECT_EQ(result.exit_code, 0) << result.output;
    EXPECT_NE(text_of("c.json").find("\"kind\""), std::string::npos);
}

TEST_F(DrawingTest, SequencesAreResumed) {
    const std::string command =
        "draw --scene clevis --size 120x90 --turntable 3 -o " + path("f%d.svg");
    EXPECT_EQ(run(command).exit_code, 0);
    const std::string first = text_of("f0.svg");
    std::ofstream{path("f1.svg")} << first.substr(0, first.size() / 2);
    const Result again = run(command + " --resume");
    EXPECT_EQ(again.exit_code, 0);
    EXPECT_NE(again.output.find("1 frames drawn"), std::string::npos) << again.output;
    EXPECT_NE(again.output.find("2 were there already"), std::string::npos) << again.output;
}

TEST_F(DrawingTest, WrongOptionsAreRefusedByName) {
    expect_refused("draw --scene clevis --plotter -o " + path("x.png"), 2, "--plotter");
    expect_refused("draw --scene clevis --dpi 300 -o " + path("x.svg"), 2, "--page");
    expect_refused("draw --scene clevis --page a9 -o " + path("x.svg"), 2, "a9");
    expect_refused("draw --scene clevis --margin -3mm -o " + path("x.svg"), 2, "-3mm");
    expect_refused("draw --scene clevis --units furlong -o " + path("x.svg"), 2, "furlong");
    expect_refused("draw --scene clevis --units mm -o " + path("x.json"), 2, "--units");
    expect_refused("draw --scene clevis --method spine -o " + path("x.svg"), 2, "atlas");
    expect_refused("draw --scene clevis -o " + path("missing/x.svg"), 1, "missing");
}

} // namespace
} // namespace lineatlas::test
