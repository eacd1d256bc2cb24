// What the drawing thread does beside pictures, so that the window need not wait: files to save,
// the lines of another model, previews.
#include <utility>

#include "freed_memory.hpp"
#include "lineatlas/progress.hpp"
#include "session.hpp"

namespace lineatlas::viewer {

void Session::add_task(Task task) {
    tasks_.push_back(std::move(task));
}

bool Session::take_task() {
    if (tasks_.empty() || picture_ != nullptr) return false;
    if (tasks_.front().begun) {
        if (!drawing_.wait_for(std::chrono::milliseconds{0})) return false;
        const Task done = std::move(tasks_.front());
        tasks_.pop_front();
        const bool worked = attempt([&] {
            if (done.failure) std::rethrow_exception(done.failure);
        });
        done.then(worked);
    }
    if (tasks_.empty()) return true;
    Task& next = tasks_.front();
    next.begun = true;
    work_done_ = -1;
    drawing_.start([&next] { // stays where it is until it is done
        try {
            next.work();
        } catch (...) {
            next.failure = std::current_exception();
        }
    });
    return true;
}

std::string Session::work() const {
    constexpr std::chrono::milliseconds unnoticed{300};
    if (tasks_.empty() || std::chrono::steady_clock::now() - tasks_.front().added < unnoticed)
        return {};
    return tasks_.front().what;
}

void Session::add_saving(SaveFile save) {
    auto saved = std::make_shared<std::filesystem::path>();
    const auto work = [save = std::move(save), cancelled = saving_cancelled_, saved] {
        const auto go_on = [&] {
            if (*cancelled) throw Cancelled("saving was cancelled");
        };
        try {
            go_on();
            *saved = save(go_on);
        } catch (const Cancelled&) { // cancel_work() has said so
        }
    };
    const auto then = [this, saved](bool worked) {
        give_freed_memory_back(); // a page has many more pixels than the window
        if (worked && !saved->empty()) messages.notice("Saved " + saved->string());
        changed(); // the renderer's last frame is not that of the window any more
    };
    add_task({.what = saving_work, .work = work, .then = then});
}

void Session::cancel_work() {
    *std::exchange(saving_cancelled_, std::make_shared<std::atomic<bool>>(false)) = true;
    messages.notice("Nothing more is saved");
}

} // namespace lineatlas::viewer
