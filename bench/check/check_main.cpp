// The program behind a bundle's script `check`. It runs every part in a process of its own for a
// limited time, and collects their results in one JSON file.

#include <algorithm>
#include <cstdio>
#include <fstream>

#include <CLI/App.hpp>
#include <dlfcn.h>
#include <fmt/core.h>

#include "command_line/program.hpp"
#include "command_line/scratch.hpp"
#include "lineatlas/error.hpp"
#include "machine.hpp"
#include "markdown.hpp"
#include "pictures.hpp"
#include "report.hpp"
#include "scan.hpp"

namespace lineatlas::bench {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

bool has(const char* library) {
    return ::dlopen(library, RTLD_LAZY) != nullptr;
}

/// True if GL's libraries can be loaded. Without them libepoxy would end the program.
bool has_gl() {
    return has("libEGL.so.1") && (has("libOpenGL.so.0") || has("libGL.so.1"));
}

struct Options {
    fs::path bundle = ".", json = "check.json";
    unsigned minutes = 5;
    unsigned limit = 240;           ///< seconds
    std::vector<std::string> parts; ///< empty: all
};

/// Runs one part and adds its result to the report. False if the part failed.
bool run_part(Part part, Clock::time_point end, const Places& places, Json& report) {
    if (!part.picture.empty()) fs::remove(places.pictures / part.picture); // that of an earlier run
    const auto left = std::chrono::floor<std::chrono::seconds>(end - Clock::now());
    part.limit = std::min(part.limit, left);
    fmt::print("{:<24}", part.name);
    std::fflush(stdout);
    if (part.limit.count() <= 0) {
        fmt::print("left out, the time is over\n");
        report["parts"].push_back({{"name", part.name}, {"outcome", "left out"}});
        return false;
    }
    const fs::path written =
        places.scratch / (part.kind == PartKind::tests ? "part.xml" : "part.json");
    fs::remove(written);
    if (part.kind != PartKind::output) part.arguments.push_back(output_option(part.kind, written));
    ChildResult result;
    try {
        result = run_child(part.program, part.arguments, part.limit, Captured::output_and_errors);
    } catch (const Error& error) {
        result.output = error.what(); // a missing program must not stop the other parts
    }
    if (part.kind == PartKind::devices) {
        std::ifstream input{written};
        const Json devices = Json::parse(input, nullptr, false);
        if (devices.is_object()) report.update(devices);
        fmt::print("\n{}", result.output);
    }
    report["parts"].push_back(describe_part(part, result, written));
    if (!part.picture.empty() && fs::exists(places.pictures / part.picture)) {
        Json& described = report["parts"].back();
        described["picture"] = (places.pictures.filename() / part.picture).generic_string();
        for (const auto& [whose, other] : part.others) {
            Json compared = compare_pictures(places.pictures / part.picture, other);
            if (!compared.is_null()) described["compared"][whose] = std::move(compared);
        }
    }
    fmt::print("{}, {:.1f} s\n", outcome(part, result), result.took.count());
    return outcome(part, result) == "ok";
}

bool check(const Options& options) {
    const fs::path json = fs::absolute(options.json);
    const fs::path markdown = fs::path{json}.replace_extension(".md");
    fs::current_path(options.bundle); // tests look for their files here
    const Scratch scratch;
    const Places places{.scratch = scratch.folder,
                        .pictures = json.parent_path() / (json.stem().string() + "-pictures"),
                        .shipped = fs::absolute("share/pictures"),
                        .scan = scratch.folder / "scan.obj"};
    fs::create_directories(places.pictures);
    write_scan(places.scan);
    const auto end = Clock::now() + std::chrono::minutes{options.minutes};
    Json report{{"machine", describe_machine()}, {"parts", Json::array()}};
    bool all = true;
    for (Part part : all_parts(places)) {
        if (!options.parts.empty() &&
            std::ranges::find(options.parts, part.name) == options.parts.end()) {
            continue;
        }
        part.limit = std::min(part.limit, std::chrono::seconds{options.limit});
        all = run_part(part, end, places, report) && all;
        write_report(json, report); // after each part, so that a crash loses nothing
        write_markdown(markdown, report);
    }
    fmt::print("\n{} For people: {}; all figures: {}\n",
               all ? "All parts passed." : "Some parts failed.", markdown.string(), json.string());
    return all;
}

int run(int argc, char** argv) {
    CLI::App app{"Runs all parts of a bundle on this machine and writes what they say to one file",
                 "lineatlas-check"};
    Options options;
    app.add_option("--bundle", options.bundle, "The folder of the bundle")->capture_default_str();
    app.add_option("--json", options.json, "File to write, and beside it one for people (.md)")
        ->capture_default_str();
    app.add_option("--minutes", options.minutes, "What is not begun by then is left out")
        ->check(CLI::Range(1, 600))
        ->capture_default_str();
    app.add_option("--limit", options.limit, "Seconds that no part may take longer than")
        ->check(CLI::Range(1, 600))
        ->capture_default_str();
    app.add_option("--part", options.parts, "Only this one; may be given again");
    bool gl_only = false;
    app.add_flag("--has-gl", gl_only,
                 "Only say, by exit code 0 or 1, whether libraries for GL are there");
    bool opencl_only = false;
    app.add_flag("--has-opencl", opencl_only, "Likewise for OpenCL's loader");
    if (const std::optional<int> code = parse(app, argc, argv)) return *code;
    if (opencl_only) return has("libOpenCL.so.1") ? 0 : 1;
    if (gl_only) return has_gl() ? 0 : 1;
    return check(options) ? 0 : 1;
}

} // namespace
} // namespace lineatlas::bench

int main(int argc, char** argv) {
    return lineatlas::run_program(argc, argv, lineatlas::bench::run, "lineatlas-check");
}
