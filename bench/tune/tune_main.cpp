// lineatlas-bench-tune: measures values of the tuning table on a device, one parameter after the
// other, and prints the device's row of the table.
//
// The candidates of a parameter take turns. A candidate with a wrong result is left out. A value
// replaces that of the table only if its median is clearly better.

#include <algorithm>

#include <CLI/App.hpp>
#include <fmt/core.h>

#include "command_line/program.hpp"
#include "compute/opencl/quirks.hpp"
#include "lineatlas/error.hpp"
#include "parameters.hpp"

namespace lineatlas::bench {
namespace {

using compute::OpenClDevice;
using compute::Tuning;
using compute::TuningField;

/// A candidate is better if its median time is below this share of the table value's.
constexpr double clearly_better = 0.95;

bool any_wrong = false;

const TuningField& field_named(const std::string& name) {
    const auto fields = compute::tuning_fields();
    const auto found = std::ranges::find(fields, name, &TuningField::name);
    if (found == fields.end()) throw Error("the tuning table has no " + name);
    return *found;
}

/// One value of a parameter, ready to be timed.
struct Candidate {
    Tuning tuning;
    std::string text; ///< the value as text
    Devices devices{};
    Job job{};
};

std::vector<Candidate> candidates_of(const Parameter& parameter, const Tuning& current,
                                     const OpenClDevice& device) {
    const TuningField& field = field_named(parameter.field);
    std::vector<Candidate> result;
    result.push_back({current, text_of(field, current)});
    for (const std::uint32_t value : parameter.values) {
        Tuning tuning = current;
        set_value(tuning, field, value);
        tuning = within_quirks(tuning, device);
        const std::string text = text_of(field, tuning);
        if (std::ranges::find(result, text, &Candidate::text) == result.end()) {
            result.push_back({tuning, text});
        }
    }
    return result;
}

/// Makes the candidate's job. Throws Error if its result is not that of `cpp`.
void prepare(Candidate& candidate, const Parameter& parameter, const OpenClDevice& device) {
    candidate.devices = make_devices(compute::make_opencl_backend(device, {}, candidate.tuning));
    const Rows rows = parameter.rows_of(candidate.devices);
    candidate.job = std::ranges::find(rows, parameter.row, &Row::name)->prepare(parameter.n);
}

/// The candidates that the device runs with the right result.
std::vector<Candidate> prepared(std::vector<Candidate> candidates, const Parameter& parameter,
                                const OpenClDevice& device) {
    std::vector<Candidate> result;
    for (Candidate& candidate : candidates) {
        try {
            prepare(candidate, parameter, device);
            result.push_back(std::move(candidate));
        } catch (const DeviceError& error) {
            fmt::print("#   {:>6}  not possible: {}\n", candidate.text, error.what());
        } catch (const Error& error) {
            any_wrong = true;
            fmt::print("#   {:>6}  WRONG: {}\n", candidate.text, error.what());
        }
    }
    return result;
}

Tuning tuned(const Parameter& parameter, const Tuning& current, const OpenClDevice& device,
             int rounds) {
    fmt::print("# {} (ms, median of {} runs of {} with {})\n", parameter.field, rounds,
               parameter.row, parameter.n);
    const std::vector<Candidate> candidates =
        prepared(candidates_of(parameter, current, device), parameter, device);
    if (candidates.empty()) return current;
    std::vector<Job> jobs;
    for (const Candidate& candidate : candidates) jobs.push_back(candidate.job);
    const std::vector<double> seconds = race(jobs, rounds);
    for (std::size_t i = 0; i < seconds.size(); ++i) {
        fmt::print("#   {:>6}  {:8.3f}{}\n", candidates[i].text, seconds[i] * 1e3,
                   i == 0 ? "  now" : "");
    }
    std::fflush(stdout);
    const auto best = static_cast<std::size_t>(std::ranges::min_element(seconds) - seconds.begin());
    return candidates[seconds[best] < clearly_better * seconds[0] ? best : 0].tuning;
}

void print_row(const OpenClDevice& device, const Tuning& tuning) {
    fmt::print("\n[[row]]\nmatch = {{ platform = \"{}\", device = \"{}\" }} # driver {}\n",
               device.platform_name, device.device_name, device.driver_version);
    for (const TuningField& field : compute::tuning_fields()) {
        fmt::print("{} = {}\n", field.name, text_of(field, tuning));
    }
}

void measure_all(const std::string& name, const std::vector<std::string>& only, int rounds) {
    const OpenClDevice device = open_devices(name).opencl->device();
    fmt::print("# {}, driver {}\n", device.name(), device.driver_version);
    Tuning tuning = compute::tuning_for(device);
    for (const Parameter& parameter : parameters()) {
        const bool is_wanted =
            only.empty() || std::ranges::find(only, parameter.field) != only.end();
        if (!is_wanted || (parameter.is_used != nullptr && !parameter.is_used(tuning))) continue;
        tuning = tuned(parameter, tuning, device, rounds);
    }
    print_row(device, tuning);
}

int run(int argc, char** argv) {
    CLI::App app{"Measures values of kernels/tuning.toml on a device and prints a row for it",
                 "lineatlas-bench-tune"};
    std::string device;
    std::vector<std::string> only;
    int rounds = 21;
    app.add_option("--device", device, "opencl:<platform>[:<device>]; else LINEATLAS_DEVICE");
    app.add_option("--only", only, "Values to try, e.g. scan_tiles; else all");
    app.add_option("--rounds", rounds, "Runs of each candidate")->check(CLI::Range(1, 1000));
    if (const std::optional<int> code = parse(app, argc, argv)) return *code;
    measure_all(device, only, rounds);
    return any_wrong ? 1 : 0;
}

} // namespace
} // namespace lineatlas::bench

int main(int argc, char** argv) {
    return lineatlas::run_program(argc, argv, lineatlas::bench::run, "lineatlas-bench-tune");
}
