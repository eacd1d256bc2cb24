// Switching and saving in the viewer, operated by ViewerDriver. Needs a display: xvfb-run gives
// one.

#include <algorithm>

#include "lineatlas/style_files.hpp"
#include "viewer_support.hpp"

namespace lineatlas::test {
namespace {

TEST_F(Viewer, MethodsAreSwitchedLive) {
    hand_.screenshot("first");
    std::vector<std::vector<std::uint8_t>> pictures;
    for (const viewer::MethodLabel& method : viewer::method_labels) {
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
    EXPECT_EQ(session().settings.lines, usual_line_kinds & ~mask_of(LineKind::crease));
    EXPECT_NE(picture(), all);
    hand_.click("lines.crease");
    EXPECT_EQ(picture(), all);
}

TEST_F(Viewer, DevicesAreSwitchedLive) {
    const std::string before = session().device_description();
    hand_.choose("device", "cpp");
    EXPECT_EQ(session().device().compute, "cpp");
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
    hand_.save(viewer::SavedKind::png);
    for (const char* button : {"save.style", "save.camera"}) hand_.click(button);
    EXPECT_EQ(error(), "");
    draw_by_tool("--method spine --size 968x760 --style " + path("clevis.toml"), "tool.%d.png");
    const Image saved = read_image(path("clevis.png")), tool = read_image(path("tool.0.png"));
    EXPECT_EQ(saved.size, (glm::ivec2{968, 760}));
    EXPECT_EQ(saved.pixels, tool.pixels);
    hand_.key(GLFW_KEY_E, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT);
    EXPECT_EQ(read_image(path("clevis-2.png")).pixels, tool.pixels) << "nothing is overwritten";
}

TEST_F(Viewer, SavesThePathsThatTheToolFinds) {
    hand_.save(viewer::SavedKind::svg);
    hand_.click("save.camera");
    draw_by_tool("--size 968x760", "tool.%d.svg");
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

TEST_F(Viewer, ModelsAreDropped) {
    std::ofstream{path("roof.obj")} << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                       "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    hand_.drop(path("roof.obj"));
    EXPECT_EQ(error(), "");
    EXPECT_EQ(session().model()->source.name(), "roof.obj");
    EXPECT_EQ(session().model()->lines.triangles.size(), 4U);
    EXPECT_GT(session().stats().runs, 0U) << "it is drawn, whole in the picture";
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
        for (int y = 60; y < 660; ++y) {      // below the names of the sides
            if (y > 360 && y < 400) continue; // the handle
            const auto row = static_cast<std::size_t>(y);
            const auto column = static_cast<std::size_t>(x);
            for (std::size_t c = 0; c < 3; ++c) {
                if (shown.pixels[((row + 40) * 1280 + column) * 3 + c] !=
                    side[(row * 968 + column) * 4 + c])
                    return false;
            }
        }
        return true;
    };
    for (int x = 10; x < 490; x += 7) EXPECT_TRUE(same(x, left)) << x;
    for (int x = 510; x < 960; x += 7) EXPECT_TRUE(same(x, right)) << x;
}

TEST_F(Viewer, SlowMovementsLeaveOutMoreUntilTheCameraRests) {
    hand_.choose("style", "charcoal");
    const auto slow = [&] { // three pictures, because a single one might be chance
        for (int i = 0; i < 3; ++i) session().note_duration(1);
    };
    const auto turn = [&] {
        session().navigation.orbit({0, 0, 0}, {0.02, 0});
        hand_.panel_frames(1);
        slow();
    };
    turn();
    turn();
    EXPECT_EQ(session().economy(), viewer::Economy::pixels);
    EXPECT_EQ(session().picture(0)->size(), (session().size() + 1) / 2);
    hand_.screenshot("half_as_many_pixels");
    hand_.rest();
    EXPECT_EQ(session().economy(), viewer::Economy::none);
    EXPECT_EQ(session().picture(0)->size(), session().size());
    const auto whole = picture();
    hand_.frames(1);
    EXPECT_EQ(picture(), whole);
    slow();
    turn();
    EXPECT_EQ(session().economy(), viewer::Economy::pixels) << "from the first picture on";
    session().navigation.orbit({0, 0, 0}, {-0.02, 0});
    hand_.rest();
    EXPECT_EQ(picture(), whole) << "back where it was";
}

TEST_F(Viewer, PicturesOfFewerPixelsFillTheSameWindow) {
    hand_.click("split");
    hand_.choose("second", "Exact");
    hand_.move({300, 300}); // no tooltip shows
    const Image whole = hand_.screenshot("split_whole");
    for (int i = 0; i < 3; ++i) session().note_duration(1);
    session().navigation.orbit({0, 0, 0}, {1e-4, 0});
    hand_.panel_frames(1);
    ASSERT_EQ(session().economy(), viewer::Economy::pixels);
    const Image half = hand_.screenshot("split_half");
    // Counts ink in each quarter of the picture, below the names of the sides.
    for (int quarter = 0; quarter < 4; ++quarter) {
        const auto ink = [&](const Image& image) {
            std::uint64_t sum = 0;
            for (int y = quarter / 2 * 350 + 100; y < quarter / 2 * 350 + 450; ++y) {
                for (int x = quarter % 2 * 484; x < quarter % 2 * 484 + 484; ++x)
                    sum += 255U - image.pixels[static_cast<std::size_t>((y * 1280 + x) * 3)];
            }
            return static_cast<double>(sum);
        };
        EXPECT_NEAR(ink(half), ink(whole), 0.15 * ink(whole)) << quarter;
    }
}

TEST_F(Viewer, LargeModelsMoveByTheirLongLines) {
    std::ostringstream text;
    for (int i = 0; i < 9000; ++i) // cubes of 12 edges, 6 pixels long when all are in the picture
        text << box("Box",
                    {3.0F * static_cast<float>(i % 95), 3.0F * static_cast<float>(i / 95), 0},
                    8 * i + 1);
    std::ofstream{path("boxes.obj")} << text.str();
    hand_.drop(path("boxes.obj"));
    hand_.key(GLFW_KEY_1);
    ASSERT_GT(session().model()->lines.segments.size(), 100'000U);
    const auto whole = picture();
    const auto turn = [&](double way) {
        session().navigation.orbit({0, 0, 0}, {way, 0});
        hand_.panel_frames(1);
    };
    const auto has_ink = [&] {
        const auto pixels = picture();
        return std::ranges::any_of(pixels, [](std::uint8_t value) { return value < 128; });
    };
    for (int i = 0; i < 3; ++i) session().note_duration(1);
    const std::uint64_t drawn = session().frames_drawn();
    hand_.rest();
    EXPECT_LE(session().frames_drawn(), drawn + 1);
    EXPECT_EQ(picture(), whole) << "what is prepared for movements shows nothing";
    turn(0.02);
    ASSERT_EQ(session().economy(), viewer::Economy::details);
    EXPECT_FALSE(has_ink()) << "all lines are short";
    session().navigation.orbit({0, 0, 0}, {-0.02, 0});
    hand_.rest();
    EXPECT_EQ(picture(), whole);
    // In a view from nearby the edges are long.
    for (int i = 0; i < 3; ++i) session().note_duration(1);
    session().navigation.dolly({142, 142, 0}, 0.1);
    hand_.rest();
    for (int i = 0; i < 3; ++i) session().note_duration(1);
    hand_.rest();
    turn(0.02);
    ASSERT_EQ(session().economy(), viewer::Economy::details);
    EXPECT_TRUE(has_ink());
    EXPECT_EQ(error(), "");
}

TEST_F(Viewer, PanelsAreLightOrDarkAndFold) {
    const auto sample = [&](const char* name) {
        const Image image = hand_.screenshot(name);
        // A pixel of the sidebar.
        return image.pixels[static_cast<std::size_t>(3 * (image.size.x - 3))];
    };
    const auto drawing = picture();
    EXPECT_GT(sample("light"), 200);
    hand_.key(GLFW_KEY_L);
    EXPECT_LT(sample("dark"), 60);
    EXPECT_EQ(picture(), drawing);
    hand_.key(GLFW_KEY_T);
    hand_.frames(4);
    hand_.screenshot("dark_timings");
    hand_.key(GLFW_KEY_L);
    EXPECT_GT(sample("light_again"), 200);
    EXPECT_TRUE(hand_.has("width"));
    hand_.click("section:style");
    EXPECT_FALSE(hand_.has("width"));
    hand_.click("section:style");
    EXPECT_TRUE(hand_.has("width"));
}

TEST_F(Viewer, ThePictureFollowsTheWindow) {
    glfwSetWindowSize(app_.window().handle(), 1000, 700);
    for (int i = 0; i < 200 && app_.window().points() != glm::ivec2{1000, 700}; ++i)
        app_.step(0.02);
    hand_.rest();
    EXPECT_EQ(session().size(), (glm::ivec2{1000 - 312, 700 - 40}));
    EXPECT_EQ(session().picture(0)->size(), session().size());
}

} // namespace
} // namespace lineatlas::test
