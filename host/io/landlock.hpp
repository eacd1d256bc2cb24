#pragma once

namespace lineatlas {

/// The version of Landlock that this kernel offers; 0: none.
int landlock_version();

/// What of files is left.
enum class Files { none, read };

/// From here on this thread, and those that it starts, make, change, rename and remove no file and
/// start no program, and read files only where `allowed` says so; from version 4 on they make no
/// connection by TCP, from 6 on they signal no process outside. For ever. Needs
/// PR_SET_NO_NEW_PRIVS. Throws std::system_error.
void restrict_files(Files allowed);

} // namespace lineatlas
