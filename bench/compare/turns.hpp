#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/App.hpp>

namespace lineatlas::bench {

/// The option `--interleave`. Runs a benchmark of another build and of this build by turns. Each
/// run is a process of its own. So other work on the machine and the placement of memory affect
/// both builds alike.
class Turns {
  public:
    void declare(CLI::App& app);
    bool given() const { return !other_.empty(); }

    /// Runs this program and the program of the same name in the other build, with `arguments` and
    /// `--json FILE`. Each of `parts` is one more argument of a run of its own. Writes the figures
    /// of this build to `json` and prints the comparison. Throws UsageError if the other build has
    /// no such program, Error if a run fails.
    void run(const std::vector<std::string>& arguments, const std::vector<std::string>& parts,
             const std::filesystem::path& json) const;

    /// The command line without the options of declare() and without `--json FILE`.
    static std::vector<std::string> others(int argc, char** argv);

  private:
    std::filesystem::path other_, other_json_;
    unsigned turns_ = 30;
};

} // namespace lineatlas::bench
