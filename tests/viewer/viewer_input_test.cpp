// No typed or tapped key is lost, and no letter of a text is a shortcut, even if pictures are slow.
// Events come from the X server through GLFW.

#include <map>

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

#include "viewer_support.hpp"

// Declared here because the header of GLFW's native access needs the headers of all extensions of
// X.
extern "C" Display* glfwGetX11Display();
extern "C" Window glfwGetX11Window(GLFWwindow* window);

namespace lineatlas::test {
namespace {

/// A keyboard. The X server passes its keys to the window, whichever window has the focus.
class Keyboard {
  public:
    explicit Keyboard(GLFWwindow* window) : window_(glfwGetX11Window(window)) {}

    void tap(KeySym key, unsigned state = 0) {
        send(KeyPress, key, state);
        send(KeyRelease, key, state);
        XSync(display_, False);
    }
    void type(const std::string& text) {
        for (const char letter : text) {
            const bool upper = letter >= 'A' && letter <= 'Z';
            tap(static_cast<KeySym>(static_cast<unsigned char>(letter)), upper ? ShiftMask : 0U);
        }
    }

  private:
    void send(int type, KeySym key, unsigned state) {
        XEvent event{};
        event.xkey.type = type;
        event.xkey.display = display_;
        event.xkey.window = window_;
        event.xkey.root = DefaultRootWindow(display_);
        event.xkey.time = ++time_; // GLFW takes two presses at the same time for one press
        event.xkey.state = state;
        event.xkey.keycode = XKeysymToKeycode(display_, key);
        event.xkey.same_screen = True;
        XSendEvent(display_, window_, False, KeyPressMask, &event);
    }

    Display* display_ = glfwGetX11Display();
    ::Window window_;
    Time time_ = 1000;
};

/// Letters a second, and the time of a picture.
struct Pace {
    int letters = 10;
    int milliseconds = 20;
};

class ViewerInput : public Viewer, public testing::WithParamInterface<Pace> {
  protected:
    ViewerInput() {
        std::ofstream{path("m.obj")} << box("Base", {-2, 0, 0}, 1) + box("Bolt M8", {2, 0, 0}, 9);
        hand_.drop(path("m.obj"));
        hand_.rest();
        style_ = session().settings;
        view_ = session().navigation.view();
    }
    /// Types a text at this pace of letters and pictures.
    void type(const std::string& text, Pace pace) {
        double due = 0;
        for (std::size_t at = 0; at < text.size();) {
            due += pace.letters * pace.milliseconds / 1000.0;
            const auto now = std::min(static_cast<std::size_t>(due), text.size() - at);
            due -= static_cast<double>(now);
            keyboard_.type(text.substr(at, now));
            at += now;
            session().changed(); // a picture is drawn
            app_.step(0);
        }
        hand_.rest();
    }
    void click(const std::string& spot) {
        const glm::dvec2 place = hand_.middle_of(spot);
        app_.input().on_mouse_move(place);
        for (const int action : {GLFW_PRESS, GLFW_RELEASE})
            app_.input().on_mouse_button(GLFW_MOUSE_BUTTON_LEFT, action, 0);
    }
    void expect_that_nothing_ran() {
        EXPECT_TRUE(viewer::same(session().settings, style_));
        EXPECT_TRUE(viewer::same(session().navigation.view(), view_));
        EXPECT_TRUE(app_.ui().sidebar);
        EXPECT_FALSE(app_.ui().timings);
        EXPECT_EQ(error(), "");
    }

