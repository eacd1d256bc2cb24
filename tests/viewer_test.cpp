// The viewer under a hand that is none (ViewerDriver). Needs a display: xvfb-run gives one.

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>

#include "lineatlas/style_files.hpp"
#include "temporary_folder.hpp"
#include "viewer_driver.hpp"

namespace lineatlas::test {
namespace {

std::string text_of(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream{path}.rdbuf();
    return text.str();
}

class Viewer : public testing::Test {
  protected:
    explicit Viewer(float scale = 1)
        : app_{{.size = {1280, 800}, .scale = scale, .scripted = true}, writer_} {
        app_.ui().folder = folder_.path().string();
        hand_.open_scene("clevis");
        EXPECT_TRUE(session().messages.all().empty());
    }

    viewer::Session& session() { return app_.session(); }
    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
    std::vector<std::uint8_t> picture(std::size_t side = 0) {
        return session().picture(side)->read();
    }
    std::string error() {
        for (const auto& message : session().messages.all()) {
            if (message.error) return message.text;
        }
        return {};
    }
    /// Runs the tool with what the viewer has saved.
    void draw_by_tool(const std::string& arguments, const std::string& output) const {
        const std::string command = std::string{LINEATLAS_TOOL} + " draw --scene clevis " +
                                    arguments + " --camera-path " + path("clevis.json") + " -o " +
                                    path(output);
        EXPECT_EQ(std::system(command.c_str()), 0) << command;
    }

    TemporaryFolder folder_;
    ImageWriter writer_;
    viewer::Application app_;
    ViewerDriver hand_{app_};
};

TEST_F(Viewer, MethodsAreSwitchedLive) {
    hand_.screenshot("first");
    std::vector<std::vector<std::uint8_t>> pictures;
    for (const viewer::MethodName& method : viewer::method_names) {
        hand_.choose("method", method.label);
        EXPECT_EQ(session().settings.sides[0].method, method.method);
        for (const auto& before : pictures) EXPECT_NE(picture(), before) << method.label;
        pictures.push_back(picture());
    }
    hand_.key(GLFW_KEY_M);
    EXPECT_EQ(picture(), pictures.front()) << "the first again";
    hand_.click("method.Low");
    EXPECT_EQ(session().settings.sides[0].probes, 1U);
    EXPECT_NE(picture(), pictures.front());
    EXPECT_EQ(error(), "");
}

TEST_F(Viewer, StylesAndEffectsAreSwitchedLive) {
    const auto plain = picture();
    hand_.choose("style", "charcoal");
    EXPECT_EQ(session().settings.style.pen.mark, load_style("charcoal").pen.mark);
    EXPECT_NE(picture(), plain);
    hand_.screenshot("style");
    const glm::dvec2 middle = hand_.middle_of("width");
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, middle, middle + glm::dvec2{30, 0});
    EXPECT_GT(session().settings.style.pen.width, 6);
    hand_.click("hidden");
    EXPECT_NE(session().settings.style.hidden, load_style("charcoal").hidden);
    hand_.choose("style", "plain lines");
    EXPECT_EQ(picture(), plain);
}

TEST_F(Viewer, StyleFilesAreDropped) {
    std::ofstream{path("own.toml")} << "width = 7\n";
    hand_.drop(path("own.toml"));
    EXPECT_EQ(session().settings.style.pen.width, 7);
    std::ofstream{path("own.toml")} << "widht = 7\n";
    hand_.drop(path("own.toml"));
    EXPECT_NE(error().find("widht"), std::string::npos);
    EXPECT_EQ(session().settings.style.pen.width, 7) << "all is as it was";
}

TEST_F(Viewer, KindsOfLineAreSwitchedLive) {
    const auto all = picture();
    hand_.click("lines.crease");
    EXPECT_EQ(session().settings.lines, all_line_kinds & ~mask_of(LineKind::crease));
    EXPECT_NE(picture(), all);
    hand_.click("lines.crease");
    EXPECT_EQ(picture(), all);
}

TEST_F(Viewer, DevicesAreSwitchedLive) {
    const std::string before = session().device_description();
    hand_.choose("device", "reference");
    EXPECT_EQ(session().device().compute, "reference");
    EXPECT_NE(session().device_description(), before);
    EXPECT_EQ(error(), "");
    hand_.choose("device", "automatic");
    hand_.choose("interop", "copy");
    EXPECT_EQ(session().device().interop, "copy");
    EXPECT_EQ(error(), "");
}

TEST_F(Viewer, ADeviceThatFailsIsToldAndTheOldOneStays) {
    const std::string before = session().device_description();
    const auto drawn = picture();
    app_.ui().devices.push_back({"none", {.device = "opencl:no such device"}});
    hand_.choose("device", "none");
    EXPECT_NE(error().find("no such device"), std::string::npos) << error();
    EXPECT_EQ(session().device_description(), before);
    hand_.screenshot("device_error");
    hand_.frames(3);
    EXPECT_EQ(picture(), drawn);
    hand_.click("dismiss.0");
    EXPECT_EQ(error(), "");
}

TEST_F(Viewer, SavesThePictureThatTheToolDraws) {
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, {300, 300}, {420, 350});
    hand_.choose("style", "technical");
    hand_.choose("method", "Spine test");
    for (const char* button : {"save.png", "save.style", "save.camera"}) hand_.click(button);
    EXPECT_EQ(error(), "");
    draw_by_tool("--method spine --size 968x800 --style " + path("clevis.toml"), "tool.%d.png");
    const Image saved = read_image(path("clevis.png")), tool = read_image(path("tool.0.png"));
    EXPECT_EQ(saved.size, (glm::ivec2{968, 800}));
    EXPECT_EQ(saved.pixels, tool.pixels);
    hand_.key(GLFW_KEY_S, GLFW_MOD_CONTROL);
    EXPECT_EQ(read_image(path("clevis-2.png")).pixels, tool.pixels) << "nothing is overwritten";
}

