#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace lineatlas::bench {

/// The times of one build: one figure per row of a benchmark and run.
struct Figures {
    /// Names the session in which two builds ran by turns; empty: they did not. Both files of a
    /// session have the same name. The n-th figure of a row in one file belongs to the n-th in the
    /// other file.
    std::string turns;
    std::map<std::string, std::vector<double>> rows; ///< milliseconds
    /// The 10th percentile of each run, for rows of `bench kernels` that report it. Other work on
    /// the machine changes this percentile least.
    std::map<std::string, std::vector<double>> quiet;
};

/// Adds the figures of a run. `run` is the JSON of `bench kernels`, `bench frames` or `draw
/// --profile`. Returns false if it is none of them.
bool add_run(const nlohmann::json& run, Figures& figures);

/// Reads a file that `--json` wrote, of one run or of runs by turns. Throws FileError.
Figures read_figures(const std::filesystem::path& path);

/// The JSON of runs by turns: `turns` as in Figures, and the JSON of each run.
nlohmann::json runs_by_turns(const std::string& turns, std::vector<nlohmann::json> runs);

} // namespace lineatlas::bench
