#include "profile_output.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

#include "compute/opencl/devices.hpp"
#include "io/atomic_file.hpp"
#include "io/standard_streams.hpp"
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

} // namespace

KernelReport KernelOptions::measure(std::span<const FrameProfile> frames, Renderer& renderer,
                                    const std::function<void()>& draw) {
    KernelReport report;
    if (!frames.empty()) report.roofs.copy = frames.back().copy_gigabytes_per_second;
    std::vector<PerfCounts> perf;
    if (const std::string device = device_of(renderer); !device.empty()) {
        report.roofs.arithmetic = measure_arithmetic(device);
        register_perf_device();
        renderer.set_device({.compute = "perf", .device = device});
        draw(); // makes tables grow; a frame whose tables were too small is drawn again
        take_perf_counts();
        draw();
        perf = take_perf_counts();
        const auto has_time = [](const PerfCounts& launch) { return launch.cpu_time.has_value(); };
        if (std::ranges::any_of(perf, has_time)) report.note = why_no_perf_events();
    }
    register_counting_device();
    renderer.set_device({.compute = "counting"});
    draw(); // makes tables grow
    take_launch_counts();
    draw();
    report.kernels = kernel_times(frames, take_launch_counts(), report.roofs, perf);
    return report;
}

void KernelOptions::write(const KernelReport& report) const {
    ReportOption::write([&](std::string_view extension) {
        if (extension == ".svg") return roofline_svg(report.kernels, report.roofs);
        if (extension == ".csv") return kernel_csv(report.kernels, report.roofs);
        if (extension == ".json") return kernel_json(report.kernels, report.roofs);
        const std::string table = kernel_table(report.kernels, report.roofs);
        if (report.note.empty()) return table;
        return table + fmt::format("no instructions, cycles and cache misses: {}\n", report.note);
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