TEST_F(Viewer, SavesThePathsThatTheToolFinds) {
    hand_.choose("save.scale", "968 x 800");
    for (const char* button : {"save.svg", "save.camera"}) hand_.click(button);
    draw_by_tool("--size 968x800", "tool.%d.svg");
    const auto without_description = [](std::string svg) {
        const std::size_t from = svg.find("<desc>"), to = svg.find("</desc>");
        EXPECT_LT(from, to);
        return svg.erase(from, to - from);
    };
    EXPECT_EQ(without_description(text_of(path("clevis.svg"))),
              without_description(text_of(path("tool.0.svg"))));
}

TEST_F(Viewer, SavedCamerasAreTakenBack) {
    const View home = session().navigation.view();
    hand_.click("save.camera");
    hand_.scroll(5, {400, 400});
    EXPECT_GT(glm::distance(session().navigation.view().eye, home.eye), 0.01F);
    hand_.drop(path("clevis.json"));
    EXPECT_EQ(session().navigation.view().eye, home.eye);
    EXPECT_EQ(session().navigation.view().target, home.target);
}

TEST_F(Viewer, BrokenFilesAreToldAndNothingElse) {
    const auto drawn = picture();
    std::ofstream{path("broken.obj")} << "v 1 2\nf 1 2 3\n";
    std::ofstream{path("broken.json")} << "{";
    for (const char* name : {"broken.obj", "broken.json", "missing.ply", "picture.jpg"}) {
        hand_.drop(path(name));
        EXPECT_NE(error().find(name), std::string::npos) << error();
        if (std::string{name} == "broken.obj") hand_.screenshot("broken_file");
        EXPECT_EQ(session().model()->source.name(), "clevis");
        hand_.frames(3);
        EXPECT_EQ(picture(), drawn);
        hand_.key(GLFW_KEY_ESCAPE);
        EXPECT_EQ(error(), "");
    }
}

TEST_F(Viewer, SplitsTheScreenAtASlider) {
    hand_.choose("style", "technical");
    const auto whole = picture();
    hand_.click("split");
    hand_.choose("second", "Item buffer");
    EXPECT_EQ(picture(0), whole) << "the left side is what it was";
    ASSERT_NE(session().picture(1), nullptr);
    EXPECT_NE(picture(1), whole);
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, {968 / 2, 200}, {600, 210});
    EXPECT_NEAR(session().settings.split_at, 600.0 / 968, 0.005);
    const std::uint64_t drawn = session().frames_drawn();
    hand_.drag(GLFW_MOUSE_BUTTON_LEFT, {600, 200}, {500, 210});
    EXPECT_EQ(session().frames_drawn(), drawn) << "the slider needs no new pictures";
    const Image shown = hand_.screenshot("split");
    const auto left = picture(0), right = picture(1);
    const auto same = [&](int x, const std::vector<std::uint8_t>& side) {
        for (int y = 100; y < 700; ++y) {     // below the names of the sides
            if (y > 380 && y < 420) continue; // the handle
            const auto row = static_cast<std::size_t>(y);
            const auto column = static_cast<std::size_t>(x);
            for (std::size_t c = 0; c < 3; ++c) {
                if (shown.pixels[(row * 1280 + column) * 3 + c] !=
                    side[(row * 968 + column) * 4 + c])
                    return false;
            }
        }
        return true;
    };
    for (int x = 10; x < 490; x += 7) EXPECT_TRUE(same(x, left)) << x;
    for (int x = 510; x < 960; x += 7) EXPECT_TRUE(same(x, right)) << x;
}

