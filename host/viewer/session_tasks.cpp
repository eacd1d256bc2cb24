// What the drawing thread does beside pictures, so that the window need not wait: files to save,
// the lines of another model, previews.
#include <new>
#include <utility>

#include "freed_memory.hpp"
#include "lineatlas/progress.hpp"
#include "saving.hpp"
#include "session.hpp"
#include "style/member_names.hpp"

namespace lineatlas::viewer {

void Session::add_task(Task task) {
    tasks_.push_back(std::move(task));
}

/// On the drawing thread.
void Session::run(Task& task) {
    try {
        task.work();
    } catch (...) {
        task.failure = std::current_exception();
    }
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
    drawing_.start([&next] { run(next); }); // it stays where it is until it is done
    return true;
}

std::string Session::work() const {
    constexpr std::chrono::milliseconds unnoticed{300};
    if (tasks_.empty() || std::chrono::steady_clock::now() - tasks_.front().added < unnoticed)
        return {};
    return tasks_.front().what;
}

void Session::add_saving(const std::filesystem::path& path, SaveFile save) {
    const auto saved = std::make_shared<bool>(false);
    const auto work = [save = std::move(save), cancelled = saving_cancelled_, saved] {
        const auto goes_on = [&] { return !*cancelled; };
        try {
            go_on(goes_on);
            save(goes_on);
            *saved = true;
        } catch (const Cancelled&) { // cancel_work() has said so
        }
    };
    const auto then = [this, path, saved](bool) {
        give_freed_memory_back(); // a page has many more pixels than the window
        if (*saved) messages.notice("Saved " + path.string());
        changed(); // the renderer's last frame is not that of the window any more
    };
    add_task({.what = saving_work, .work = work, .then = then, .path = path});
}

bool Session::can_cancel_work() const {
    const std::string what = work();
    return what == saving_work || what == video_work;
}

void Session::cancel_work() {
    if (!tasks_.empty() && tasks_.front().what == video_work) {
        stops_video_ = true;
        return messages.notice("No video is made. The pictures stay");
    }
    *std::exchange(saving_cancelled_, std::make_shared<std::atomic<bool>>(false)) = true;
    messages.notice("Nothing more is saved");
}

std::vector<std::string> Session::finish_saving() {
    outdated_ = ends_ = true;
    drawing_.wait();
    std::vector<std::string> failures;
    for (Task& task : tasks_) {
        if (task.what != saving_work) continue;
        if (!task.begun) drawing_.run([&] { run(task); });
        if (!task.failure) continue;
        try {
            std::rethrow_exception(task.failure);
        } catch (const std::bad_alloc&) {
            failures.push_back(task.path.string() + ": there is not enough memory to save it");
        } catch (const std::exception& error) {
            failures.push_back(in_words_of_the_tool(error.what()));
        }
    }
    drawing_.run([&] { tasks_.clear(); }); // with what they made there
    return failures;
}

} // namespace lineatlas::viewer
