#include "device_probe.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "command_line/child_process.hpp"
#include "compute/opencl/device_trial.hpp"
#include "compute/opencl/opencl_backend.hpp"
#include "compute/opencl/programs.hpp"
#include "compute/opencl/quirks.hpp"
#include "glpasses/current_context.hpp"
#include "glpasses/headless_context.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/error.hpp"
#include "renderer/form_costs.hpp"
#include "renderer/trial_frames.hpp"

namespace lineatlas::apps {
namespace {

constexpr std::string_view yes = "yes ";
constexpr std::string_view no = "no ";
constexpr std::string_view open = "open ";

/// The answer is the last line, because drivers may print other lines before it.
std::string last_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    const std::size_t before = text.rfind('\n');
    return before == std::string::npos ? text : text.substr(before + 1);
}

/// Questions to a process, as numbers. Modes have their places; these follow.
constexpr std::size_t kernels = interop::all_modes.size(), frames = kernels + 1,
                      forms = kernels + 2;

Probe probe_in_child(std::size_t index, std::size_t what, std::chrono::seconds limit) {
    const ChildResult child =
        run_child("/proc/self/exe",
                  {"devices", probe_option, std::to_string(index), std::to_string(what)}, limit);
    if (child.timed_out)
        return {false, fmt::format("no answer within {} seconds", limit.count()), false};
    if (child.signal != 0)
        return {false, fmt::format("the driver crashed ({})", strsignal(child.signal))};
    const std::string line = last_line(child.output);
    if (line.starts_with(yes)) return {true, line.substr(yes.size())};
    if (line.starts_with(no)) return {false, line.substr(no.size())};
    if (line.starts_with(open)) return {false, line.substr(open.size()), false};
    return {false, fmt::format("the driver ended the program with {}", child.exit_code)};
}

Probe compile_kernels(const compute::OpenClDevice& device) {
    try {
        const auto compile = [&](const DeviceOptions&) { compute::compile_all(device); };
        if (!compute::try_device(*compute::make_opencl_backend(device), "programs", compile))
            compile({}); // which keeps no result
    } catch (const DeviceError& error) {
        return {false, error.what()};
    }
    return {true, "all programs compile"};
}

Probe compare_frames(const compute::OpenClDevice& device) {
    if (compute::collides_with_llvmpipe(device))
        return {false, "not tried, because this driver crashes beside Mesa's llvmpipe", false};
    try {
        const gl::HeadlessContext context;
        const auto backend = compute::make_opencl_backend(device);
        for (const auto mode : {interop::SharingMode::host_pointer, interop::SharingMode::copy})
            if (try_frames(*backend, mode)) return {true, "small frames equal those of C++"};
    } catch (const DeviceError& error) {
        return {false, error.what()};
    }
    return {false, "not tried: there is no cache to keep the answer in, or no frame could be drawn",
            false};
}

std::string describe(const interop::HandoverRate& rate) {
    std::string text = fmt::format("{:.2g} ms", rate.milliseconds);
    if (std::isfinite(rate.bytes_per_millisecond))
        text += fmt::format(" and {:.2g} GB/s", rate.bytes_per_millisecond / 1e6);
    return text;
}

/// The stages that kernels run, or those that GL runs.
std::string stages_of(const AutomaticForms& forms, bool by_kernels) {
    std::string names;
    for (const auto& [name, is_by_kernels] :
         {std::pair{"depth", forms.depth}, std::pair{"samples", forms.atlas},
          std::pair{"strokes", forms.strokes}, std::pair{"fills of exact", forms.fill}}) {
        if (is_by_kernels != by_kernels) continue;
        if (!names.empty()) names += ", ";
        names += name;
    }
    return names.empty() ? "nothing" : names;
}

Probe find_forms(const compute::OpenClDevice& device) {
    const gl::HeadlessContext context;
    try {
        const interop::Connection connection = interop::connect({.device = device.name()});
        const interop::HandoverRates rates = interop::handover_rates(*connection.sharing);
        const compute::Tuning& tuning = connection.device->tuning();
        const AutomaticForms forms = forms_for(tuning, rates);
        const auto milliseconds = [&](const AutomaticForms& some) {
            return frame_milliseconds(some, rates,
                                      stage_times(place_of(tuning), !gl::is_software()));
        };
        return {true,
                fmt::format(
                    "by kernels: {}; by GL: {}; {:.2g} ms of a frame, all by GL {:.2g}, "
                    "all by kernels {:.2g}; {}: {} to kernels, {} to GL ({})",
                    stages_of(forms, true), stages_of(forms, false), milliseconds(forms),
                    milliseconds({}), milliseconds({.depth = true, .atlas = true, .strokes = true}),
                    interop::name_of(connection.sharing->mode()), describe(rates.to_compute),
                    describe(rates.to_gl), rates.measured ? "measured" : "assumed")};
    } catch (const DeviceError& error) {
        return {false, error.what()};
    }
}

Probe try_mode(const compute::OpenClDevice& device, interop::SharingMode mode) {
    const gl::HeadlessContext context;
    const interop::ModeReport report = interop::probe_mode(device, mode);
    return {report.works, report.reason};
}

} // namespace

Probe probe_kernels(std::size_t index, std::chrono::seconds limit) {
    return probe_in_child(index, kernels, limit);
}

Probe probe_frames(std::size_t index, std::chrono::seconds limit) {
    return probe_in_child(index, frames, limit);
}

Probe probe_forms(std::size_t index, std::chrono::seconds limit) {
    return probe_in_child(index, forms, limit);
}

Probe probe_mode(std::size_t index, interop::SharingMode mode, std::chrono::seconds limit) {
    const auto place = std::ranges::find(interop::all_modes, mode) - interop::all_modes.begin();
    return probe_in_child(index, static_cast<std::size_t>(place), limit);
}

void answer_probe(std::size_t index, std::size_t what) {
    const std::vector<compute::OpenClDevice> devices = compute::list_opencl_devices();
    if (index >= devices.size() || what > forms)
        throw UsageError("there is no such device or mode to probe");
    Probe probe = what == kernels  ? compile_kernels(devices[index])
                  : what == frames ? compare_frames(devices[index])
                  : what == forms  ? find_forms(devices[index])
                                   : try_mode(devices[index], interop::all_modes[what]);
    std::ranges::replace(probe.reason, '\n', ' ');
    print_output(fmt::format("\n{}{}\n",
                             probe.works      ? yes
                             : probe.is_known ? no
                                              : open,
                             probe.reason));
}

} // namespace lineatlas::apps
