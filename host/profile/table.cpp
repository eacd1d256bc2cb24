#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "core/median.hpp"
#include "lineatlas/profile.hpp"

namespace lineatlas {
namespace {

/// The times of a kernel, a transfer or a GL pass within one stage.
struct Work {
    ProfileTrack track;
    std::string name;
    std::vector<double> each{}; ///< nanoseconds
    double sum = 0;
    double items = 0, bytes = 0; ///< sums
    std::uint32_t group = 0;
};

struct Stage {
    std::string name;
    std::vector<double> frames{}; ///< nanoseconds of each frame that has it
    double sum = 0;
    std::vector<Work> work{};
};

struct Summary {
    std::vector<Stage> stages; ///< in the order in which they begin
    std::vector<double> frames;
    double sum = 0;
    double covered = 0;

    explicit Summary(std::span<const FrameProfile> profiles) {
        for (const FrameProfile& frame : profiles) add(frame);
    }

  private:
    Stage& stage(const std::string& name) {
        const auto known = std::ranges::find(stages, name, &Stage::name);
        return known != stages.end() ? *known : stages.emplace_back(Stage{name});
    }

    void add(const FrameProfile& frame) {
        frames.push_back(static_cast<double>(frame.end - frame.start));
        sum += frames.back();
        for (const ProfileEvent& event : frame.events) add(event);
        for (const StageShare& share : stage_shares(frame)) {
            Stage& of = stage(share.stage);
            of.frames.push_back(share.nanoseconds);
            of.sum += share.nanoseconds;
            covered += share.nanoseconds;
        }
    }

    void add(const ProfileEvent& event) {
        if (event.stage.empty()) return;
        Stage& of = stage(event.stage);
        if (event.track == ProfileTrack::host || event.track == ProfileTrack::handover) return;
        auto known = std::ranges::find_if(of.work, [&](const Work& work) {
            return work.track == event.track && work.name == event.name;
        });
        if (known == of.work.end()) {
            known = of.work.insert(known, Work{event.track, event.name});
        }
        known->each.push_back(static_cast<double>(event.end - event.start));
        known->sum += known->each.back();
        known->items += static_cast<double>(event.items);
        known->bytes += static_cast<double>(event.bytes);
        known->group = std::max(known->group, event.group);
    }
};

std::string row(const std::string& name, const char* track, double count, double middle, double sum,
                double share) {
    return fmt::format("{:<24}{:<9}{:>7.1f}{:>12.3f}{:>12.2f}{:>9.1f}", name, track, count,
                       middle * 1e-6, sum * 1e-6, 100 * share);
}

/// Columns with the size of a launch, and its bytes a second beside those of a copy.
std::string size_columns(const Work& work, double copy) {
    if (work.bytes == 0) return {};
    const auto launches = static_cast<double>(work.each.size());
    const double rate = work.sum > 0 ? work.bytes / work.sum : 0;
    std::string text = work.items > 0
                           ? fmt::format("{:>11.0f}{:>7}", work.items / launches, work.group)
                           : fmt::format("{:18}", "");
    text += fmt::format("{:>10.2f}{:>9.2f}", work.bytes / launches * 1e-6, rate);
    if (copy > 0) text += fmt::format("{:>9.1f}", 100 * rate / copy);
    return text;
}

/// How exact the times of a queue are in the worst frame.
std::string accuracy(std::span<const FrameProfile> frames, const char* name,
                     std::optional<std::int64_t> FrameProfile::*error) {
    std::int64_t worst = -1;
    for (const FrameProfile& frame : frames) worst = std::max(worst, (frame.*error).value_or(-1));
    if (worst < 0) return fmt::format("{} keeps no times of its own", name);
    return fmt::format("{} within {:.2f} us", name, static_cast<double>(worst) * 1e-3);
}

} // namespace

std::string profile_table(std::span<const FrameProfile> frames) {
    if (frames.empty()) return "no frame was profiled\n";
    const Summary summary{frames};
    const auto count = static_cast<double>(frames.size());
    const double copy = frames.back().copy_gigabytes_per_second;
    std::string text = fmt::format("{:<24}{:<9}{:>7}{:>12}{:>12}{:>9}{:>11}{:>7}{:>10}{:>9}{:>9}\n",
                                   "stage, kernel or pass", "queue", "a frame", "median ms",
                                   "sum ms", "% of all", "items", "group", "MB", "GB/s", "% copy");
    for (const Stage& stage : summary.stages) {
        text += row(stage.name, "", static_cast<double>(stage.frames.size()) / count,
                    median(stage.frames), stage.sum, stage.sum / summary.sum) +
                '\n';
        for (const Work& work : stage.work) {
            text += row("  " + work.name, name_of(work.track),
                        static_cast<double>(work.each.size()) / count, median(work.each), work.sum,
                        work.sum / summary.sum) +
                    size_columns(work, copy) + '\n';
        }
    }
    text += row("stages", "", 1, summary.covered / count, summary.covered,
                summary.covered / summary.sum) +
            '\n';
    text += row("frame", "", 1, median(summary.frames), summary.sum, 1) + '\n';
    fmt::format_to(std::back_inserter(text), "covered: {:.1f} % of {} frames; {}; {}; {} dropped\n",
                   100 * summary.covered / summary.sum, frames.size(),
                   accuracy(frames, "GL", &FrameProfile::gl_error),
                   accuracy(frames, "compute", &FrameProfile::compute_error),
                   frames.back().dropped);
    if (copy > 0) {
        fmt::format_to(std::back_inserter(text), "a copy on the compute device: {:.2f} GB/s\n",
                       copy);
    }
    return text;
}

} // namespace lineatlas
