#include "stop_signal.hpp"

#include <csignal>

namespace lineatlas {
namespace {

volatile std::sig_atomic_t noted = 0;

void note(int signal) {
    noted = signal;
}

void handle(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART | SA_RESETHAND;
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
}

} // namespace

StopSignal::StopSignal() {
    noted = 0;
    handle(note);
}

StopSignal::~StopSignal() {
    handle(SIG_DFL);
}

int StopSignal::received() const {
    return noted;
}

} // namespace lineatlas
