#pragma once

namespace lineatlas {

/// The version of Landlock that this kernel offers; 0: none.
int landlock_version();

/// From here on this process opens, makes, renames and removes no file and starts no program; from
/// version 4 on it makes no connection by TCP, from 6 on it signals no process outside. For ever,
/// and for what it starts. Needs PR_SET_NO_NEW_PRIVS. Throws std::system_error.
void restrict_files();

} // namespace lineatlas
