#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace lineatlas::bench {

/// What one build took: for each row of a benchmark one figure per run of it.
struct Figures {
    /// Of which builds were run by turns; empty: they were not. Two files of the same turns have
    /// the same, and the n-th figure of a row in one belongs to the n-th in the other.
    std::string turns;
    std::map<std::string, std::vector<double>> rows; ///< milliseconds
    /// The 10th percentile of each run, which other work on the machine moves least; of rows of
    /// `bench kernels` that tell it.
    std::map<std::string, std::vector<double>> quiet;
};

/// Adds a run's figures: the JSON of `bench kernels`, of `bench frames`, or of `draw --profile`.
/// False if it is none of them.
bool add_run(const nlohmann::json& run, Figures& figures);

/// Reads what `--json` wrote: of one run, or of runs by turns. Throws FileError.
Figures read_figures(const std::filesystem::path& path);

/// The JSON of runs by turns: `turns` as in Figures, and each run's own JSON.
nlohmann::json runs_by_turns(const std::string& turns, std::vector<nlohmann::json> runs);

} // namespace lineatlas::bench
