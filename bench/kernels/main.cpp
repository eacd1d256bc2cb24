// lineatlas-bench-kernels: times every kernel, and rivals of some, from 2^14 to 2^24 elements.
//
// The time is the mean wall-clock time of a run, including the wait for the device.
// bytes_per_second and share_of_copy come from the median, which other work on the machine affects
// less. p10_us and p90_us are the 10th and 90th percentiles; they show that effect. Rows at small
// sizes show the cost of a launch.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>

#include <CLI/App.hpp>
#include <benchmark/benchmark.h>

#include "command_line/child_process.hpp"
#include "command_line/program.hpp"
#include "compare/turns.hpp"
#include "core/median.hpp"
#include "goals.hpp"
#include "lineatlas/error.hpp"
#include "watch.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::int64_t smallest = 1 << 14, largest = 1 << 24;

bool any_failed = false;

void fail(benchmark::State& state, const std::exception& error) {
    any_failed = true;
    state.SkipWithError(error.what());
}

/// The job of a row. Google Benchmark calls a row several times to find the number of runs, so the
/// last job is kept.
const Job& prepared(const Row& row, std::uint32_t n) {
    static std::pair<std::string, std::uint32_t> key;
    static Job job;
    if (key != std::pair{row.name, n}) {
        job = {}; // frees the old job's memory before the new job takes some
        key = {};
        job = row.prepare(n);
        key = {row.name, n};
    }
    return job;
}

void time_row(benchmark::State& state, const Devices& devices, const Row& row) {
    try {
        const auto n = static_cast<std::uint32_t>(state.range(0));
        const double limit = copy_limit(devices, n);
        const Job& job = prepared(row, n);
        std::vector<double> seconds;
        for (auto _ : state) {
            seconds.push_back(seconds_of(job));
            state.SetIterationTime(seconds.back());
        }
        const double middle = median(seconds);
        const double speed = job.bytes / middle;
        state.counters["bytes_per_second"] = {speed, benchmark::Counter::kDefaults,
                                              benchmark::Counter::kIs1000};
        state.counters["share_of_copy"] = speed / limit;
        state.counters["median_us"] = 1e6 * middle;
        state.counters["p10_us"] = 1e6 * quantile(seconds, 0.1);
        state.counters["p90_us"] = 1e6 * quantile(seconds, 0.9);
    } catch (const std::exception& error) {
        fail(state, error);
    }
}

void time_goal(benchmark::State& state, Goal& goal, const Rows& rows) {
    try {
        for (auto _ : state) measure(goal, rows);
        state.counters["wanted"] = goal.wanted;
        state.counters["seen"] = goal.seen;
        state.counters["reached"] = goal.seen >= goal.wanted ? 1 : 0;
    } catch (const std::exception& error) {
        fail(state, error);
    }
}

void list(const Devices& devices) {
    for (const Row& row : all_rows(devices)) std::cout << row.name << '\n';
}

void measure_all(const Devices& devices) {
    benchmark::AddCustomContext("device", devices.opencl->description());
    benchmark::AddCustomContext("driver", devices.opencl->device().driver_version);
    const Rows rows = all_rows(devices);
    for (const Row& row : rows) {
        benchmark::RegisterBenchmark(
            row.name.c_str(), [&](benchmark::State& state) { time_row(state, devices, row); })
            ->RangeMultiplier(4)
            ->Range(smallest, largest)
            ->UseManualTime()
            ->Unit(benchmark::kMicrosecond);
    }
    std::vector<Goal> goals = known_goals();
    for (Goal& goal : goals) {
        benchmark::RegisterBenchmark(("goal/" + goal.name).c_str(),
                                     [&](benchmark::State& state) { time_goal(state, goal, rows); })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    }
    benchmark::RunSpecifiedBenchmarks();
    // The stream of rows may be JSON or CSV, where goals are rows. So the table goes elsewhere.
    if (std::ranges::any_of(goals, [](const Goal& goal) { return goal.seen != 0; })) {
        std::cerr << table(goals);
    }
}

/// The rows that `arguments` choose. Each result is an argument that chooses that row alone.
std::vector<std::string> rows_of(std::vector<std::string> arguments) {
    constexpr std::chrono::seconds limit = std::chrono::minutes{10};
    arguments.emplace_back("--benchmark_list_tests=true");
    const auto self = std::filesystem::read_symlink("/proc/self/exe");
    const ChildResult listed = run_child(self, arguments, limit);
    std::istringstream lines{listed.output};
    std::vector<std::string> rows;
    for (std::string name; std::getline(lines, name);) {
        if (!name.starts_with("goal/")) rows.push_back("--benchmark_filter=^" + name + "$");
    }
    if (rows.empty()) throw UsageError("no row is chosen by --benchmark_filter; --list has them");
    return rows;
}

int run(int argc, char** argv) {
    CLI::App app{"Times every kernel beside its rivals, from 2^14 to 2^24 elements",
                 "lineatlas-bench-kernels"};
    std::string device, form, json;
    bool only_list = false;
    app.add_option("--device", device, "opencl:<platform>[:<device>]; else LINEATLAS_DEVICE");
    app.add_option("--form", form, "Launch parameters of a cpu or a gpu; else the device's own")
        ->check(CLI::IsMember({"cpu", "gpu"}));
    app.add_flag("--list", only_list, "Print the names of the rows, and measure nothing");
    app.add_option("--json", json, "Figures to write");
    Watched watched{.name = {}, .size = 1U << 18U, .device = {}};
    auto* watch_option = app.add_option("--watch", watched.name,
                                        "A stage or kernel to measure each time that a file in "
                                        "LINEATLAS_KERNEL_DIR is written");
    app.add_option("--size", watched.size, "Elements that --watch measures it at")
        ->capture_default_str()
        ->check(CLI::Range(1, 1 << 24))
        ->needs(watch_option);
    Turns turns;
    turns.declare(app);
    app.allow_extras();
    app.footer("Flags of Google Benchmark are passed on, e.g. --benchmark_filter=scan or "
               "--benchmark_min_time=0.5.");
    if (const std::optional<int> code = parse(app, argc, argv)) return *code;

    if (!watched.name.empty()) {
        watched.device = device;
        watched.form = form;
        watch(watched);
    }
    if (turns.given()) {
        const std::vector<std::string> arguments = Turns::others(argc, argv);
        turns.run(arguments, rows_of(arguments), json);
        return 0;
    }
    // Short by default, because there are more than a hundred rows. The user's arguments come later
    // and win.
    std::vector<std::string> passed_on{argv[0], "--benchmark_min_time=0.1",
                                       "--benchmark_counters_tabular=true"};
    if (!json.empty()) {
        passed_on.push_back("--benchmark_out=" + json);
        passed_on.emplace_back("--benchmark_out_format=json");
    }
    for (const std::string& extra : app.remaining()) passed_on.push_back(extra);
    std::vector<char*> pointers;
    for (std::string& argument : passed_on) pointers.push_back(argument.data());
    int count = static_cast<int>(pointers.size());
    benchmark::Initialize(&count, pointers.data());
    if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 2;
    const Devices devices = open_devices(device, form);
    only_list ? list(devices) : measure_all(devices);
    return any_failed ? 1 : 0;
}

} // namespace
} // namespace lineatlas::bench

int main(int argc, char** argv) {
    return lineatlas::run_program(argc, argv, lineatlas::bench::run, "lineatlas-bench-kernels");
}
