#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/App.hpp>

namespace lineatlas::bench {

/// `--interleave`: runs a benchmark of another build and that of this one by turns, each run a
/// process of its own, so that what else happens on the machine, and where memory happens to lie,
/// meets both alike.
class Turns {
  public:
    void declare(CLI::App& app);
    bool given() const { return !other_.empty(); }

    /// Runs the running program and the one of its name in the other build with `arguments` and
    /// `--json FILE`, for each of `parts` with that as one more argument; writes the figures of
    /// this build to `json` and prints the comparison. Throws UsageError if the other build has no
    /// such program, Error if a run fails.
    void run(const std::vector<std::string>& arguments, const std::vector<std::string>& parts,
             const std::filesystem::path& json) const;

    /// The command line without what declare() declares, and without `--json FILE`.
    static std::vector<std::string> others(int argc, char** argv);

  private:
    std::filesystem::path other_, other_json_;
    unsigned turns_ = 30;
};

} // namespace lineatlas::bench
