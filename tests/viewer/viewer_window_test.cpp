// The viewer's window: mouse, keys, loading, rest and end. Needs a display: xvfb-run gives one.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <set>
#include <thread>

#include "lineatlas/scenes.hpp"
#include "viewer_support.hpp"
// After imgui.h.
#include <imgui_internal.h>

namespace lineatlas::test {
namespace {

TEST_F(Viewer, TheMouseMovesTheCamera) {
    const glm::dvec2 size = session().size(), from{480, 420}, to{560, 380};
    const glm::dvec3 held = session().point_at(from - hand_.in_window({0, 0}));
    const auto seen = [&] {
        return hand_.in_window(*viewer::seen_at(session().navigation.view(), held, size));
    };
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, from, to);
    EXPECT_LT(glm::distance(seen(), from), 0.05) << "orbits about what is under the mouse";
    hand_.drag(GLFW_MOUSE_BUTTON_MIDDLE, from, to);
    EXPECT_LT(glm::distance(seen(), to), 0.05) << "pans with what is under the mouse";
    hand_.scroll(3, to);
    EXPECT_LT(glm::distance(seen(), to), 0.05) << "goes to what is under the mouse";
    const glm::vec3 eye = session().navigation.view().eye;
    hand_.drag(GLFW_MOUSE_BUTTON_RIGHT, from, to);
    EXPECT_EQ(session().navigation.view().eye, eye) << "looks around";
}

TEST_F(Viewer, AtRestThePictureIsThatOfAStillFrame) {
    for (int i = 0; i < 10; ++i) {
        session().navigation.orbit({0, 0, 0}, {0.02, 0});
        app_.step(0);
    }
    hand_.rest();
    const auto rested = picture();
    session().settings.steady = false;
    session().changed();
    hand_.rest();
    EXPECT_EQ(rested, picture());
}

TEST_F(Viewer, KeysFlyAndFit) {
    const View home = session().navigation.view();
    hand_.press(GLFW_KEY_W);
    hand_.frames(5);
    hand_.release(GLFW_KEY_W);
    hand_.rest();
    EXPECT_LT(glm::distance(session().navigation.view().eye, home.target),
              glm::distance(home.eye, home.target));
    hand_.key(GLFW_KEY_3);
    hand_.screenshot("top");
    const View top = session().navigation.view();
    EXPECT_LT(glm::normalize(top.target - top.eye).y, -0.9999F);
    hand_.scroll(-8, {480, 400});
    hand_.key(GLFW_KEY_F);
    EXPECT_LT(glm::distance(session().navigation.view().eye, top.eye),
              1e-3F * glm::distance(top.eye, top.target));
}

TEST_F(Viewer, RestsWhenNothingChanges) {
    hand_.rest();
    const std::uint64_t shown = app_.frames_shown(), drawn = session().frames_drawn();
    for (int i = 0; i < 50; ++i) app_.step(0.002);
    EXPECT_EQ(app_.frames_shown(), shown);
    EXPECT_EQ(session().frames_drawn(), drawn);
    hand_.move({400, 400});
    EXPECT_GT(app_.frames_shown(), shown) << "the mouse moves over panels";
    EXPECT_EQ(session().frames_drawn(), drawn) << "the picture is kept";
}

/// A reader that does not end before it is released.
class HeldReader {
  public:
    viewer::Loader::Reader reader() {
        return [go = go_](const viewer::ModelSource& source) {
            while (!*go) std::this_thread::sleep_for(std::chrono::milliseconds{2});
            auto model = std::make_shared<viewer::Model>();
            model->source = source;
            model->mesh = std::make_shared<const Mesh>(make_scene("house").mesh);
            model->whole = model->mesh;
            return model;
        };
    }
    void let_go() { *go_ = true; }

