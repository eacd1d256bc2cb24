#include "reader_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "confinement.hpp"
#include "lineatlas/error.hpp"
#include "reader_protocol.hpp"
#include "source_file.hpp"

namespace lineatlas {

namespace {

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

/// Silences the process, because libraries print errors. The reader's refusals come as answers.
void add_silence(posix_spawn_file_actions_t& actions) {
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    if (!reader::sanitized)
        ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
}

} // namespace

std::string written_gibibytes(std::uint64_t bytes) {
    return short_number(static_cast<double>(bytes) / gibibyte) + " GiB";
}

ReadLimits limits_for(std::uintmax_t size, const ReadLimits& limits) {
    // Reading a text of triangles takes up to twenty times its size in memory, and on a slow
    // machine a second per 10 MB.
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
                             const ReadLimits& limits, std::string_view settings,
                             const std::filesystem::path& program)
    : path_(path) {
    if (program.empty() && !serves_as_reader())
        throw std::logic_error("main() must call serve_as_reader()");
    const std::uintmax_t size = check_source(path);
    limits_ = limits_for(size, limits);
    patience_ = Patience{limits_.time};
    if (size > limits_.memory) fail_for_memory(); // the whole file must fit
    start(kind, settings, program.empty() ? "/proc/self/exe" : program);
    await_answer();
}

void ReaderProcess::start(std::string_view kind, std::string_view settings,
                          const std::filesystem::path& program) {
    std::array<int, 2> sockets{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0)
        fail(std::string{"cannot make a socket: "} + std::strerror(errno));
    std::array<std::string, 7> words{
        "lineatlas-reader",   std::string{reader::argument},  std::string{kind},
        path_.string(),       std::to_string(limits_.memory), std::to_string(::getpid()),
        std::string{settings}};
    std::array<char*, words.size() + 1> arguments{};
    std::ranges::transform(words, arguments.begin(), [](std::string& word) { return word.data(); });

    std::vector<std::string> variables = small_environment();
    std::vector<char*> environment;
    for (std::string& variable : variables) environment.push_back(variable.data());
    environment.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, sockets[1], reader::socket);
    add_silence(actions);
    ::posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
    pid_t process = -1;
    const int error = ::posix_spawn(&process, program.c_str(), &actions, nullptr, arguments.data(),
                                    environment.data());
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(sockets[1]);
    worker_ = WorkerProcess{error == 0 ? process : -1, sockets[0]};
    if (error != 0)
        fail(std::string{"cannot start a process that reads it: "} + std::strerror(error));
}

void ReaderProcess::await_answer() {
    switch (value<reader::Answer>()) {
    case reader::Answer::read:
        return;
    case reader::Answer::refused: {
        const auto size = value<std::uint64_t>();
        if (size > reader::longest_refusal) refuse();
        std::string message(size, '\0');
        receive(std::as_writable_bytes(std::span{message}));
        throw FileError(message);
    }
    case reader::Answer::no_memory:
        fail_for_memory();
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
    // The process itself cannot have had more.
    if (count > (limits_.memory - kept_) / element_size) refuse();
    kept_ += count * element_size;
    return count;
}

void ReaderProcess::receive(std::span<std::byte> bytes) {
    for (;;) {
        const std::size_t there = std::min(bytes.size(), buffer_.size() - taken_);
        std::copy_n(buffer_.begin() + static_cast<std::ptrdiff_t>(taken_), there, bytes.begin());
        taken_ += there;
        bytes = bytes.subspan(there);
        if (bytes.empty()) return;
        constexpr std::size_t room = std::size_t{64} << 10U;
        if (bytes.size() >= room) { // large values are not copied
            if (receive_all(worker_.socket(), bytes, patience_)) return;
            break;
        }
        buffer_.resize(room);
        taken_ = 0;
        buffer_.resize(receive_some(worker_.socket(), buffer_, patience_));
        if (buffer_.empty()) break;
    }
    if (!patience_.is_over()) ended();
    fail("reading it took more than " +
         short_number(static_cast<double>(limits_.time.count()) / 1000) +
         " s; LoadOptions::read_seconds allows more");
}

/// Throws FileError that says how the process ended.
void ReaderProcess::ended() {
    const auto [status, went_on_mute] = worker_.ending();
    if (went_on_mute)
        fail("its reader closed its answer before it was whole; the file is damaged or hostile");
    constexpr int cannot_load = 127; // exit status of the loader if it has no memory for libraries
    if (WIFEXITED(status) && WEXITSTATUS(status) == cannot_load) fail_for_memory();
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

void ReaderProcess::fail_for_memory() const {
    fail("reading it needs more than " + written_gibibytes(limits_.memory) +
         " of memory; LoadOptions::read_memory allows more");
}

void ReaderProcess::refuse() const {
    fail("its reader gave an answer that makes no sense; the file is damaged or hostile");
}

} // namespace lineatlas
