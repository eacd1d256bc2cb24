#pragma once

#include <string>
#include <vector>

namespace lineatlas {

// A process that works on other people's files gives up its abilities first, so that a file that
// takes over the process gains nothing.

/// The means by which this machine and this build confine processes. A build with sanitizers
/// confines nothing: sanitizers read /proc and start programs.
struct Confinement {
    bool system_calls = false; ///< seccomp
    int files = 0;             ///< the version of Landlock; 0: none
};
Confinement offered_confinement();

/// A description in words, with the reason for each missing means.
std::string describe(const Confinement& confinement);

/// `NAME=value` of the few variables that such a process gets: where libraries and modules are.
std::vector<std::string> small_environment();

/// Keeps only small_environment() and the descriptors up to stderr, in a forked process. A newly
/// started process gets no more in the first place.
void forget_what_was_inherited();

/// Whether this process has no other thread.
bool has_one_thread();

// The two steps of confinement. Landlock holds for one thread and for threads that it starts later.
// A library may start threads as it is loaded (log4cplus, which OpenImageIO brings, starts four).
// So a first step comes before libraries are loaded.

/// The first step, before a library is loaded. From here on this process reads files and changes
/// none, starts no program, and connects to nothing. Throws DeviceError, also if there is another
/// thread, which would not be confined. Then the work must not be done.
void confine_to_reading();

/// The second step, after confine_to_reading(). From here on this process, with all of its threads,
/// computes, and talks through the descriptors up to stderr. It opens nothing, connects to nothing
/// and starts no process. Uses all that offered_confinement() says, and limits that every kernel
/// has. If it throws DeviceError, the work must not be done.
void confine();

} // namespace lineatlas