  private:
    std::shared_ptr<std::atomic<bool>> go_ = std::make_shared<std::atomic<bool>>(false);
};

TEST_F(Viewer, LoadsInTheBackgroundAndCanBeCancelled) {
    HeldReader held;
    session().loader.set_reader(held.reader());
    session().open_scene("ship");
    app_.ui().folder = "drawings"; // docs/viewer.md shows this
    hand_.panel_frames(2);
    ASSERT_TRUE(session().loader.busy());
    hand_.screenshot("loading");
    ASSERT_TRUE(hand_.has("cancel"));
    const glm::dvec2 place = hand_.middle_of("cancel");
    for (const int action : {GLFW_PRESS, GLFW_RELEASE}) {
        app_.input().on_mouse_move(place);
        hand_.panel_frames(1);
        app_.input().on_mouse_button(GLFW_MOUSE_BUTTON_LEFT, action, 0);
        hand_.panel_frames(1);
    }
    EXPECT_FALSE(session().loader.busy());
    held.let_go();
    while (viewer::Loader::any_thread()) app_.step(0.01);
    hand_.rest();
    EXPECT_EQ(session().model()->source.name(), "clevis") << "the ship is not taken";
    hand_.open_scene("house");
    EXPECT_EQ(session().model()->source.name(), "house") << "the next one is";
}

TEST(ViewerEnd, DoesNotWaitForAReader) {
    using Clock = std::chrono::steady_clock;
    ImageWriter writer;
    auto app = std::make_unique<viewer::Application>(
        viewer::ApplicationOptions{.size = {640, 400}, .scripted = true}, writer);
    HeldReader held;
    app->session().loader.set_reader(held.reader());
    app->session().open_scene("ship");
    app->step(0);
    app.reset(); // would hang here
    EXPECT_TRUE(viewer::Loader::any_thread());
    held.let_go();
    const Clock::time_point start = Clock::now();
    while (viewer::Loader::any_thread() && Clock::now() - start < std::chrono::seconds{60}) {
        std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
    EXPECT_FALSE(viewer::Loader::any_thread());
}

TEST(ViewerProgram, IfMissingIsNamedWithThePackageToInstall) {
    const TemporaryFolder folder;
    const std::string tool = (folder.path() / "lineatlas").string();
    std::filesystem::copy_file(LINEATLAS_TOOL, tool);
    const std::string said = (folder.path() / "said").string();
    EXPECT_NE(std::system((tool + " view model.obj 2> " + said).c_str()), 0);
    EXPECT_NE(text_of(said).find("libimgui-dev"), std::string::npos) << text_of(said);
    EXPECT_EQ(std::system((std::string{LINEATLAS_TOOL} + " view --help > " + said).c_str()), 0);
    EXPECT_NE(text_of(said).find("--ui-scale"), std::string::npos) << text_of(said);
}

TEST(ViewerProgram, SaysInOneLineWhatTheMachineLacks) {
    const TemporaryFolder folder;
    const std::string said = (folder.path() / "said").string();
    for (const auto& [machine, cause] :
         {std::pair{"env -u DISPLAY -u WAYLAND_DISPLAY ", "DISPLAY"},
          {"env -u DISPLAY -u XDG_RUNTIME_DIR WAYLAND_DISPLAY=wayland-0 ", "names a display"},
          {"env -u XDG_RUNTIME_DIR DISPLAY=:999 ", "cannot open a window: X11"},
          {"env -u XDG_RUNTIME_DIR MESA_GL_VERSION_OVERRIDE=3.3 ", "needs OpenGL 4.5"}}) {
        const std::string command = machine + std::string{LINEATLAS_TOOL} + " view 2> " + said;
        EXPECT_NE(std::system(command.c_str()), 0) << machine;
        EXPECT_NE(text_of(said).find(cause), std::string::npos) << text_of(said);
        EXPECT_EQ(std::ranges::count(text_of(said), '\n'), 1) << text_of(said);
    }
}

TEST_F(Viewer, ShowsTimingsPerStage) {
    hand_.key(GLFW_KEY_T);
    for (int i = 0; i < 40; ++i) {
        session().navigation.orbit({0, 0, 0}, {0.02, 0});
        app_.step(0);
    }
    hand_.rest();
    hand_.screenshot("timings");
    const std::vector<std::string>& stages = session().timings.stages();
    for (const char* stage : {"depth", "scan", "atlas", "compact", "strokes"}) {
        EXPECT_NE(std::ranges::find(stages, stage), stages.end()) << stage;
    }
    EXPECT_GT(session().timings.frames().size(), 20U);
    EXPECT_GT(session().timings.median_total(), 0);
    hand_.click("timings.kernels");
    hand_.screenshot("kernels");
    const auto kernels = session().timings.kernels();
    ASSERT_FALSE(kernels.empty());
    for (const auto& kernel : kernels) EXPECT_GT(kernel.megabytes, 0) << kernel.name;
    hand_.click("timings.trace");
    EXPECT_NE(text_of(path("clevis.trace.json")).find("\"strokes\""), std::string::npos);
    EXPECT_EQ(error(), "");
}

TEST_F(Viewer, TheSidebarIsUsedByKeys) {
    const auto tap = [&](int key) {
        hand_.press(key);
        hand_.panel_frames(2);
        hand_.release(key);
        hand_.rest();
    };
    tap(GLFW_KEY_F6);
    const ImGuiContext& gui = *ImGui::GetCurrentContext();
    ASSERT_NE(gui.NavWindow, nullptr);
    for (int i = 0; i < 10 && gui.NavId != gui.NavWindow->GetID("parts"); ++i) tap(GLFW_KEY_DOWN);
    EXPECT_TRUE(ImGui::GetIO().NavVisible) << "one sees where one is";
    hand_.screenshot("keyboard");
    tap(GLFW_KEY_SPACE);
    EXPECT_TRUE(app_.ui().folded.contains("parts"));
}

TEST_F(Viewer, ShowsItsKeys) {
    hand_.key(GLFW_KEY_F1);
    hand_.screenshot("help");
    hand_.click("help.close");
    EXPECT_FALSE(app_.ui().panel == viewer::Panel::keys);
    hand_.key(GLFW_KEY_TAB);
    EXPECT_EQ(session().size(), (glm::ivec2{1280, 760})) << "the picture has the whole width";
}

/// The picture in docs/viewer.md.
TEST_F(Viewer, IsWhatTheDocsShow) {
    hand_.open_scene("house");
    hand_.choose("style", "ink");
    app_.ui().folder = "drawings";
    hand_.key(GLFW_KEY_X);
    hand_.scroll(40, {1180, 300});
    hand_.move({300, 300});
    hand_.screenshot("viewer");
    EXPECT_EQ(error(), "");
}

TEST_F(Viewer, NoModelLiesUnderTheToolBar) {
    hand_.move({480, 420});
    hand_.scroll(10, {480, 420}); // so near that the model reaches the border
    const Image window = hand_.screenshot("tool_bar");
    const std::vector<std::uint8_t> drawn = picture();
    constexpr std::size_t bar = 40, width = 1280 - 312;
    std::set<std::uint8_t> values;
    for (std::size_t y = 1; y < 20; ++y) { // the bar's line shades the first row
        for (std::size_t x = 0; x < width; ++x) {
            const std::uint8_t shown = window.pixels.at(3 * ((bar + y) * 1280 + x));
            ASSERT_EQ(shown, drawn.at(4 * (y * width + x))) << "row " << y << ", column " << x;
            values.insert(shown);
        }
    }
    EXPECT_GT(values.size(), 1U) << "the model reaches the border";
    EXPECT_EQ(session().size().y, 800 - static_cast<int>(bar));
}

class ViewerOnAFineDisplay : public Viewer {
  protected:
    ViewerOnAFineDisplay() : Viewer(1.5F) {}
};

TEST_F(ViewerOnAFineDisplay, LettersAndPanelsAreLarger) {
    EXPECT_EQ(session().size(), (glm::ivec2{1280 - 312 * 3 / 2, 800 - 40 * 3 / 2}));
    hand_.choose("method", "Item buffer");
    EXPECT_EQ(session().settings.sides[0].method, Method::item_buffer);
    hand_.screenshot("fine");
}

} // namespace
} // namespace lineatlas::test
