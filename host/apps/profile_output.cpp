#include "profile_output.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "compute/opencl/devices.hpp"
#include "io/atomic_file.hpp"
#include "io/standard_streams.hpp"
#include "lineatlas/compute_device.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {
namespace {

constexpr const char* terminal = "-";

} // namespace

void ReportOption::declare(CLI::App& app, const std::string& help, const std::string& group) {
    app.add_option(name_, paths_, help)->expected(1)->take_all()->group(group);
}

void ReportOption::check() const {
    for (const std::string& path : paths_) {
        if (path == terminal) continue;
        const std::string extension = std::filesystem::path{path}.extension().string();
        if (std::ranges::find(extensions_, extension) == extensions_.end()) {
            throw UsageError(fmt::format("{} \"{}\": the file must end in {}, or be -", name_, path,
                                         fmt::join(extensions_, " or ")));
        }
        const AtomicFile writable{path};
    }
}

void ReportOption::add_to(OutputPlaces& places) const {
    for (const std::string& path : paths_) {
        if (path != terminal) places.writes(name_, path);
    }
}

void ReportOption::write(
    const std::function<std::string(std::string_view extension)>& report) const {
    for (const std::string& path : paths_) {
        if (path == terminal) {
            print_output(report(""));
            continue;
        }
        const std::string text = report(std::filesystem::path{path}.extension().string());
        AtomicFile{path}.commit({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    }
}

void ProfileOptions::declare(CLI::App& app, const std::string& group) {
    ReportOption::declare(app,
                          "Where a frame's time goes: .json for Perfetto or chrome://tracing, "
                          ".csv, or - for a table; may be given several times",
                          group);
}

void ProfileOptions::write(std::span<const FrameProfile> frames, const std::string& description,
                           std::span<const KernelTime> kernels) const {
    ReportOption::write([&](std::string_view extension) {
        if (extension.empty()) return profile_table(frames);
        return extension == ".csv" ? profile_csv(frames)
                                   : kernel_trace(frames, kernels, description);
    });
}

void KernelOptions::declare(CLI::App& app, const std::string& group) {
    ReportOption::declare(
        app,
        "Why each kernel takes its time: its bytes and operations, compared with what the machine "
        "reaches; .json, .csv, .svg for a roofline, or - for a table; may be given several times",
        group);
}

namespace {

/// The name of the renderer's device, as `--device` takes it; empty for one of a program's own
/// kind.
std::string device_of(const Renderer& renderer) {
    const std::string description = renderer.description();
    if (description.starts_with("cpp")) return "cpp";
    for (const compute::OpenClDevice& device : compute::list_opencl_devices())
        if (description.starts_with(device.description())) return device.name();
    return {};
}

/// How the renderer shares buffers with GL, if every device can share so; else empty.
std::string interop_of(const Renderer& renderer) {
    constexpr std::string_view mode = "host-pointer";
    return renderer.description().ends_with(mode) ? std::string{mode} : "";
}

/// Where the stages of a frame ran. Another device may choose other forms if it has the choice.
StageForms forms_of(const FrameProfile& frame, StageForms forms) {
    std::set<std::string_view> kernels, passes; // stages
    for (const ProfileEvent& event : frame.events) {
        const auto kernel =
            std::ranges::find(compute::all_kernels(), event.name, &compute::Kernel::name);
        if (event.track == ProfileTrack::gl) passes.insert(event.name);
        if (event.items > 0 && kernel != compute::all_kernels().end())
            kernels.insert(kernel->stage);
    }
    const auto settle = [&](StageForm& form, std::string_view stage) {
        if (form != StageForm::automatic) return;
        if (passes.contains(stage)) form = StageForm::raster;
        if (kernels.contains(stage)) form = StageForm::compute;
    };
    settle(forms.atlas, "atlas");
    settle(forms.depth, "depth");
    settle(forms.strokes, "strokes");
    return forms;
}

/// The kernels that were not counted, for people; empty if all were.
std::string uncounted(std::span<const KernelTime> kernels, std::span<const LaunchCounts> counts) {
    std::set<std::string_view> names;
    for (const KernelTime& kernel : kernels)
        if (std::ranges::find(counts, kernel.name, &LaunchCounts::kernel) == counts.end())
            names.insert(kernel.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

} // namespace

KernelReport KernelOptions::measure(std::span<const FrameProfile> frames, const StageForms& forms,
                                    Renderer& renderer,
                                    const std::function<void(const StageForms&)>& draw) {
    KernelReport report;
    if (!frames.empty()) report.roofs.copy = frames.back().copy_gigabytes_per_second;
    const StageForms settled = frames.empty() ? forms : forms_of(frames.back(), forms);
    const std::string device = device_of(renderer);
    std::vector<PerfCounts> perf;
    if (!device.empty()) {
        report.roofs.arithmetic = measure_arithmetic(device);
        register_perf_device();
        renderer.set_device({.compute = "perf", .device = device, .interop = interop_of(renderer)});
        draw(settled); // makes tables grow; a frame whose tables were too small is drawn again
        take_perf_counts();
        draw(settled);
        perf = take_perf_counts();
        const auto has_time = [](const PerfCounts& launch) { return launch.cpu_time.has_value(); };
        const bool is_cpu = std::ranges::any_of(perf, has_time);
        if (const std::string why = is_cpu ? why_no_perf_events() : ""; !why.empty())
            report.notes.push_back("no instructions, cycles and cache misses: " + why);
    }
    register_counting_device();
    renderer.set_device({.compute = "counting", .device = device});
    draw(settled); // makes tables grow
    take_launch_counts();
    draw(settled);
    const std::vector<LaunchCounts> counts = take_launch_counts();
    report.kernels = kernel_times(frames, counts, report.roofs, perf);
    if (const std::string names = uncounted(report.kernels, counts); !names.empty())
        report.notes.push_back("not counted, so their limit is unknown: " + names);
    return report;
}

void KernelOptions::write(const KernelReport& report) const {
    ReportOption::write([&](std::string_view extension) {
        if (extension == ".svg") return roofline_svg(report.kernels, report.roofs);
        if (extension == ".csv") return kernel_csv(report.kernels, report.roofs);
        if (extension == ".json") return kernel_json(report.kernels, report.roofs);
        std::string table = kernel_table(report.kernels, report.roofs);
        for (const std::string& note : report.notes) table += note + '\n';
        return table;
    });
}

bool ProfiledOutput::draw(const Camera& camera, const std::filesystem::path& path) {
    const bool drawn = output_.draw(camera, path);
    take(false);
    return drawn;
}

void ProfiledOutput::take(bool wait) {
    std::vector<FrameProfile> more = renderer_.take_profiles(wait);
    frames_.insert(frames_.end(), std::make_move_iterator(more.begin()),
                   std::make_move_iterator(more.end()));
}

std::vector<FrameProfile> ProfiledOutput::take() {
    take(true);
    return std::move(frames_);
}

} // namespace lineatlas::apps