    Keyboard keyboard_{app_.window().handle()};
    viewer::Settings style_;
    View view_;
};

/// A text with all letters that are shortcuts.
constexpr const char* pangram = "sphinx of black quartz judge my vow 0123456789";

TEST_P(ViewerInput, TextComesIntoAFieldWhole) {
    click("parts.search"); // the next letters come before a frame has shown the field
    type(pangram, GetParam());
    EXPECT_EQ(app_.ui().part_search, pangram);
    expect_that_nothing_ran();
}

TEST_P(ViewerInput, TextComesIntoPanelsWhole) {
    keyboard_.tap(XK_o, ControlMask);
    type(pangram, GetParam());
    EXPECT_EQ(app_.ui().open.search.searched, pangram);
    keyboard_.tap(XK_p, ControlMask); // the other panel closes
    type(pangram, GetParam());
    EXPECT_EQ(app_.ui().palette.searched, pangram);
    keyboard_.tap(XK_Escape);
    hand_.rest();
    EXPECT_EQ(app_.ui().panel, viewer::Panel::none);
    expect_that_nothing_ran();
}

INSTANTIATE_TEST_SUITE_P(Paces, ViewerInput,
                         testing::Values(Pace{10, 20}, Pace{10, 300}, Pace{10, 2000}, Pace{40, 20},
                                         Pace{40, 300}, Pace{40, 2000}),
                         [](const auto& pace) {
                             return std::to_string(pace.param.letters) + "LettersASecond" +
                                    std::to_string(pace.param.milliseconds) + "Milliseconds";
                         });

class ViewerTaps : public ViewerInput {};

TEST_F(ViewerTaps, ReturnIsSeenHoweverShort) {
    for (int i = 0; i < 12; ++i) {
        keyboard_.tap(XK_p, ControlMask);
        keyboard_.type("split screen");
        keyboard_.tap(XK_Return);
        hand_.rest();
        EXPECT_EQ(session().settings.split, i % 2 == 0) << i;
        EXPECT_EQ(app_.ui().panel, viewer::Panel::none);
    }
}

TEST_F(ViewerTaps, KeysThatFlyMoveTheCameraHoweverShort) {
    keyboard_.tap(XK_w);
    hand_.rest();
    EXPECT_FALSE(viewer::same(session().navigation.view(), view_));
    const View moved = session().navigation.view();
    for (int i = 0; i < 10; ++i) app_.step(0.01);
    EXPECT_TRUE(viewer::same(session().navigation.view(), moved)) << "the key is up";
}

TEST_F(ViewerTaps, EachEventIsDoneInItsOrder) {
    // Within one frame a field is filled and left, two files are saved, and a shortcut follows.
    click("parts.search");
    keyboard_.type("bolt");
    keyboard_.tap(XK_Return);
    keyboard_.tap(XK_e, ControlMask | ShiftMask);
    keyboard_.tap(XK_e, ControlMask | ShiftMask);
    keyboard_.tap(XK_h);
    hand_.rest();
    EXPECT_EQ(app_.ui().part_search, "bolt");
    EXPECT_TRUE(std::filesystem::exists(path("m.png")));
    EXPECT_TRUE(std::filesystem::exists(path("m-2.png"))) << "the second is another one";
    EXPECT_NE(session().settings.style.hidden, style_.style.hidden) << "a shortcut again";
}

TEST_F(ViewerTaps, ASliderThatIsDraggedWithinAFrameGoesAllTheWay) {
    hand_.reveal("width");
    const glm::dvec2 place = hand_.middle_of("width");
    viewer::InputListener& input = app_.input();
    input.on_mouse_move(place);
    input.on_mouse_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS, 0);
    input.on_mouse_move(place + glm::dvec2{10, 0});
    input.on_mouse_move(place + glm::dvec2{40, 0});
    input.on_mouse_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE, 0);
    hand_.rest();
    EXPECT_GT(session().settings.style.pen.width, 6);
}

TEST_F(ViewerTaps, ArrowsAndEnterChooseInPanels) {
    keyboard_.tap(XK_p, ControlMask);
    keyboard_.type("look from");
    keyboard_.tap(XK_Down);
    keyboard_.tap(XK_Down);
    keyboard_.tap(XK_Up);
    keyboard_.tap(XK_Return);
    hand_.rest();
    const View right = session().navigation.view();
    EXPECT_GT(glm::normalize(right.eye - right.target).x, 0.99F) << "the second that is found";
    std::filesystem::create_directory(path("deeper"));
    std::ofstream{path("deeper/nut.obj")} << box("Nut", {0, 0, 0}, 1);
    app_.ui().open.folder = folder_.path();
    keyboard_.tap(XK_o, ControlMask);
    keyboard_.type("deep");
    keyboard_.tap(XK_Return);
    keyboard_.type("nu");
    keyboard_.tap(XK_Return);
    hand_.rest();
    EXPECT_EQ(session().model()->source.name(), "nut.obj");
    keyboard_.tap(XK_o, ControlMask);
    keyboard_.type(path("m.obj"));
    keyboard_.tap(XK_Return);
    hand_.rest();
    EXPECT_EQ(session().model()->source.name(), "m.obj") << "a path that is typed";
    keyboard_.tap(XK_o, ControlMask);
    keyboard_.type("lost.obj");
    keyboard_.tap(XK_Return);
    hand_.rest();
    EXPECT_NE(error().find("lost.obj"), std::string::npos) << error();
}

} // namespace
} // namespace lineatlas::test
