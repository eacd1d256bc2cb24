#include "turns.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join
#include <unistd.h>

#include "command_line/child_process.hpp"
#include "command_line/scratch.hpp"
#include "common/progress.hpp"
#include "comparison.hpp"
#include "io/atomic_file.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// The smallest change that the summary reports. `bench compare --fail-over` has its own limit.
constexpr double least_change = 0.03;

fs::path this_program() {
    return fs::read_symlink("/proc/self/exe");
}

/// The program of this name in the folder of a build. `build` may also be the program itself.
fs::path program_of(const fs::path& build) {
    const fs::path program = fs::is_directory(build) ? build / this_program().filename() : build;
    if (::access(program.c_str(), X_OK) == 0 && fs::is_regular_file(program)) return program;
    throw UsageError(fmt::format("--interleave \"{}\": there is no {} that can be run; name the "
                                 "folder of a build",
                                 build.string(), this_program().filename().string()));
}

Json run_once(const fs::path& program, std::vector<std::string> arguments, const fs::path& file) {
    constexpr std::chrono::seconds limit = std::chrono::hours{1};
    fs::remove(file);
    arguments.insert(arguments.end(), {"--json", file.string()});
    const ChildResult result = run_child(program, arguments, limit, Captured::output_and_errors);
    std::ifstream input{file};
    Json json = Json::parse(input, nullptr, false);
    if (result.exit_code == 0 && json.is_object()) return json;
    throw Error(fmt::format("{} {} failed: {}", program.string(), fmt::join(arguments, " "),
                            result.output));
}

void write_runs(const fs::path& path, const std::string& turns, std::vector<Json> runs) {
    if (path.empty()) return;
    const std::string text =
        runs_by_turns(turns, std::move(runs)).dump(1, ' ', false, Json::error_handler_t::replace) +
        "\n";
    AtomicFile{path}.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

/// A name that no other session of runs by turns has.
std::string name_of_turns() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return fmt::format("{}-{}", std::chrono::floor<std::chrono::seconds>(now).count(), ::getpid());
}

} // namespace

void Turns::declare(CLI::App& app) {
    auto* other = app.add_option("--interleave", other_,
                                 "Folder of another build: both are run by turns and compared");
    app.add_option("--turns", turns_, "Runs of each build")
        ->needs(other)
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    app.add_option("--json-other", other_json_,
                   "Figures of the other build to write, for lineatlas bench compare")
        ->needs(other);
}

std::vector<std::string> Turns::others(int argc, char** argv) {
    std::vector<std::string> result;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const auto own = {"--interleave", "--turns", "--json-other", "--json"};
        if (std::ranges::find(own, word) != own.end()) {
            ++i; // and its value
        } else if (std::ranges::find(own, word.substr(0, word.find('='))) == own.end()) {
            result.emplace_back(word);
        }
    }
    return result;
}

void Turns::run(const std::vector<std::string>& arguments, const std::vector<std::string>& parts,
                const fs::path& json) const {
    const std::array programs{program_of(other_), this_program()};
    for (const fs::path& path : {json, other_json_})
        if (!path.empty()) const AtomicFile writable{path};
    const Scratch scratch;
    Progress progress;
    std::array<std::vector<Json>, 2> runs;
    for (const std::string& part : parts) {
        std::vector<std::string> words = arguments;
        if (!part.empty()) words.push_back(part);
        for (unsigned turn = 0; turn < turns_; ++turn) {
            progress.detail(fmt::format("{}: {} of {} turns", part, turn, turns_));
            // The order changes with every turn, so that neither build is always the later one.
            for (const std::size_t i : {turn % 2U, 1U - turn % 2U})
                runs[i].push_back(run_once(programs[i], words, scratch.folder / "run.json"));
        }
    }
    progress.clear();
    const std::string name = name_of_turns();
    std::array<Figures, 2> figures;
    for (std::size_t i = 0; i < 2; ++i) {
        figures[i].turns = name;
        for (const Json& run : runs[i]) add_run(run, figures[i]);
    }
    write_runs(other_json_, name, std::move(runs[0]));
    write_runs(json, name, std::move(runs[1]));
    print_output(table(compare(figures[0], figures[1], least_change)));
}

} // namespace lineatlas::bench
