#include "standard_streams.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "base/printable.hpp"
#include "lineatlas/error.hpp"
#include "source_file.hpp"

namespace lineatlas {

namespace {

bool pipes_end_the_program = false; ///< whether pipes ended it before open_standard_streams()

[[noreturn]] void fail_output(int error) {
    if (error == EPIPE && pipes_end_the_program) {
        std::signal(SIGPIPE, SIG_DFL);
        std::raise(SIGPIPE);
    }
    const std::string cause = error != 0 ? write_cause(error) : "not all of it was taken";
    throw FileError("cannot write to standard output: " + cause);
}

} // namespace

void open_standard_streams() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
        // Opened the wrong way round, so that reading or writing fails. The lowest free number is
        // this one.
        (void)::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
    // Not SIG_IGN, which programs that this one starts would inherit.
    const auto before = std::signal(SIGPIPE, [](int) {});
    pipes_end_the_program = before == SIG_DFL;
    if (before == SIG_IGN) std::signal(SIGPIPE, SIG_IGN);
    // With a handler, a limit of file sizes (ulimit -f) becomes an error of write(). Other programs
    // do not inherit handlers, unlike SIG_IGN.
    if (std::signal(SIGXFSZ, [](int) {}) == SIG_IGN) std::signal(SIGXFSZ, SIG_IGN);
}

void print_output(std::string_view text) {
    const std::string lines = printable_lines(text);
    if (std::fwrite(lines.data(), 1, lines.size(), stdout) != lines.size())
        throw std::system_error(errno, std::generic_category());
}

void print_error(std::string_view text) noexcept {
    const std::string lines = printable_lines(text);
    std::fwrite(lines.data(), 1, lines.size(), stderr);
    std::fflush(stderr);
}

void clear_error_line() noexcept {
    std::fputs("\r\x1b[K", stderr);
    std::fflush(stderr);
}

int run_with_output(const std::function<int()>& run) {
    try {
        const int code = run();
        errno = 0;
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) fail_output(errno);
        return code;
    } catch (const std::system_error& error) { // thrown by a print that failed
        if (std::ferror(stdout) != 0) fail_output(error.code().value());
        throw;
    }
}

} // namespace lineatlas
