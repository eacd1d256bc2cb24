#pragma once

namespace lineatlas {

/// The version of Landlock that this kernel offers; 0: none.
int landlock_version();

/// The access to files that is left.
enum class Files { none, read };

/// Restricts this thread, and the threads that it starts, for ever. They make, change, rename and
/// remove no file, start no program, and read files only if `allowed` says so. From version 4 on
/// they make no connection by TCP, from version 6 on they signal no process outside. Needs
/// PR_SET_NO_NEW_PRIVS. Throws std::system_error.
void restrict_files(Files allowed);

} // namespace lineatlas
