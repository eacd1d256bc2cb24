#pragma once

#include <fstream>
#include <string>
#include <string_view>

namespace lineatlas::test {

/// The memory that this process holds, in KiB. Pages of files, such as the code of libraries, do
/// not count, because the system loads and drops them as it likes.
inline long held_memory() {
    std::ifstream status{"/proc/self/status"};
    long held = 0;
    for (std::string line; std::getline(status, line);) {
        for (const std::string_view name : {"RssAnon:", "RssShmem:", "VmSwap:"}) {
            if (line.starts_with(name)) held += std::stol(line.substr(name.size()));
        }
    }
    return held;
}

} // namespace lineatlas::test
