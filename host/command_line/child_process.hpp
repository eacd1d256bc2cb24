#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace lineatlas {

/// How a program ended.
struct ChildResult {
    int exit_code = -1;     ///< -1 unless it ended by itself
    int signal = 0;         ///< the signal that ended it, or 0
    bool timed_out = false; ///< it was ended, with all processes that it had started
    bool stopped = false;   ///< likewise, because `goes_on` said so
    std::string output;     ///< its captured output
    std::chrono::duration<double> took{};
};

enum class Captured { output, output_and_errors };

/// Runs a program to its end or for `limit`, whichever comes first. `arguments` does not hold the
/// name of the program. `goes_on` is asked ten times a second; once it returns false, the program
/// is ended. Throws Error if it can't be started.
ChildResult run_child(const std::filesystem::path& program,
                      const std::vector<std::string>& arguments, std::chrono::seconds limit,
                      Captured captured = Captured::output,
                      const std::function<bool()>& goes_on = {});

} // namespace lineatlas