TEST_F(Viewer, TheMouseMovesTheCamera) {
    const glm::dvec2 size = session().size(), from{480, 420}, to{560, 380};
    const glm::dvec3 held = session().point_at(from);
    const auto seen = [&] { return *viewer::seen_at(session().navigation.view(), held, size); };
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

TEST_F(Viewer, LoadsInTheBackgroundAndCanBeCancelled) {
    session().open_scene("ship");
    hand_.frames(2);
    ASSERT_TRUE(session().loader.busy()) << "the ship takes a second";
    hand_.screenshot("loading");
    ASSERT_TRUE(hand_.has("cancel"));
    const glm::dvec2 place = hand_.middle_of("cancel");
    for (const int action : {GLFW_PRESS, GLFW_RELEASE}) {
        app_.on_mouse_move(place);
        hand_.frames(1);
        app_.on_mouse_button(GLFW_MOUSE_BUTTON_LEFT, action, 0);
        hand_.frames(1);
    }
    EXPECT_FALSE(session().loader.busy());
    while (viewer::Loader::any_thread()) app_.step(0.01);
    hand_.rest();
    EXPECT_EQ(session().model()->source.name(), "clevis") << "the ship is not taken";
    hand_.open_scene("house");
    EXPECT_EQ(session().model()->source.name(), "house");
}

TEST(ViewerEnd, DoesNotWaitForAReader) {
    using Clock = std::chrono::steady_clock;
    ImageWriter writer;
    auto app = std::make_unique<viewer::Application>(
        viewer::ApplicationOptions{.size = {640, 400}, .scripted = true}, writer);
    app->session().open_scene("ship");
    app->step(0);
    ASSERT_TRUE(viewer::Loader::any_thread());
    app.reset();
    EXPECT_TRUE(viewer::Loader::any_thread()) << "the window was closed after the reader's end";
    const Clock::time_point start = Clock::now();
    while (viewer::Loader::any_thread() && Clock::now() - start < std::chrono::seconds{60}) {
        std::this_thread::sleep_for(std::chrono::milliseconds{20});
    }
    EXPECT_FALSE(viewer::Loader::any_thread());
}

TEST(ViewerProgram, IsSaidToBeMissingWithTheWayOut) {
    const TemporaryFolder folder;
    const std::string tool = (folder.path() / "lineatlas").string();
    std::filesystem::copy_file(LINEATLAS_TOOL, tool);
    const std::string said = (folder.path() / "said").string();
    EXPECT_NE(std::system((tool + " view model.obj 2> " + said).c_str()), 0);
    EXPECT_NE(text_of(said).find("libimgui-dev"), std::string::npos) << text_of(said);
    EXPECT_EQ(std::system((std::string{LINEATLAS_TOOL} + " view --help > " + said).c_str()), 0);
    EXPECT_NE(text_of(said).find("--ui-scale"), std::string::npos) << text_of(said);
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
}

TEST_F(Viewer, ShowsItsKeys) {
    hand_.key(GLFW_KEY_F1);
    hand_.screenshot("help");
    hand_.click("help.close");
    EXPECT_FALSE(app_.ui().help);
    hand_.key(GLFW_KEY_TAB);
    EXPECT_EQ(session().size(), (glm::ivec2{1280, 800})) << "the picture has the whole window";
}

/// The picture in docs/viewer.md.
TEST_F(Viewer, IsWhatTheDocsShow) {
    hand_.open_scene("house");
    hand_.choose("style", "ink");
    hand_.key(GLFW_KEY_X);
    hand_.key(GLFW_KEY_T);
    for (int i = 0; i < 70; ++i) {
        session().navigation.orbit({0, 0, 0}, {i < 35 ? 0.004 : -0.004, 0});
        app_.step(0);
    }
    hand_.move({20, 300});
    hand_.screenshot("viewer");
    EXPECT_EQ(error(), "");
}

class ViewerOnAFineDisplay : public Viewer {
  protected:
    ViewerOnAFineDisplay() : Viewer(1.5F) {}
};

TEST_F(ViewerOnAFineDisplay, LettersAndPanelsAreLarger) {
    EXPECT_EQ(session().size(), (glm::ivec2{1280 - 312 * 3 / 2, 800}));
    hand_.choose("method", "Item buffer");
    EXPECT_EQ(session().settings.sides[0].method, Method::item_buffer);
    hand_.screenshot("fine");
}

} // namespace
} // namespace lineatlas::test
