#include "worker_process.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lineatlas {
namespace {

/// waitpid(), repeated while it is interrupted.
pid_t wait_for(pid_t process, int* status, int options) {
    pid_t result = 0;
    do {
        result = ::waitpid(process, status, options);
    } while (result < 0 && errno == EINTR);
    return result;
}

} // namespace

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)), socket_(std::exchange(other.socket_, -1)) {}

WorkerProcess& WorkerProcess::operator=(WorkerProcess&& other) noexcept {
    if (this == &other) return *this;
    end();
    process_ = std::exchange(other.process_, -1);
    socket_ = std::exchange(other.socket_, -1);
    return *this;
}

WorkerProcess::Ending WorkerProcess::ending() {
    using namespace std::chrono_literals;
    // A process closes its socket a little before it ends, and earlier if much memory must be
    // freed. A process that closes the socket and goes on must not be waited for.
    constexpr std::chrono::milliseconds moment = 2s, step = 2ms;
    ::shutdown(socket_, SHUT_RDWR); // wakes a process that waits to send
    Ending ending;
    for (auto waited = 0ms; waited < moment; waited += step) {
        if (wait_for(process_, &ending.status, WNOHANG) != 0) {
            process_ = -1;
            return ending;
        }
        std::this_thread::sleep_for(step);
    }
    ending.went_on_mute = true;
    end();
    return ending;
}

void WorkerProcess::end() {
    if (socket_ >= 0) ::close(socket_);
    if (process_ > 0) {
        ::kill(process_, SIGKILL);
        wait_for(process_, nullptr, 0);
    }
    process_ = socket_ = -1;
}

} // namespace lineatlas
