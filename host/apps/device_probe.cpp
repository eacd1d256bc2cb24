#include "device_probe.hpp"

#include <algorithm>
#include <cstring>
#include <string>

#include <fmt/core.h>

#include "command_line/child_process.hpp"
#include "glpasses/headless_context.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {
namespace {

constexpr std::string_view yes = "yes ";
constexpr std::string_view no = "no ";

/// Drivers may print what they like: the answer is the last line.
std::string last_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    const std::size_t before = text.rfind('\n');
    return before == std::string::npos ? text : text.substr(before + 1);
}

} // namespace

interop::ModeReport probe_in_child(std::size_t index, interop::SharingMode mode,
                                   std::chrono::seconds limit) {
    const auto place = std::ranges::find(interop::all_modes, mode) - interop::all_modes.begin();
    const ChildResult child =
        run_child("/proc/self/exe",
                  {"devices", probe_option, std::to_string(index), std::to_string(place)}, limit);
    if (child.timed_out) {
        return {mode, false, fmt::format("no answer within {} seconds", limit.count())};
    }
    if (child.signal != 0) {
        return {mode, false, fmt::format("the driver crashed ({})", strsignal(child.signal))};
    }
    const std::string line = last_line(child.output);
    if (line.starts_with(yes)) return {mode, true, line.substr(yes.size())};
    if (line.starts_with(no)) return {mode, false, line.substr(no.size())};
    return {mode, false, fmt::format("the driver ended the program with {}", child.exit_code)};
}

void answer_probe(std::size_t index, std::size_t mode) {
    const gl::HeadlessContext context;
    const std::vector<compute::OpenClDevice> devices = compute::list_opencl_devices();
    if (index >= devices.size() || mode >= interop::all_modes.size())
        throw UsageError("there is no such device or mode to probe");
    interop::ModeReport report = interop::probe_mode(devices[index], interop::all_modes[mode]);
    std::ranges::replace(report.reason, '\n', ' '); // build logs have lines
    print_output(fmt::format("\n{}{}\n", report.works ? yes : no, report.reason));
}

} // namespace lineatlas::apps
