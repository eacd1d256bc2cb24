#include "stop_signal.hpp"

#include <atomic>
#include <csignal>
#include <cstring>
#include <ctime>

#include <unistd.h>

namespace lineatlas {
namespace {

constexpr long patience = 200'000'000; ///< nanoseconds

volatile std::sig_atomic_t noted = 0;
std::atomic<const char*> last_words = "";
timer_t timer{};

// For handlers, which may use only what POSIX allows there.

void note(int signal) {
    noted = signal;
    const itimerspec once{.it_interval = {}, .it_value = {.tv_sec = 0, .tv_nsec = patience}};
    ::timer_settime(timer, 0, &once, nullptr);
}

void end(int) {
    const char* words = last_words;
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, words, std::strlen(words));
    ::_exit(128 + noted);
}

void handle(int signal, void (*handler)(int), int flags) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
}

void handle_stops(void (*handler)(int)) {
    for (const int signal : {SIGINT, SIGTERM}) handle(signal, handler, SA_RESTART | SA_RESETHAND);
}

} // namespace

StopSignal::StopSignal() {
    noted = 0;
    handle(SIGALRM, end, SA_RESTART);
    sigevent alarm{};
    alarm.sigev_notify = SIGEV_SIGNAL;
    alarm.sigev_signo = SIGALRM;
    if (::timer_create(CLOCK_MONOTONIC, &alarm, &timer) != 0)
        throw Error("the system has no timer left");
    handle_stops(note);
}

StopSignal::~StopSignal() {
    handle_stops(SIG_DFL);
    ::timer_delete(timer);
    handle(SIGALRM, SIG_DFL, 0);
    last_words = "";
}

int StopSignal::received() const {
    return noted;
}

void StopSignal::set_last_words(const std::string& line) {
    std::string& next = words_.at(static_cast<std::size_t>(next_));
    next_ = 1 - next_;
    next = (isatty(STDERR_FILENO) != 0 ? "\r\x1b[K" : "") + line + '\n';
    last_words = next.c_str();
}

} // namespace lineatlas
