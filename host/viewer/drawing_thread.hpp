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

/// Does what needs GL on a thread of its own, one thing after the other, so that who asks for it
/// need not wait.
class DrawingThread {
  public:
    /// `context` is the thread's as long as it lives, and must outlive it; `wake` is called on it
    /// when something that was started is done.
    DrawingThread(SharedContext& context, std::function<void()> wake);
    /// Waits for what is being done.
    ~DrawingThread();
    DrawingThread(const DrawingThread&) = delete;
    DrawingThread& operator=(const DrawingThread&) = delete;

    /// Does it after what was started, and waits. Throws what it throws.
    void run(const std::function<void()>& work);
    /// Lets it be done, and returns; nothing else may be under way. It must not throw.
    void start(std::function<void()> work);
    /// Whether what was started is not done yet.
    bool busy() const;
    /// Until it is done, or so long; whether it is done.
    bool wait_for(std::chrono::milliseconds longest) const;
    void wait() const; ///< until it is done

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
