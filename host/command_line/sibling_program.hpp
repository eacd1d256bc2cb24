#pragma once

#include <string>
#include <vector>

namespace lineatlas {

/// True if the folder of the running program has a program of that name.
bool has_sibling(const std::string& name);

/// Replaces this process by the program `name` in the folder of the running one. Throws Error,
/// with `advice` at the end of its message, if there is none that can be run.
[[noreturn]] void run_sibling(const std::string& name, const std::vector<std::string>& arguments,
                              const std::string& advice);

} // namespace lineatlas
