#include "hostile_attempts.hpp"

#include <array>
#include <cerrno>
#include <cstdint>
#include <stdexcept>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

namespace lineatlas::test {
namespace {

sockaddr_in loopback(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

int connect_to_loopback(int type, int port) {
    const int socket = ::socket(AF_INET, type, 0);
    if (socket < 0) return -1;
    const sockaddr_in address = loopback(port);
    const int result =
        ::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address));
    const int error = errno;
    ::close(socket);
    errno = error;
    return result;
}

int start_process() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    return child;
}

constexpr std::array all_attempts{
    Attempt{"open a file", By::limits,
            [](const Target& target) { return ::open(target.path.c_str(), O_RDONLY); }},
    Attempt{"open a program's own memory", By::limits,
            [](const Target&) { return ::open("/proc/self/mem", O_RDWR); }},
    Attempt{"write to a file", By::limits,
            [](const Target& target) { return ::open(target.path.c_str(), O_WRONLY | O_TRUNC); }},
    Attempt{"make a file", By::limits,
            [](const Target& target) {
                return ::open((target.path + ".made").c_str(), O_WRONLY | O_CREAT, 0600);
            }},
    Attempt{"make a folder", By::landlock,
            [](const Target& target) { return ::mkdir((target.path + ".made").c_str(), 0700); }},
    Attempt{"rename a file", By::landlock,
            [](const Target& target) {
                return ::rename(target.path.c_str(), (target.path + ".made").c_str());
            }},
    Attempt{"remove a file", By::landlock,
            [](const Target& target) { return ::unlink(target.path.c_str()); }},
    Attempt{"ask for a file", By::seccomp,
            [](const Target& target) {
                struct stat status {};
                return ::stat(target.path.c_str(), &status);
            }},
    Attempt{"connect", By::limits,
            [](const Target& target) { return connect_to_loopback(SOCK_STREAM, target.port); }},
    Attempt{"send a datagram", By::limits,
            [](const Target& target) { return connect_to_loopback(SOCK_DGRAM, target.port); }},
    Attempt{"listen", By::limits, [](const Target&) { return ::socket(AF_UNIX, SOCK_STREAM, 0); }},
    Attempt{"fork", By::seccomp, [](const Target&) { return start_process(); }},
    Attempt{"signal who started it", By::seccomp,
            [](const Target&) { return ::kill(::getppid(), 0); }},
    Attempt{"trace who started it", By::seccomp,
            [](const Target&) {
                return static_cast<int>(::ptrace(PTRACE_SEIZE, ::getppid(), nullptr, nullptr));
            }},
    Attempt{"run what it wrote", By::seccomp,
            [](const Target&) {
                return ::mmap(nullptr, 4096, PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS,
                              -1, 0) == MAP_FAILED
                           ? -1
                           : 0;
            }},
    Attempt{"lift a limit", By::seccomp,
            [](const Target&) {
                const rlimit many{.rlim_cur = 64, .rlim_max = 64};
                return ::setrlimit(RLIMIT_NOFILE, &many);
            }},
    Attempt{"start a program", By::landlock,
            [](const Target&) {
                char* arguments[] = {const_cast<char*>("true"), nullptr};
                return ::execv("/bin/true", arguments);
            }},
};

} // namespace

Listener::Listener() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address = loopback(0);
    socklen_t size = sizeof(address);
    auto* generic = reinterpret_cast<sockaddr*>(&address);
    if (::bind(socket_, generic, size) != 0 || ::listen(socket_, 8) != 0 ||
        ::getsockname(socket_, generic, &size) != 0)
        throw std::runtime_error("no port of this machine can be listened at");
    port_ = ntohs(address.sin_port);
}

Listener::~Listener() {
    ::close(socket_);
}

int Attempt::error(const Target& target) const {
    errno = 0;
    return act(target) < 0 ? errno : 0;
}

std::span<const Attempt> attempts() {
    return all_attempts;
}

EarlyThread::EarlyThread()
    : thread_([this] {
          const Target target = target_.get_future().get();
          std::vector<int> errors;
          for (const Attempt& attempt : all_attempts) errors.push_back(attempt.error(target));
          errors_.set_value(errors);
      }) {}

EarlyThread::~EarlyThread() {
    thread_.detach(); // the thread ends with the process
}

std::vector<int> EarlyThread::errors(const Target& target) {
    target_.set_value(target);
    return errors_.get_future().get();
}

} // namespace lineatlas::test
