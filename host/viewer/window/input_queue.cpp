#include <utility>

#include "window.hpp"

namespace lineatlas::viewer {

void InputQueue::on_key(int key, int scancode, int action, int mods) {
    events_.push_back(
        {Kind::alone, [=](InputListener& l) { l.on_key(key, scancode, action, mods); }});
}

void InputQueue::on_character(unsigned code) {
    events_.push_back({Kind::alone, [=](InputListener& l) { l.on_character(code); }});
}

void InputQueue::on_mouse_button(int button, int action, int mods) {
    events_.push_back(
        {Kind::alone, [=](InputListener& l) { l.on_mouse_button(button, action, mods); }});
}

void InputQueue::on_mouse_move(glm::dvec2 place) {
    events_.push_back({Kind::move, [=](InputListener& l) { l.on_mouse_move(place); }});
}

void InputQueue::on_scroll(glm::dvec2 amount) {
    events_.push_back({Kind::scroll, [=](InputListener& l) { l.on_scroll(amount); }});
}

void InputQueue::on_drop(const std::vector<std::filesystem::path>& files) {
    events_.push_back({Kind::alone, [=](InputListener& l) { l.on_drop(files); }});
}

void InputQueue::on_mouse_leave() {
    events_.push_back({Kind::alone, [](InputListener& l) { l.on_mouse_leave(); }});
}

void InputQueue::on_focus(bool focused) {
    events_.push_back({Kind::alone, [=](InputListener& l) { l.on_focus(focused); }});
}

void InputQueue::on_refresh() {
    events_.push_back({Kind::alone, [](InputListener& l) { l.on_refresh(); }});
}

void InputQueue::pass_next_to(InputListener& listener) {
    const Kind kind = events_.front().kind;
    do {
        const Event event = std::move(events_.front());
        events_.pop_front(); // the listener may add others
        event.tell(listener);
    } while (!events_.empty() && kind != Kind::alone && events_.front().kind == kind);
}

} // namespace lineatlas::viewer
