#pragma once

#include <string>
#include <vector>

namespace lineatlas::apps {

/// Runs a program that stands beside the tool in place of this process. Throws Error, ending in
/// `advice`, if it can't.
[[noreturn]] void run_neighbour(const std::string& name, const std::vector<std::string>& arguments,
                                const std::string& advice);

} // namespace lineatlas::apps
