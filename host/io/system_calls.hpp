#pragma once

namespace lineatlas {

// Implemented by seccomp/system_calls.cpp, or, if libseccomp is missing when this is built, by
// seccomp/none.cpp.

/// Whether this program was built with libseccomp.
bool knows_seccomp();

/// Whether the kernel filters system calls, and this program knows how to ask it.
bool has_seccomp();

/// Restricts this process, with all of its threads, for ever to the system calls that computing
/// takes: memory, threads, clocks, its own end, and reading and writing the descriptors up to
/// stderr. All others fail with EPERM. Needs PR_SET_NO_NEW_PRIVS. Throws std::system_error.
void restrict_system_calls();

} // namespace lineatlas
