#include "child_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "lineatlas/error.hpp"

namespace lineatlas {
namespace {

using Clock = std::chrono::steady_clock;

/// Starts the program in a process group of its own, with its captured output on `output`.
pid_t start(const std::filesystem::path& program, const std::vector<std::string>& arguments,
            int output, Captured captured) {
    const std::string path = program.string();
    std::vector<char*> words{const_cast<char*>(path.c_str())};
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    if (captured == Captured::output_and_errors)
        posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    pid_t child = -1;
    const int error =
        ::posix_spawn(&child, path.c_str(), &actions, &attributes, words.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw Error("cannot run \"" + path + "\": " + std::strerror(error));
    return child;
}

/// Reads until the other end is closed. Returns false if the time is over or `goes_on` says so.
bool read_until(int input, Clock::time_point end, const std::function<bool()>& goes_on,
                std::string& output) {
    std::array<char, 4096> part{};
    for (;;) {
        auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
        if (left.count() <= 0 || (goes_on && !goes_on())) return false;
        if (goes_on) left = std::min(left, std::chrono::milliseconds{100});
        pollfd waiting{.fd = input, .events = POLLIN, .revents = 0};
        if (::poll(&waiting, 1, static_cast<int>(left.count())) <= 0) continue;
        const ssize_t count = ::read(input, part.data(), part.size());
        if (count == 0) return true;
        if (count > 0) output.append(part.data(), static_cast<std::size_t>(count));
        if (count < 0 && errno != EINTR) return true;
    }
}

/// Waits for the end of the program, which may come after stdout is closed. Returns false if the
/// time is over.
bool wait_until(pid_t child, Clock::time_point end, int& status) {
    while (::waitpid(child, &status, WNOHANG) == 0) {
        if (Clock::now() >= end) return false;
        ::usleep(2000);
    }
    return true;
}

} // namespace

ChildResult run_child(const std::filesystem::path& program,
                      const std::vector<std::string>& arguments, std::chrono::seconds limit,
                      Captured captured, const std::function<bool()>& goes_on) {
    std::array<int, 2> pipe{};
    if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
        throw Error(std::string{"cannot make a pipe: "} + std::strerror(errno));
    const Clock::time_point begin = Clock::now();
    const pid_t child = start(program, arguments, pipe[1], captured);
    ::close(pipe[1]);
    ChildResult result;
    int status = 0;
    const Clock::time_point end = begin + limit;
    const bool ended =
        read_until(pipe[0], end, goes_on, result.output) && wait_until(child, end, status);
    result.timed_out = !ended && Clock::now() >= end;
    result.stopped = !ended && !result.timed_out;
    if (!ended) {
        ::kill(-child, SIGKILL);
        ::waitpid(child, &status, 0);
    }
    ::close(pipe[0]);
    if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status) && ended) result.signal = WTERMSIG(status);
    result.took = Clock::now() - begin;
    return result;
}

} // namespace lineatlas
