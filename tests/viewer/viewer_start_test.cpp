// The first minute: an empty window, its offers, and the names and tooltips of its controls.

#include <algorithm>
#include <array>

#include <imgui_internal.h>

#include "viewer_support.hpp"

namespace lineatlas::test {
namespace {

class ViewerStart : public testing::Test {
  protected:
    viewer::Session& session() { return app_.session(); }
    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

    TemporaryFolder folder_;
    ImageWriter writer_;
    viewer::Application app_{{.size = {1280, 800}, .scale = 1, .scripted = true}, writer_};
    ViewerDriver hand_{app_};
};

TEST_F(ViewerStart, AnEmptyWindowOpensFilesAndExamples) {
    std::ofstream{path("nut.obj")} << box("Nut", {0, 0, 0}, 1);
    std::ofstream{path("recent")} << path("nut.obj") << '\n'
                                  << path("lost.obj") << '\n'
                                  << path("nut.obj") << '\n';
    session().recent = viewer::RecentFiles{path("recent")};
    EXPECT_EQ(session().recent.all().size(), 1U) << "once each, and those that are there";
    hand_.panel_frames(3);
    hand_.screenshot("start");
    EXPECT_TRUE(hand_.has("start.recent:nut.obj"));
    hand_.click("start.open");
    EXPECT_EQ(app_.ui().panel, viewer::Panel::open);
    EXPECT_FALSE(hand_.has("start.open")) << "one panel at a time";
    hand_.key(GLFW_KEY_ESCAPE);
    hand_.click("example.ship");
    EXPECT_EQ(session().model()->source.name(), "ship");
    EXPECT_FALSE(hand_.has("start.open"));
}

/// By what is in sight alone: no key and no command is known.
TEST_F(ViewerStart, FromAnEmptyWindowToADrawingOfAPartAtAScale) {
    std::ofstream{path("valve.obj")}
        << box("Cover", {0, 0, 4}, 1) + box("Disc", {0, 0, 0}, 9) + box("Seat", {0, 0, -4}, 17);
    app_.ui().folder = folder_.path().string();
    app_.ui().open.folder = folder_.path();
    session().up = glm::vec3{0, 1, 0};
    hand_.panel_frames(3);
    hand_.click("start.open");
    hand_.click("entry:valve.obj");
    ASSERT_NE(session().model(), nullptr);
    hand_.click("front");
    const glm::dvec2 middle = hand_.at_shares({0.5, 0.5});
    hand_.drag(GLFW_MOUSE_BUTTON_RIGHT, middle, middle);
    hand_.click("menu:Hide");
    EXPECT_EQ(session().settings.shown.parts.hidden.size(), 1U) << "the cover is before the disc";
    hand_.drag(GLFW_MOUSE_BUTTON_RIGHT, middle, middle);
    hand_.click("menu:Show alone");
    hand_.click("export");
    hand_.click("export.dxf");
    hand_.choose("export.scale", "1:2");
    hand_.screenshot("first_drawing");
    EXPECT_EQ(session().preview_problem(), "");
    hand_.click("export.save");
    const std::string dxf = text_of(path("valve.dxf"));
    EXPECT_EQ(session().model()->mesh->triangles.size(), 12U) << "the disc alone";
    EXPECT_NEAR(extent_of(dxf, 0).length(), 1, 1e-3) << "its side of 2 mm";
    EXPECT_NEAR(extent_of(dxf, 1).length(), 1, 1e-3);
    EXPECT_TRUE(session().messages.all().back().text.starts_with("Saved"));
}

TEST_F(ViewerStart, PanelsCloseEachOther) {
    hand_.open_scene("clevis");
    for (const auto& [key, mods, panel] :
         {std::tuple{GLFW_KEY_F1, 0, viewer::Panel::keys},
          {GLFW_KEY_O, GLFW_MOD_CONTROL, viewer::Panel::open},
          {GLFW_KEY_E, GLFW_MOD_CONTROL, viewer::Panel::exporting},
          {GLFW_KEY_P, GLFW_MOD_CONTROL, viewer::Panel::palette}}) {
        hand_.key(key, mods);
        EXPECT_EQ(app_.ui().panel, panel);
        const auto there = [&](const char* spot) { return hand_.has(spot) ? 1 : 0; };
        EXPECT_EQ(there("help.close") + there("open.close") + there("export.close") +
                      there("palette.search"),
                  1);
    }
}

TEST_F(ViewerStart, TheAxesShowHowTheModelStandsAndLead) {
    hand_.open_scene("house");
    const auto from = [&] {
        const View& view = session().navigation.view();
        return glm::normalize(view.eye - view.target);
    };
    hand_.click("axis.X");
    EXPECT_GT(from().x, 0.999F);
    hand_.rest();
    hand_.click("axis.Y");
    EXPECT_GT(from().y, 0.999F) << "from above, though up is the same axis";
    hand_.click("axis.-Z");
    EXPECT_LT(from().z, -0.999F);
}

TEST_F(ViewerStart, EveryControlSaysWhatItDoes) {
    app_.ui().folded.clear();
    std::ofstream{path("m.obj")} << box("Base", {-2, 0, 0}, 1) + box("Bolt M8", {2, 0, 0}, 9);
    // Items that show their names, or are named by the items around them.
    constexpr std::array named{
        "part:", "recent:", "start.recent:", "entry:",      "command:",      "section",
        "menu:", "status:", "palette.",      "open.search", "export.preview"};
    const auto expect_tips = [&](const char* where) {
        SCOPED_TRACE(where);
        EXPECT_GT(app_.ui().spots.all().size(), 8U);
        for (const auto& [spot, area] : app_.ui().spots.all()) {
            const bool is_named = std::ranges::any_of(
                named, [&](const char* start) { return spot.starts_with(start); });
            EXPECT_TRUE(is_named || app_.ui().spots.has_tip(spot)) << spot;
        }
    };
    hand_.panel_frames(3);
    expect_tips("empty");
    hand_.drop(path("m.obj"));
    hand_.key(GLFW_KEY_C);
    hand_.key(GLFW_KEY_B);
    hand_.key(GLFW_KEY_H);
    hand_.click("part:Base");
    hand_.key(GLFW_KEY_X);
    hand_.key(GLFW_KEY_T);
    expect_tips("a model");
    for (const auto& [key, mods] :
         {std::pair{GLFW_KEY_F1, 0}, std::pair{GLFW_KEY_O, GLFW_MOD_CONTROL},
          std::pair{GLFW_KEY_E, GLFW_MOD_CONTROL}}) {
        hand_.key(key, mods);
        expect_tips("a panel");
    }
    hand_.click("export.print");
    hand_.click("export.sheet");
    expect_tips("a sheet");
}

TEST_F(ViewerStart, ATipDoesNotCoverWhatIsFoundWhileOneTypes) {
    std::ofstream{path("m.obj")} << box("Base", {-2, 0, 0}, 1) + box("Bolt M8", {2, 0, 0}, 9);
    hand_.drop(path("m.obj"));
    const auto shows_tip = [] {
        return std::ranges::any_of(ImGui::GetCurrentContext()->Windows, [](const auto* window) {
            return (window->Flags & ImGuiWindowFlags_Tooltip) != 0 && window->Active;
        });
    };
    hand_.move(hand_.middle_of("parts.search"));
    EXPECT_TRUE(shows_tip());
    hand_.click("parts.search");
    hand_.type("bolt");
    EXPECT_FALSE(shows_tip());
    hand_.move({300, 300});
    EXPECT_TRUE(hand_.has("part:Bolt M8"));
}

TEST_F(ViewerStart, TheListOfPartsGrowsWithItsDivider) {
    std::string boxes;
    for (int i = 0; i < 40; ++i)
        boxes += box("Box " + std::to_string(i), {3.0F * static_cast<float>(i), 0, 0}, 8 * i + 1);
    std::ofstream{path("boxes.obj")} << boxes;
    hand_.drop(path("boxes.obj"));
    const auto rows = [&] {
        return std::ranges::count_if(app_.ui().spots.all(), [](const auto& spot) {
            return spot.first.starts_with("part:");
        });
    };
    const auto before = rows();
    const glm::dvec2 place = hand_.middle_of("parts.divider");
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, place, place + glm::dvec2{0, 120});
    EXPECT_GT(rows(), before + 2);
}

} // namespace
} // namespace lineatlas::test
