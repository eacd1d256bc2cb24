#include "drawing_thread.hpp"

#include <utility>

namespace lineatlas::viewer {

DrawingThread::DrawingThread(SharedContext& context, std::function<void()> wake)
    : context_(context), wake_(std::move(wake)), thread_([this] { work(); }) {}

DrawingThread::~DrawingThread() {
    wait();
    {
        const std::lock_guard lock{mutex_};
        ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void DrawingThread::work() {
    context_.make_current();
    for (;;) {
        std::unique_lock lock{mutex_};
        changed_.wait(lock, [&] { return work_ || ends_; });
        if (!work_) break;
        lock.unlock();
        work_();
        lock.lock();
        work_ = nullptr;
        lock.unlock();
        changed_.notify_all();
    }
    context_.release();
}

void DrawingThread::give(std::function<void()> work) {
    wait();
    {
        const std::lock_guard lock{mutex_};
        work_ = std::move(work);
    }
    changed_.notify_all();
}

void DrawingThread::run(const std::function<void()>& work) {
    std::exception_ptr failure;
    give([&] {
        try {
            work();
        } catch (...) {
            failure = std::current_exception();
        }
    });
    wait();
    if (failure) std::rethrow_exception(failure);
}

void DrawingThread::start(std::function<void()> work) {
    give([this, work = std::move(work)] {
        work();
        wake_();
    });
}

bool DrawingThread::busy() const {
    const std::lock_guard lock{mutex_};
    return work_ != nullptr;
}

bool DrawingThread::wait_for(std::chrono::milliseconds longest) const {
    std::unique_lock lock{mutex_};
    return changed_.wait_for(lock, longest, [&] { return work_ == nullptr; });
}

void DrawingThread::wait() const {
    std::unique_lock lock{mutex_};
    changed_.wait(lock, [&] { return work_ == nullptr; });
}

} // namespace lineatlas::viewer
