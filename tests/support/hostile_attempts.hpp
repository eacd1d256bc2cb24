#pragma once

#include <future>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace lineatlas::test {

/// A file that exists, and a port where somebody listens.
struct Target {
    std::string path;
    int port;
};

/// Somebody who listens, at a port of this machine that is free.
class Listener {
  public:
    Listener();
    ~Listener();
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    int port() const { return port_; }

  private:
    int socket_ = -1;
    int port_ = 0;
};

/// The weakest thing that refuses an attempt: limits, which every kernel has; Landlock; seccomp,
/// which refuses all of them.
enum class By { limits, landlock, seccomp };

/// What a hostile file that has taken over a parser would try with them.
struct Attempt {
    std::string_view name;
    By least;
    int (*act)(const Target& target); ///< ends in -1 where it is refused

    /// What it left in errno, or 0 if it was done.
    int error(const Target& target) const;
    /// Where these two are, or are not.
    bool is_refused(bool seccomp, bool landlock) const {
        return least == By::limits || seccomp || (least == By::landlock && landlock);
    }
};

/// The last one, where it is not refused, ends the program.
std::span<const Attempt> attempts();

/// A thread that is there before its process is confined, as a library may start some when it is
/// loaded.
class EarlyThread {
  public:
    EarlyThread();
    ~EarlyThread();
    EarlyThread(const EarlyThread&) = delete;
    EarlyThread& operator=(const EarlyThread&) = delete;

    /// Attempt::error() of all attempts, made by that thread. Once.
    std::vector<int> errors(const Target& target);

  private:
    std::promise<Target> target_;
    std::promise<std::vector<int>> errors_;
    std::thread thread_;
};

} // namespace lineatlas::test
