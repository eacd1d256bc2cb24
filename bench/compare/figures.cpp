#include "figures.hpp"

#include <algorithm>
#include <fstream>

#include "core/median.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::bench {
namespace {

using Json = nlohmann::json;

/// Adds figures in the format of Google Benchmark.
void add_kernels(const Json& run, Figures& figures) {
    for (const Json& row : run.at("benchmarks")) {
        if (row.value("run_type", "iteration") != "iteration" || !row.contains("share_of_copy")) {
            continue; // a goal, a mean of rows, or a failed row
        }
        std::string name = row.at("name");
        name.erase(
            std::min(name.rfind("/manual_time"), name.size())); // every row of this kind has it
        figures.rows[name].push_back(row.at("real_time").get<double>() / 1e3);
        if (row.contains("p10_us"))
            figures.quiet[name].push_back(row.at("p10_us").get<double>() / 1e3);
    }
}

void add_frames(const Json& run, Figures& figures) {
    for (const auto& [scene, result] : run.at("scenes").items()) {
        for (const auto& [method, measured] : result.at("methods").items()) {
            const std::string name = scene + ' ' + method;
            figures.rows[name].push_back(measured.at("ms"));
            for (const auto& [stage, ms] : measured.at("stages").items())
                figures.rows[name + ' ' + stage].push_back(ms);
        }
    }
}

/// Adds the medians of trace events, of frames and of work in stages. One run gives one figure.
void add_profile(const Json& run, Figures& figures) {
    std::map<std::string, std::vector<double>> all;
    for (const Json& event : run.at("traceEvents")) {
        if (event.at("ph") != "X") continue;
        const std::string name = event.at("name"), stage = event.value("cat", "");
        all[stage == name ? name : stage + ' ' + name].push_back(event.at("dur"));
    }
    for (const auto& [name, microseconds] : all)
        figures.rows[name].push_back(median(microseconds) / 1e3);
}

} // namespace

bool add_run(const Json& run, Figures& figures) {
    if (run.contains("benchmarks")) {
        add_kernels(run, figures);
    } else if (run.contains("scenes")) {
        add_frames(run, figures);
    } else if (run.contains("traceEvents")) {
        add_profile(run, figures);
    } else {
        return false;
    }
    return true;
}

Figures read_figures(const std::filesystem::path& path) {
    std::ifstream file{path};
    if (!file) throw FileError("cannot read \"" + path.string() + "\"");
    Figures figures;
    try {
        const Json json = Json::parse(file);
        const bool by_turns = json.is_object() && json.contains("runs");
        if (by_turns) figures.turns = json.at("turns");
        bool known = true;
        for (const Json& run : by_turns ? json.at("runs") : Json::array({json}))
            known = known && run.is_object() && add_run(run, figures);
        if (known && !figures.rows.empty()) return figures;
    } catch (const Json::exception&) {
        // the message below replaces the library's
    }
    throw FileError("\"" + path.string() +
                    "\" has no figures: --json of bench kernels or bench frames writes them, and "
                    "draw --profile FILE.json");
}

Json runs_by_turns(const std::string& turns, std::vector<Json> runs) {
    return {{"turns", turns}, {"runs", std::move(runs)}};
}

} // namespace lineatlas::bench
