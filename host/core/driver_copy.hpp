#pragma once

#include <csignal>
#include <cstddef>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

/// Prepares a copy of this process for the trial of a driver that may end the copy.
namespace lineatlas {

/// Makes sure that the copy leaves no core file, prints nothing and does not outlive this process.
inline void begin_driver_copy() {
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    ::signal(SIGABRT, SIG_DFL);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC); nowhere >= 0) {
        ::dup2(nowhere, STDOUT_FILENO);
        ::dup2(nowhere, STDERR_FILENO);
    }
}

/// Takes the memory that must be left for a frame. Ends the copy with 1 if there is less.
inline void take_memory(std::size_t bytes) {
    void* const taken =
        ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (taken == MAP_FAILED) ::_exit(1);
}

} // namespace lineatlas
