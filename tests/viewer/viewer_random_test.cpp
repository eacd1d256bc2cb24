// Random events. The viewer takes each, and comes to rest whenever they stop. A short run has one
// model in a small window. LINEATLAS_RANDOM_MINUTES: how long it goes on, with three models, whose
// memory must stay level. LINEATLAS_RANDOM_SEED: the number that the events follow from.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <random>
#include <set>

#include "support/held_memory.hpp"
#include "viewer/window/commands.hpp"
#include "viewer_support.hpp"

namespace lineatlas::test {
namespace {

using Clock = std::chrono::steady_clock;

double number_of(const char* variable, double usual) {
    const char* text = std::getenv(variable);
    return text == nullptr ? usual : std::atof(text);
}

class Chance {
  public:
    explicit Chance(unsigned seed) : numbers_(seed) {}
    std::size_t below(std::size_t count) { return numbers_() % count; }
    double share() { return static_cast<double>(below(1001)) / 1000; }
    bool once_in(std::size_t times) { return below(times) == 0; }
    template <class Items>
    decltype(auto) one_of(const Items& items) {
        return *std::next(std::begin(items), static_cast<std::ptrdiff_t>(below(std::size(items))));
    }

  private:
    std::mt19937 numbers_;
};

constexpr std::array<glm::ivec2, 4> window_sizes{{{900, 600}, {1280, 800}, {500, 400}, {700, 900}}};
constexpr std::array<glm::ivec2, 2> small_sizes{{{500, 400}, {400, 500}}};

/// A person without a plan.
class RandomHand {
  public:
    RandomHand(viewer::Application& application, std::vector<std::filesystem::path> files,
               std::vector<glm::ivec2> sizes, unsigned seed)
        : app_(application), files_(std::move(files)), sizes_(std::move(sizes)), chance_(seed) {}

    /// Does something, and shows some frames.
    void act() {
        struct Act {
            const char* name;
            void (RandomHand::*run)();
        };
        static const std::array<Act, 14> acts{{{"move", &RandomHand::move},
                                               {"click", &RandomHand::click},
                                               {"click_item", &RandomHand::click_item},
                                               {"click_item", &RandomHand::click_item},
                                               {"drag", &RandomHand::drag},
                                               {"scroll", &RandomHand::scroll},
                                               {"run_command", &RandomHand::run_command},
                                               {"tap", &RandomHand::tap},
                                               {"hold_key", &RandomHand::hold_key},
                                               {"type_text", &RandomHand::type_text},
                                               {"drop", &RandomHand::drop},
                                               {"change_window", &RandomHand::change_window},
                                               {"find_command", &RandomHand::find_command},
                                               {"type_number", &RandomHand::type_number}}};
        const Act act = chance_.one_of(acts);
        std::printf("%d: %s\n", acts_++, act.name); // before it, in case that it is the last
        std::fflush(stdout);
        (this->*act.run)();
        for (std::size_t i = chance_.below(4); i > 0; --i) app_.step(0);
        if (chance_.once_in(4)) app_.step(0.03);
    }
    /// Lets go of everything and closes what is open.
    void let_go() {
        for (int button = 0; button < 3; ++button) input().on_mouse_button(button, GLFW_RELEASE, 0);
        input().on_focus(false);
        input().on_focus(true);
        app_.step(0);
        for (int i = 0; i < 8; ++i) press_and_release(GLFW_KEY_ESCAPE, 0);
        app_.step(0);
    }
    int acts() const { return acts_; }

  private:
    viewer::InputListener& input() { return app_.input(); }

