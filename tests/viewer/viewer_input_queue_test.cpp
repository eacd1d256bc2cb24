// The order in which the viewer gets events, and which events it gets together.

#include <string>

#include <gtest/gtest.h>

#include "viewer/window/window.hpp"

namespace lineatlas::test {
namespace {

/// Records the events that it gets.
class Heard final : public viewer::InputListener {
  public:
    void on_key(int key, int /*scancode*/, int action, int mods) override {
        text += "key" + std::to_string(key) + (action != 0 ? "+" : "-") + std::to_string(mods);
    }
    void on_character(unsigned code) override { text += "char" + std::to_string(code); }
    void on_mouse_button(int button, int action, int /*mods*/) override {
        text += "button" + std::to_string(button) + (action != 0 ? "+" : "-");
    }
    void on_mouse_move(glm::dvec2 place) override {
        text += "move" + std::to_string(static_cast<int>(place.x));
    }
    void on_scroll(glm::dvec2 amount) override {
        text += "scroll" + std::to_string(static_cast<int>(amount.y));
    }
    void on_drop(const std::vector<std::filesystem::path>& files) override {
        text += "drop" + files.front().string();
    }
    void on_mouse_leave() override { text += "leave"; }
    void on_focus(bool focused) override { text += focused ? "focus" : "blur"; }
    void on_refresh() override { text += "refresh"; }

    std::string text;
};

/// All events of the queue as text. Events that are told together are between two bars.
std::string told_by(viewer::InputQueue& queue) {
    Heard heard;
    while (!queue.empty()) {
        queue.pass_next_to(heard);
        heard.text += '|';
    }
    return heard.text;
}

TEST(InputQueue, TellsEachEventAloneInItsOrder) {
    viewer::InputQueue queue;
    queue.on_key(1, 0, 1, 2);
    queue.on_key(1, 0, 0, 2);
    queue.on_character(97);
    queue.on_character(98);
    queue.on_mouse_button(0, 1, 0);
    queue.on_mouse_button(0, 0, 0);
    queue.on_drop({"a"});
    queue.on_focus(false);
    queue.on_focus(true);
    queue.on_mouse_leave();
    queue.on_refresh();
    EXPECT_EQ(told_by(queue),
              "key1+2|key1-2|char97|char98|button0+|button0-|dropa|blur|focus|leave|"
              "refresh|");
    EXPECT_TRUE(queue.empty());
}

TEST(InputQueue, TellsMovesInARowAtOnceAndNoneAfterAButton) {
    viewer::InputQueue queue;
    queue.on_mouse_move({1, 0});
    queue.on_mouse_move({2, 0});
    queue.on_mouse_button(0, 1, 0);
    queue.on_mouse_move({3, 0});
    queue.on_scroll({0, 4});
    queue.on_scroll({0, 5});
    queue.on_mouse_move({6, 0});
    EXPECT_EQ(told_by(queue), "move1move2|button0+|move3|scroll4scroll5|move6|");
}

/// Adds an event to the queue for events that it gets.
class Adds final : public viewer::InputListener {
  public:
    explicit Adds(viewer::InputQueue& queue) : queue_(queue) {}
    void on_key(int /*key*/, int /*scancode*/, int /*action*/, int /*mods*/) override {}
    void on_character(unsigned code) override { queue_.on_character(code + 1); }
    void on_mouse_button(int /*button*/, int /*action*/, int /*mods*/) override {}
    void on_mouse_move(glm::dvec2 /*place*/) override {}
    void on_scroll(glm::dvec2 /*amount*/) override {}
    void on_drop(const std::vector<std::filesystem::path>& /*files*/) override {}
    void on_mouse_leave() override {}
    void on_focus(bool /*focused*/) override {}
    void on_refresh() override {}

  private:
    viewer::InputQueue& queue_;
};

TEST(InputQueue, TakesWhatHappensWhileItTells) {
    viewer::InputQueue queue;
    Adds adds{queue};
    queue.on_character(97);
    queue.on_character(65);
    queue.pass_next_to(adds);
    EXPECT_EQ(told_by(queue), "char65|char98|");
}

} // namespace
} // namespace lineatlas::test
