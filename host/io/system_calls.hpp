#pragma once

namespace lineatlas {

// Implemented by seccomp/system_calls.cpp, or, if libseccomp is missing when this is built, by
// seccomp/none.cpp.

/// Whether this program was built with libseccomp.
bool knows_seccomp();

/// Whether the kernel filters system calls, and this program knows how to ask it.
bool has_seccomp();

/// From here on this process, with all of its threads, is left with what computing takes: memory,
/// threads, clocks, its own end, and the descriptors up to stderr, which it can read and write. All
/// else fails with EPERM. For ever. Needs PR_SET_NO_NEW_PRIVS. Throws std::system_error.
void restrict_system_calls();

} // namespace lineatlas
