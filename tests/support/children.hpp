#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <sys/types.h>

namespace lineatlas::test {

/// The processes that a process has started and not waited for yet.
inline std::vector<pid_t> children_of(pid_t process) {
    std::vector<pid_t> children;
    std::error_code error;
    const std::string threads = "/proc/" + std::to_string(process) + "/task";
    for (const auto& thread : std::filesystem::directory_iterator{threads, error}) {
        std::ifstream file{thread.path() / "children"};
        for (pid_t child = 0; file >> child;) children.push_back(child);
    }
    return children;
}

} // namespace lineatlas::test