    int mods() {
        constexpr std::array all{0,
                                 0,
                                 0,
                                 GLFW_MOD_SHIFT,
                                 GLFW_MOD_CONTROL,
                                 GLFW_MOD_ALT,
                                 GLFW_MOD_SHIFT | GLFW_MOD_CONTROL};
        return chance_.one_of(all);
    }
    glm::dvec2 place() {
        return glm::dvec2{chance_.share(), chance_.share()} * glm::dvec2{app_.window().points()};
    }
    void press_and_release(int key, int mods) {
        input().on_key(key, 0, GLFW_PRESS, mods);
        if (chance_.once_in(8)) app_.step(0);
        input().on_key(key, 0, GLFW_RELEASE, 0);
    }
    void button(int button, int action, int mods) { input().on_mouse_button(button, action, mods); }
    void click_at(glm::dvec2 place, int which, int mods) {
        input().on_mouse_move(place);
        button(which, GLFW_PRESS, mods);
        button(which, GLFW_RELEASE, mods);
        if (!chance_.once_in(6)) return;
        button(which, GLFW_PRESS, mods);
        button(which, GLFW_RELEASE, mods);
    }
    std::string item() {
        const auto& items = app_.ui().spots.all();
        const std::string name = items.empty() ? "" : chance_.one_of(items).first;
        return name == "entry:../" ? "" : name; // leads out of the test's folder
    }
    std::optional<glm::dvec2> place_of(const std::string& name) {
        const std::optional<viewer::Area> area = app_.ui().spots.find(name);
        if (!area) return {};
        return area->low + 0.5F * area->size;
    }
    void type(const std::u32string& text) {
        for (const char32_t letter : text) input().on_character(letter);
    }

    void move() { input().on_mouse_move(place()); }
    void click() {
        constexpr std::array buttons{GLFW_MOUSE_BUTTON_LEFT, GLFW_MOUSE_BUTTON_LEFT,
                                     GLFW_MOUSE_BUTTON_RIGHT, GLFW_MOUSE_BUTTON_MIDDLE};
        click_at(place(), chance_.one_of(buttons), mods());
    }
    void click_item() {
        if (const auto at = place_of(item())) click_at(*at, GLFW_MOUSE_BUTTON_LEFT, mods());
    }
    void drag() {
        const auto from = chance_.once_in(2) ? place_of(item()) : place();
        if (!from) return;
        const int which = static_cast<int>(chance_.below(3));
        input().on_mouse_move(*from);
        button(which, GLFW_PRESS, mods());
        for (std::size_t i = chance_.below(5); i > 0; --i) {
            input().on_mouse_move(place());
            if (chance_.once_in(2)) app_.step(0);
        }
        if (!chance_.once_in(8)) button(which, GLFW_RELEASE, 0);
    }
    void scroll() {
        constexpr std::array clicks{-1, 1, -8, 8, -200, 200};
        input().on_mouse_move(place());
        input().on_scroll({0, chance_.one_of(clicks)});
    }
    void run_command() {
        const viewer::Command& command = chance_.one_of(viewer::commands());
        if (command.key != GLFW_KEY_Q) press_and_release(command.key, command.mods);
    }
    void tap() {
        constexpr std::array others{GLFW_KEY_ENTER,  GLFW_KEY_TAB,      GLFW_KEY_SPACE,
                                    GLFW_KEY_UP,     GLFW_KEY_DOWN,     GLFW_KEY_LEFT,
                                    GLFW_KEY_RIGHT,  GLFW_KEY_ESCAPE,   GLFW_KEY_HOME,
                                    GLFW_KEY_DELETE, GLFW_KEY_BACKSPACE};
        const int letter = GLFW_KEY_A + static_cast<int>(chance_.below(26));
        press_and_release(chance_.once_in(2) ? letter : chance_.one_of(others), mods());
    }
    void hold_key() {
        constexpr std::array ways{GLFW_KEY_W, GLFW_KEY_A, GLFW_KEY_S,
                                  GLFW_KEY_D, GLFW_KEY_Q, GLFW_KEY_E};
        const int key = chance_.one_of(ways);
        input().on_key(key, 0, GLFW_PRESS, chance_.once_in(2) ? GLFW_MOD_SHIFT : 0);
        for (std::size_t i = chance_.below(6); i > 0; --i) app_.step(0);
        input().on_key(key, 0, GLFW_RELEASE, 0);
    }
    void type_text() {
        static const std::array<std::u32string, 6> texts{U"wall",       U"x",        U"0.5",
                                                         U"Größe – 漢", U"mmnnhhxx", U"1:2"};
        type(chance_.one_of(texts));
    }
    /// Ctrl and a click on a slider lets one type its number.
    void type_number() {
        static const std::array<std::u32string, 6> numbers{U"0",  U"-1", U"1e30",
                                                           U"45", U"3",  U"-1e-30"};
        const auto at = place_of(item());
        if (!at) return;
        input().on_key(GLFW_KEY_LEFT_CONTROL, 0, GLFW_PRESS, GLFW_MOD_CONTROL);
        click_at(*at, GLFW_MOUSE_BUTTON_LEFT, GLFW_MOD_CONTROL);
        input().on_key(GLFW_KEY_LEFT_CONTROL, 0, GLFW_RELEASE, 0);
        type(chance_.one_of(numbers));
        press_and_release(GLFW_KEY_ENTER, 0);
    }
    void drop() {
        if (chance_.once_in(3)) input().on_drop({chance_.one_of(files_)});
    }
    void change_window() {
        const glm::ivec2 size = chance_.one_of(sizes_);
        if (chance_.once_in(3)) glfwSetWindowSize(app_.window().handle(), size.x, size.y);
        if (chance_.once_in(3)) input().on_mouse_leave();
        if (chance_.once_in(3)) input().on_focus(chance_.once_in(2));
    }
    /// By the palette.
    void find_command() {
        static const std::array<std::u32string, 8> words{
            U"save", U"record", U"section", U"remove", U"next", U"parallel", U"section", U"keep"};
        press_and_release(GLFW_KEY_P, GLFW_MOD_CONTROL);
        type(chance_.one_of(words));
        press_and_release(GLFW_KEY_ENTER, 0);
    }

