#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace lineatlas::viewer {

/// A GL context beside another one with which it shares buffers and textures.
class SharedContext {
  public:
    virtual ~SharedContext() = default;
    virtual void make_current() = 0; ///< on the calling thread
    virtual void release() = 0;      ///< on the thread on which it is current
};

/// Runs work that needs GL on a thread of its own, one piece after the other, so that the caller
/// need not wait.
class DrawingThread {
  public:
    /// `context` belongs to the thread and must outlive this object. The thread calls `wake` when
    /// work that was started is done.
    DrawingThread(SharedContext& context, std::function<void()> wake);
    /// Waits for the work that is running.
    ~DrawingThread();
    DrawingThread(const DrawingThread&) = delete;
    DrawingThread& operator=(const DrawingThread&) = delete;

    /// Runs `work` after the work that was started, and waits for it. Throws what `work` throws.
    void run(const std::function<void()>& work);
    /// Starts `work` and returns. No other work may be running. `work` must not throw.
    void start(std::function<void()> work);
    /// True while work that was started is running.
    bool busy() const;
    /// Waits until the work is done, but no longer than `longest`. Returns whether it is done.
    bool wait_for(std::chrono::milliseconds longest) const;
    void wait() const; ///< until the work is done

  private:
    void work();
    void give(std::function<void()> work);

    SharedContext& context_;
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    std::function<void()> work_; ///< to be done or being done; none: nothing
    bool ends_ = false;
    std::thread thread_; ///< the last member: it uses the others
};

} // namespace lineatlas::viewer
