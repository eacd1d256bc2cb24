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

/// Listens at a free port of this machine.
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

/// The weakest protection that refuses an attempt: limits, which every kernel has; Landlock; or
/// seccomp, which refuses all attempts.
enum class By { limits, landlock, seccomp };

/// An attempt of a hostile file that has taken over a parser.
struct Attempt {
    std::string_view name;
    By least;
    int (*act)(const Target& target); ///< returns -1 if it is refused

    /// Makes the attempt. Returns errno, or 0 if it succeeded.
    int error(const Target& target) const;
    /// True if the attempt is refused with these two protections on or off.
    bool is_refused(bool seccomp, bool landlock) const {
        return least == By::limits || seccomp || (least == By::landlock && landlock);
    }
};

/// All attempts. The last one ends the program if it is not refused.
std::span<const Attempt> attempts();

/// A thread that starts before its process is confined. Libraries may start such threads when they
/// are loaded.
class EarlyThread {
  public:
    EarlyThread();
    ~EarlyThread();
    EarlyThread(const EarlyThread&) = delete;
    EarlyThread& operator=(const EarlyThread&) = delete;

    /// Attempt::error() of all attempts, made by that thread. Call it once.
    std::vector<int> errors(const Target& target);

  private:
    std::promise<Target> target_;
    std::promise<std::vector<int>> errors_;
    std::thread thread_;
};

} // namespace lineatlas::test