    viewer::Application& app_;
    std::vector<std::filesystem::path> files_;
    std::vector<glm::ivec2> sizes_;
    Chance chance_;
    int acts_ = 0;
};

class ViewerRandom : public testing::Test {
  protected:
    ViewerRandom() {
        std::filesystem::current_path(folder_.path()); // what is saved without a folder
        write("boxes.obj", box("Größe – 漢", {-2, 0, 0}, 1) + box("Bolt M8", {2, 0, 0}, 9) +
                               box("Nut", {0, 3, 0}, 17));
        write("torus.obj", torus(minutes_ > 0 ? 400 : 40));
        write("broken.stl", "solid");
        write("thick.toml", "width = 6\nhidden = true\n");
        write("camera.json", R"({"keys": [{"frame": 0, "eye": [9, 7, 5], "target": [0, 0, 0]}]})");
    }
    ~ViewerRandom() override { std::filesystem::current_path(before_); }
    viewer::Session& session() { return app_.session(); }
    std::filesystem::path path(const char* name) const { return folder_.path() / name; }
    void write(const char* name, const std::string& text) const {
        std::ofstream{path(name)} << text;
    }

    /// Shows frames until the picture is final. The limit is for a viewer that never is.
    bool comes_to_rest() {
        const Clock::time_point end = Clock::now() + std::chrono::minutes{1};
        for (int quiet = 0; quiet < 5;) {
            if (Clock::now() > end) return false;
            const std::uint64_t before = app_.frames_shown();
            app_.step(0.02);
            const bool busy = session().loader.busy() || session().drawing() ||
                              session().navigation.gliding() || session().recording() ||
                              session().refining() || session().can_refine();
            const bool same = before == app_.frames_shown() || !session().messages.all().empty() ||
                              ImGui::GetIO().WantTextInput; // which have frames of their own
            quiet = busy || !same ? 0 : quiet + 1;
        }
        return true;
    }
    std::string state() {
        return std::string{"loading "} + (session().loader.busy() ? "1" : "0") + ", drawing " +
               (session().drawing() ? "1" : "0") + ", stale " + (session().stale() ? "1" : "0") +
               ", refining " + (session().refining() ? "1" : "0") + ", view " +
               (is_finite() ? "finite" : "not finite");
    }
    bool is_finite() {
        const auto all = [](glm::vec3 v) {
            return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
        };
        const View& view = session().navigation.view();
        return all(view.eye) && all(view.target) && all(view.up) && std::isfinite(view.fov_y);
    }
    /// Keeps the hand from files that are not the test's.
    void stay_in_folder() {
        const std::string inside = folder_.path().string();
        if (!app_.ui().folder.starts_with(inside)) app_.ui().folder = inside;
        if (!app_.ui().open.folder.string().starts_with(inside))
            app_.ui().open.folder = folder_.path();
    }
    /// Opens one of the models, with nothing else as it was made by events.
    void begin(std::size_t model) {
        glfwSetWindowSize(app_.window().handle(), sizes_[0].x, sizes_[0].y);
        app_.ui().folder = folder_.path().string();
        app_.ui().open.folder = folder_.path();
        app_.ui().record_frames = 4;
        session().adds = false;
        session().settings = {};
        session().changed();
        if (model == 0)
            session().open_scene("house");
        else
            session().open(path(model == 1 ? "boxes.obj" : "torus.obj"));
        EXPECT_TRUE(comes_to_rest()) << state();
    }
    void note_errors() {
        for (const auto& message : session().messages.all()) {
            if (!message.error || !errors_.insert(message.text).second) continue;
            EXPECT_TRUE(is_expected(message.text)) << message.text;
        }
    }

