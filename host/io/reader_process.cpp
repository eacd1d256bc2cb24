#include "reader_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "lineatlas/error.hpp"
#include "reader_protocol.hpp"
#include "source_file.hpp"

namespace lineatlas {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;

/// "60", "0.25"
std::string short_number(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", number);
    return text.data();
}

std::string signal_name(int signal) {
    const char* name = ::sigabbrev_np(signal);
    return name != nullptr ? std::string{"SIG"} + name : "signal " + std::to_string(signal);
}

/// Silent, since libraries print what they find wrong; what the reader refuses comes as an answer.
void add_silence(posix_spawn_file_actions_t& actions) {
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    if (!reader::sanitized)
        ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
}

} // namespace

ReadLimits limits_for(std::uintmax_t size, const ReadLimits& limits) {
    // A text of triangles takes up to twenty times its size while it is read, on a slow machine a
    // second per 10 MB.
    constexpr std::uint64_t least_memory = std::uint64_t{2} << 30U;
    constexpr std::uint64_t memory_per_byte = 32;
    constexpr std::uint64_t bytes_per_millisecond = 1000;
    constexpr std::chrono::seconds least_time{60};
    ReadLimits filled = limits;
    if (filled.memory == 0) filled.memory = least_memory + memory_per_byte * size;
    if (filled.time.count() == 0)
        filled.time = least_time + std::chrono::milliseconds{size / bytes_per_millisecond};
    return filled;
}

ReaderProcess::ReaderProcess(std::string_view kind, const std::filesystem::path& path,
                             const ReadLimits& limits)
    : path_(path), limits_(limits_for(check_source(path), limits)) {
    if (!serves_as_reader()) throw std::logic_error("main() must call serve_as_reader()");
    start(kind);
    try {
        await_answer();
    } catch (...) {
        end();
        throw;
    }
}

ReaderProcess::~ReaderProcess() {
    end();
}

void ReaderProcess::start(std::string_view kind) {
    std::array<int, 2> sockets{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0)
        fail(std::string{"cannot make a socket: "} + std::strerror(errno));
    std::array<std::string, 6> words{
        "lineatlas-reader", std::string{reader::argument},  std::string{kind},
        path_.string(),     std::to_string(limits_.memory), std::to_string(::getpid())};
    std::array<char*, words.size() + 1> arguments{};
    std::ranges::transform(words, arguments.begin(), [](std::string& word) { return word.data(); });

    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, sockets[1], reader::socket);
    add_silence(actions);
    const int error =
        ::posix_spawn(&process_, "/proc/self/exe", &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(sockets[1]);
    socket_ = sockets[0];
    if (error == 0) return;
    process_ = -1;
    end();
    fail(std::string{"cannot start a process that reads it: "} + std::strerror(error));
}

void ReaderProcess::await_answer() {
    switch (value<reader::Answer>()) {
    case reader::Answer::read:
        return;
    case reader::Answer::refused:
        throw FileError(text());
    case reader::Answer::no_memory:
        fail("reading it needs more than " +
             short_number(static_cast<double>(limits_.memory) / gibibyte) +
             " GiB of memory; --read-memory allows more");
    }
    refuse();
}

std::string ReaderProcess::text() {
    std::string text(count(1), '\0');
    receive(std::as_writable_bytes(std::span{text}));
    return text;
}

std::size_t ReaderProcess::count(std::size_t element_size) {
    const auto count = value<std::uint64_t>();
    // No more than the process may have had itself; seen before anything is allocated.
    if (count > (limits_.memory - received_) / element_size) refuse();
    return count;
}

/// Counted in short waits: a time in which this process was stopped (Ctrl-Z) is not the reader's.
bool ReaderProcess::wait_for_bytes() {
    constexpr std::chrono::milliseconds part{100};
    while (waited_ < limits_.time) {
        const Clock::time_point begin = Clock::now();
        pollfd waiting{.fd = socket_, .events = POLLIN, .revents = 0};
        const int ready = ::poll(&waiting, 1, static_cast<int>(part.count()));
        waited_ += std::min<std::chrono::nanoseconds>(Clock::now() - begin, 2 * part);
        if (ready > 0) return true;
    }
    return false;
}

void ReaderProcess::receive(std::span<std::byte> bytes) {
    received_ += bytes.size();
    if (received_ > limits_.memory) refuse();
    while (!bytes.empty()) {
        if (!wait_for_bytes())
            fail("reading it took more than " +
                 short_number(static_cast<double>(limits_.time.count()) / 1000) +
                 " s; --read-seconds allows more");
        const ssize_t got = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (got <= 0) ended();
        bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
}

/// Says how the process ended.
void ReaderProcess::ended() {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
    process_ = -1;
    if (!WIFSIGNALED(status))
        fail("its reader ended unexpectedly with code " + std::to_string(WEXITSTATUS(status)));
    const int signal = WTERMSIG(status);
    if (signal == SIGKILL)
        fail("its reader was killed (SIGKILL); did the machine run out of memory?");
    if (signal == SIGINT || signal == SIGTERM)
        fail("its reader was stopped (" + signal_name(signal) + ")");
    fail("its reader crashed (" + signal_name(signal) + "); the file is damaged or hostile");
}

void ReaderProcess::fail(const std::string& cause) const {
    throw read_error(path_, cause);
}

void ReaderProcess::refuse() const {
    fail("its reader gave an answer that makes no sense; the file is damaged or hostile");
}

/// Nothing that the process could still do is wanted.
void ReaderProcess::end() {
    if (socket_ >= 0) ::close(socket_);
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
    }
    process_ = socket_ = -1;
}

} // namespace lineatlas
