#pragma once

#include <string>
#include <vector>

namespace lineatlas {

// A process that works on other people's files gives up its abilities first, so that a file that
// takes over the process gains nothing.

/// What this machine and this build confine processes by. A build with sanitizers does not: they
/// read /proc, and start what names their findings.
struct Confinement {
    bool system_calls = false; ///< seccomp
    int files = 0;             ///< the version of Landlock; 0: none
};
Confinement offered_confinement();

/// In words, with the reason for what is missing.
std::string describe(const Confinement& confinement);

/// `NAME=value` of the few variables that such a process gets: where libraries and modules are.
std::vector<std::string> small_environment();

/// For a process that was forked: keeps small_environment() and the descriptors up to stderr. One
/// that is started anew gets no more in the first place.
void forget_what_was_inherited();

/// Whether this process has no other thread.
bool has_one_thread();

// The two steps of giving up. Landlock holds for one thread and for those that it starts later; a
// library may start some as it is loaded (log4cplus, which OpenImageIO brings, starts four). So
// what can be given up before that is.

/// From here on this process reads files and changes none, starts no program, connects to nothing.
/// For before a library is loaded. Throws DeviceError, also where there is another thread, which
/// would stay outside: then the work must not be done.
void confine_to_reading();

/// From here on this process, with all of its threads, computes, and talks through the descriptors
/// up to stderr: it opens nothing, connects to nothing, starts no process. By all that
/// offered_confinement() says, and by limits that every kernel has. After confine_to_reading().
/// Throws DeviceError: then the work must not be done.
void confine();

} // namespace lineatlas
