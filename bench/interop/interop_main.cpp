// Measures hand-overs of buffers between GL and OpenCL, in every sharing mode of every device, and
// the cost of a call in a program that embeds the renderer.

#include <algorithm>
#include <filesystem>

#include <CLI/App.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "command_line/program.hpp"
#include "glpasses/headless_context.hpp"
#include "io/atomic_file.hpp"
#include "lineatlas/error.hpp"
#include "measure.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::size_t kib = 1024;

void print(const HandoverReport& report) {
    fmt::print("GL: {}\nMilliseconds, medians; order: there and back with nothing to read\n",
               report.gl);
    std::string device;
    for (const HandoverCost& cost : report.costs) {
        if (cost.device != device) {
            device = cost.device;
            fmt::print("\n{}\n{:<15} {:>9} {:>11} {:>9} {:>9} {:>9}\n", device, "mode", "KiB",
                       "to compute", "to GL", "order", "memcpy");
        }
        fmt::print("{:<15} {:>9} {:>11.3f} {:>9.3f} {:>9.3f} {:>9.3f}{}\n", cost.mode,
                   cost.bytes / kib, cost.to_compute, cost.to_gl, cost.order_only, cost.host_memcpy,
                   cost.right ? "" : "  WRONG CONTENT");
    }
    fmt::print("\nA call in a program's context, beyond its passes: {:.4f}\n", report.call);
    for (const NoHandover& none : report.left_out) fmt::print("\n{}\n", none.reason);
}

void write_json(const std::filesystem::path& path, const HandoverReport& report) {
    nlohmann::ordered_json json{{"gl", report.gl},
                                {"call_ms", report.call},
                                {"handovers", nlohmann::ordered_json::array()},
                                {"left_out", nlohmann::ordered_json::array()}};
    for (const HandoverCost& cost : report.costs) {
        json["handovers"].push_back({{"device", cost.device},
                                     {"mode", cost.mode},
                                     {"bytes", cost.bytes},
                                     {"to_compute_ms", cost.to_compute},
                                     {"to_gl_ms", cost.to_gl},
                                     {"order_only_ms", cost.order_only},
                                     {"memcpy_ms", cost.host_memcpy},
                                     {"right", cost.right}});
    }
    for (const NoHandover& none : report.left_out) {
        json["left_out"].push_back(
            {{"device", none.device}, {"mode", none.mode}, {"reason", none.reason}});
    }
    const std::string text = json.dump(2) + "\n";
    AtomicFile{path}.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

int run(int argc, char** argv) {
    CLI::App app{"Measures what handing buffers over between GL and OpenCL costs",
                 "lineatlas-bench-interop"};
    HandoverOptions options{
        .device = {}, .modes = {}, .sizes = {64, 256, 1024, 4096, 16384, 65536}, .rounds = 30};
    for (const interop::SharingMode mode : interop::all_modes)
        options.modes.emplace_back(name_of(mode));
    std::filesystem::path json;
    app.add_option("--device", options.device, "opencl:<platform>[:<device>]; default every one");
    app.add_option("--modes", options.modes, "Modes to measure where they work")
        ->delimiter(',')
        ->check(CLI::IsMember(options.modes))
        ->capture_default_str();
    app.add_option("--sizes", options.sizes, "Of buffers, in KiB")
        ->delimiter(',')
        ->check(CLI::Range(1, 1 << 20))
        ->capture_default_str();
    app.add_option("--rounds", options.rounds, "Hand-overs of each, of which the median counts")
        ->check(CLI::Range(1, 100'000))
        ->capture_default_str();
    app.add_option("--json", json, "Figures to write");
    if (const std::optional<int> code = parse(app, argc, argv)) return *code;
    for (std::size_t& size : options.sizes) size *= kib;

    const gl::HeadlessContext context;
    const HandoverReport report = measure_handovers(options);
    print(report);
    if (!json.empty()) write_json(json, report);
    return std::ranges::all_of(report.costs, &HandoverCost::right) ? 0 : 1;
}

} // namespace
} // namespace lineatlas::bench

int main(int argc, char** argv) {
    return lineatlas::run_program(argc, argv, lineatlas::bench::run, "lineatlas-bench-interop");
}
