// The panel that exports drawings writes the same as the tool, and to scale.

#include <algorithm>
#include <cmath>

#include "viewer_support.hpp"

namespace lineatlas::test {
namespace {

/// A box of 2 units in the view from the front. Units are millimetres by default.
class ViewerExport : public Viewer {
  protected:
    ViewerExport() {
        std::ofstream{path("m.obj")} << box("Base", {-2, 0, 0}, 1) + box("Bolt M8", {2, 0, 0}, 9);
        hand_.drop(path("m.obj"));
        hand_.key(GLFW_KEY_1);
        hand_.key(GLFW_KEY_E, GLFW_MOD_CONTROL);
    }
    viewer::ExportOptions& options() { return app_.ui().exporting.options; }
    const std::string& problem() { return session().preview_problem(); }

    /// Lets the tool draw the viewer's saved files under another name.
    void draw_by_tool(const std::string& arguments, const std::string& output) const {
        const std::string command = std::string{LINEATLAS_TOOL} + " draw " + path("m.obj") + " " +
                                    arguments + " -o " + path(output);
        EXPECT_EQ(std::system(command.c_str()), 0) << command;
    }
    /// The text of a drawing without its settings.
    static std::string drawn_in(std::string text) {
        const std::size_t from = text.find("<desc>"), to = text.find("</desc>");
        return from < to && to != std::string::npos ? text.erase(from, to - from) : text;
    }
};

TEST_F(ViewerExport, APageIsWhatTheToolDraws) {
    hand_.save(viewer::SavedKind::camera);
    hand_.click("export.print");
    hand_.click("export.svg");
    EXPECT_EQ(app_.ui().exporting.name, "m.svg");
    hand_.screenshot("export_print");
    hand_.click("export.save");
    EXPECT_EQ(error(), "");
    EXPECT_EQ(app_.ui().panel, viewer::Panel::none);
    draw_by_tool("--size 968x760 --page a4 --margin 10mm --camera-path " + path("m.json"),
                 "tool.%d.svg");
    EXPECT_EQ(drawn_in(text_of(path("m.svg"))), drawn_in(text_of(path("tool.0.svg"))));
}

TEST_F(ViewerExport, DxfIsToScale) {
    hand_.click("export.laser");
    hand_.choose("export.scale", "1:2");
    hand_.screenshot("export_laser");
    EXPECT_EQ(problem(), "");
    hand_.click("export.save");
    const std::string dxf = text_of(path("m.dxf"));
    EXPECT_NEAR(extent_of(dxf, 0).length(), 3, 1e-3) << "6 mm of two boxes";
    EXPECT_NEAR(extent_of(dxf, 1).length(), 1, 1e-3);
    hand_.key(GLFW_KEY_E, GLFW_MOD_CONTROL);
    EXPECT_EQ(app_.ui().exporting.name, "m-2.dxf") << "nothing is overwritten unasked";
    EXPECT_EQ(options().scale, "1:2") << "as it was last";
}

TEST_F(ViewerExport, AScaleIsTyped) {
    const auto type = [&](const char* scale) {
        hand_.click("export.scale.text");
        hand_.type(scale);
        hand_.key(GLFW_KEY_ENTER);
    };
    hand_.click("export.laser");
    type("0.4");
    EXPECT_EQ(options().scale, "1:2.5");
    EXPECT_EQ(app_.ui().exporting.scale, "1:2.5") << "the field says how it is written";
    type("1:0.75");
    EXPECT_EQ(problem(), "");
    hand_.screenshot("export_typed");
    type("half");
    EXPECT_NE(problem().find("\"half\""), std::string::npos) << problem();
    EXPECT_EQ(problem().find('\n'), std::string::npos);
    hand_.screenshot("export_typed_wrong");
    hand_.click("export.save");
    EXPECT_FALSE(std::filesystem::exists(path("m.dxf")));
    type("1:0.75");
    hand_.click("export.save");
    EXPECT_NEAR(extent_of(text_of(path("m.dxf")), 0).length(), 6 / 0.75, 1e-3);
    hand_.key(GLFW_KEY_E, GLFW_MOD_CONTROL);
    EXPECT_EQ(app_.ui().exporting.scale, "1:0.75") << "as it was last";
    hand_.choose("export.scale", "as large as fits");
    EXPECT_EQ(app_.ui().exporting.scale, "");
}

TEST_F(ViewerExport, TheScreenComesBackWithItsFormats) {
    using viewer::Purpose;
    const auto purpose_of = [&](const char* format) {
        hand_.click(format);
        return options().purpose;
    };
    ASSERT_EQ(options().purpose, Purpose::screen);
    EXPECT_EQ(purpose_of("export.pdf"), Purpose::print);
    EXPECT_EQ(purpose_of("export.png"), Purpose::screen);
    EXPECT_EQ(purpose_of("export.dxf"), Purpose::laser);
    EXPECT_EQ(purpose_of("export.pdf"), Purpose::print);
    EXPECT_EQ(purpose_of("export.svg"), Purpose::screen);
    hand_.click("export.print");
    EXPECT_EQ(purpose_of("export.png"), Purpose::print) << "chosen by a person";
    hand_.click("export.screen");
    EXPECT_EQ(purpose_of("export.pdf"), Purpose::print);
    hand_.click("export.sheet");
    EXPECT_EQ(purpose_of("export.png"), Purpose::print) << "the screen has no sheets";
}

TEST(ViewerScales, AreWrittenAsRatios) {
    EXPECT_EQ(viewer::scale_of_text("0.4"), "1:2.5");
    EXPECT_EQ(viewer::scale_of_text("2"), "2:1");
    EXPECT_EQ(viewer::scale_of_text("0.333"), "0.333:1") << "to the last digit";
    EXPECT_EQ(viewer::scale_of_text("1 : 2.5"), "1:2.5");
    EXPECT_EQ(viewer::scale_of_text(""), "");
    EXPECT_EQ(viewer::scale_of_text("1:"), "1:");
}

TEST_F(ViewerExport, AScaleThatDoesNotFitIsSaidBeforeAnythingIsWritten) {
    hand_.click("export.print");
    hand_.choose("export.scale", "50:1");
    EXPECT_NE(problem().find("fits"), std::string::npos) << problem();
    hand_.screenshot("export_problem");
    hand_.click("export.save");
    EXPECT_FALSE(std::filesystem::exists(path("m.pdf")));
    EXPECT_EQ(app_.ui().panel, viewer::Panel::exporting);
    hand_.choose("export.page", "A0");
    EXPECT_EQ(problem(), "") << "30 cm";
}

TEST_F(ViewerExport, ASheetOfViewsIsWhatTheToolDraws) {
    hand_.click("export.plotter");
    hand_.click("export.sheet");
    hand_.click("export.side.isometric");
    hand_.choose("export.page", "A3");
    ASSERT_EQ(options().views, (std::vector<std::string>{"front", "top", "right"}));
    EXPECT_EQ(session().preview(options(), 400).pictures.size(), 3U);
    hand_.screenshot("export_sheet");
    hand_.click("export.save");
    EXPECT_EQ(error(), "");
    const std::string style =
        " --style plain --no-tags --transparent --views front,top,right --page a3";
    session().use_style("plain");
    draw_by_tool(style, "tool.svg");
    EXPECT_EQ(drawn_in(text_of(path("m.svg"))), drawn_in(text_of(path("tool.svg"))));
}

TEST_F(ViewerExport, PixelsOnPaperAreAsManyAsItNeeds) {
    hand_.click("export.print");
    hand_.click("export.png");
    hand_.choose("export.scale", "2:1");
    hand_.click("export.save");
    const Image image = read_image(path("m.png"));
    EXPECT_NEAR(image.size.x, 277 / 25.4 * 300, 10) << "A4 on its side, within margins";
    EXPECT_NEAR(image.size.y, 190 / 25.4 * 300, 10);
    int low = image.size.x, high = 0;
    for (int y = 0; y < image.size.y; ++y)
        for (int x = 0; x < image.size.x; ++x)
            if (image.pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.x) +
                              static_cast<std::size_t>(x)) *
                             static_cast<std::size_t>(image.channels)] < 128) {
                low = std::min(low, x);
                high = std::max(high, x);
            }
    EXPECT_NEAR(high - low, 12 / 25.4 * 300, 12) << "6 mm, twice as large, and a line's width";
}

TEST_F(ViewerExport, TheScreenIsSavedWithMorePixels) {
    hand_.choose("export.pixels", "1936 x 1520");
    hand_.click("export.save");
    EXPECT_EQ(read_image(path("m.png")).size, (glm::ivec2{1936, 1520}));
}

TEST_F(ViewerExport, IsDoneByKeysAlone) {
    EXPECT_EQ(app_.ui().panel, viewer::Panel::exporting);
    hand_.key(GLFW_KEY_H);
    EXPECT_FALSE(session().settings.style.hidden) << "letters are no shortcuts here";
    hand_.click("export.name");
    hand_.key(GLFW_KEY_A, GLFW_MOD_CONTROL);
    hand_.type("front");
    hand_.key(GLFW_KEY_ENTER);
    EXPECT_TRUE(std::filesystem::exists(path("front.png")) ||
                std::filesystem::exists(path(app_.ui().exporting.name + ".png")));
    hand_.key(GLFW_KEY_E, GLFW_MOD_CONTROL);
    hand_.key(GLFW_KEY_ESCAPE);
    EXPECT_EQ(app_.ui().panel, viewer::Panel::none);
}

} // namespace
} // namespace lineatlas::test