    /// Whether the viewer may say so: about files that are broken or not there, and about what
    /// was typed.
    static bool is_expected(const std::string& error) {
        std::printf("says: %s\n", error.c_str());
        constexpr std::array words{"broken.stl",   "no such file",           "scale",
                                   "cannot write", "cannot make the folder", "section"};
        return std::ranges::any_of(
            words, [&](const char* word) { return error.find(word) != std::string::npos; });
    }

    const double minutes_ = number_of("LINEATLAS_RANDOM_MINUTES", 0);
    const std::vector<glm::ivec2> sizes_ =
        minutes_ > 0 ? std::vector<glm::ivec2>{window_sizes.begin(), window_sizes.end()}
                     : std::vector<glm::ivec2>{small_sizes.begin(), small_sizes.end()};
    const std::filesystem::path before_ = std::filesystem::current_path();
    TemporaryFolder folder_;
    ImageWriter writer_;
    viewer::Application app_{{.size = sizes_[0], .scale = 1, .seconds_a_step = 0.02}, writer_};
    std::set<std::string> errors_;
};

TEST_F(ViewerRandom, EventsOfAnyKindLeaveAViewerThatWorks) {
    const auto seed = static_cast<unsigned>(number_of("LINEATLAS_RANDOM_SEED", 1));
    std::printf("LINEATLAS_RANDOM_SEED=%u\n", seed);
    RandomHand hand{app_,
                    {path("boxes.obj"), path("torus.obj"), path("broken.stl"), path("thick.toml"),
                     path("camera.json"), path("lost.obj")},
                    sizes_,
                    seed};
    constexpr int acts_a_round = 40;
    constexpr std::size_t all_models = 3;
    const std::size_t models = minutes_ > 0 ? all_models : 1;
    const Clock::time_point start = Clock::now();
    const auto minutes = [&] {
        return std::chrono::duration<double, std::ratio<60>>(Clock::now() - start).count();
    };
    std::array<std::vector<double>, all_models> megabytes;
    for (std::size_t round = 0; round < models || minutes() < minutes_; ++round) {
        begin(round % models);
        const double now = static_cast<double>(held_memory()) * 1024 / 1e6;
        std::printf("%.1f minutes, %d events, %s: %.1f MB\n", minutes(), hand.acts(),
                    session().model()->source.name().c_str(), now);
        std::fflush(stdout);
        if (minutes() > 1) megabytes.at(round % models).push_back(now);
        for (int i = 0; i < acts_a_round; ++i) {
            hand.act();
            stay_in_folder();
            note_errors();
        }
        hand.let_go();
        ASSERT_TRUE(comes_to_rest()) << state();
        ASSERT_TRUE(is_finite());
    }
    if (minutes_ <= 0) return;
    // The same model takes as much memory as before. The least of several values is without what
    // allocators keep for a while.
    constexpr double most_growth = 1.1;
    for (const std::vector<double>& all : megabytes) {
        ASSERT_GE(all.size(), 6U) << "take more minutes: each model must come several times";
        const auto middle = all.begin() + std::ssize(all) / 2;
        EXPECT_LT(*std::min_element(middle, all.end()),
                  most_growth * *std::min_element(all.begin(), middle));
    }
}

} // namespace
} // namespace lineatlas::test
