#include "profile_output.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <CLI/App.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h> // fmt::join

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

void ProfileOptions::write(std::span<const FrameProfile> frames,
                           const std::string& description) const {
    ReportOption::write([&](std::string_view extension) {
        if (extension.empty()) return profile_table(frames);
        return extension == ".csv" ? profile_csv(frames) : profile_trace(frames, description);
    });
}

void KernelOptions::declare(CLI::App& app, const std::string& group) {
    ReportOption::declare(
        app,
        "Why each kernel takes its time: its bytes and operations, compared with what the machine "
        "reaches; .json, .csv, .svg for a roofline, or - for a table; may be given several times",
        group);
}

void KernelOptions::write(std::span<const FrameProfile> frames, Renderer& renderer,
                          const std::function<void()>& draw) const {
    const Roofs roofs{frames.empty() ? 0 : frames.back().copy_gigabytes_per_second,
                      measure_arithmetic()};
    register_counting_device();
    renderer.set_device({.compute = "counting"});
    draw(); // makes tables grow; a frame whose tables were too small is drawn again
    take_launch_counts();
    draw();
    const std::vector<KernelTime> kernels = kernel_times(frames, take_launch_counts(), roofs);
    ReportOption::write([&](std::string_view extension) {
        if (extension.empty()) return kernel_table(kernels, roofs);
        if (extension == ".svg") return roofline_svg(kernels, roofs);
        return extension == ".csv" ? kernel_csv(kernels, roofs) : kernel_json(kernels, roofs);
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
