#include <algorithm>
#include <iterator>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/median.hpp"
#include "lineatlas/kernel_profile.hpp"

namespace lineatlas {
namespace {

/// The launches of a kernel within a stage.
struct Launches {
    std::vector<double> each{};                          ///< nanoseconds
    double bytes = 0, operations = 0;                    ///< sums of all counted launches
    std::vector<double> byte_rates{}, operation_rates{}; ///< of each counted launch, per nanosecond
};

/// The launches of each kernel in the frame that was counted.
using Counts = std::map<std::string, std::vector<LaunchCounts>>;

/// The work of the k-th of a frame's `all` launches of a kernel: that of the k-th counted launch,
/// or an equal part if a device divides the work differently.
LaunchCounts part_of(const std::vector<LaunchCounts>& counted, std::size_t k, std::size_t all) {
    if (counted.size() == all) return counted[k];
    LaunchCounts sum;
    for (const LaunchCounts& launch : counted) {
        sum.bytes += launch.bytes;
        sum.operations += launch.operations;
    }
    return {{}, sum.bytes / all, sum.operations / all};
}

using ByStageAndName = std::map<std::pair<std::string, std::string>, Launches>;

bool is_launch(const ProfileEvent& event) {
    return event.track == ProfileTrack::compute && event.items > 0;
}

void add(const FrameProfile& frame, const Counts& counts, ByStageAndName& all) {
    std::map<std::string, std::size_t> launches, seen;
    for (const ProfileEvent& event : frame.events)
        if (is_launch(event)) ++launches[event.name];
    for (const ProfileEvent& event : frame.events) {
        if (!is_launch(event)) continue;
        Launches& own = all[{event.stage, event.name}];
        own.each.push_back(static_cast<double>(event.end - event.start));
        const auto counted = counts.find(event.name);
        if (counted == counts.end()) continue;
        const LaunchCounts launch =
            part_of(counted->second, seen[event.name]++, launches[event.name]);
        const double taken = std::max(own.each.back(), 1.0);
        const auto bytes = static_cast<double>(launch.bytes);
        const auto operations = static_cast<double>(launch.operations);
        own.bytes += bytes;
        own.operations += operations;
        own.byte_rates.push_back(bytes / taken);
        own.operation_rates.push_back(operations / taken);
    }
}

Bound bound_of(const KernelTime& kernel, const Roofs& roofs, double shortest) {
    constexpr double near_launch = 3, near_roof = 0.5;
    if (kernel.bytes == 0) return Bound::unknown;
    if (kernel.median < near_launch * shortest) return Bound::launch;
    const double memory = roofs.copy > 0 ? kernel.gigabytes_per_second / roofs.copy : 0;
    const double arithmetic =
        roofs.arithmetic > 0 ? kernel.gigaops_per_second / roofs.arithmetic : 0;
    if (std::max(memory, arithmetic) < near_roof) return Bound::latency;
    return memory > arithmetic ? Bound::memory : Bound::arithmetic;
}

KernelTime time_of(const std::pair<std::string, std::string>& key, const Launches& launches) {
    KernelTime kernel{.stage = key.first, .name = key.second, .launches = launches.each.size()};
    kernel.median = median(launches.each);
    kernel.p10 = quantile(launches.each, 0.1);
    kernel.p90 = quantile(launches.each, 0.9);
    for (const double each : launches.each) kernel.sum += each;
    if (!launches.byte_rates.empty()) {
        const auto counted = static_cast<double>(launches.byte_rates.size());
        kernel.bytes = launches.bytes / counted;
        kernel.operations = launches.operations / counted;
        kernel.gigabytes_per_second = median(launches.byte_rates);
        kernel.gigaops_per_second = median(launches.operation_rates);
    }
    return kernel;
}

/// A share in percent; "-" if there is no roof.
std::string share(double value, double roof) {
    return roof > 0 ? fmt::format("{:.1f}", 100 * value / roof) : "-";
}

} // namespace

const char* name_of(Bound bound) {
    switch (bound) {
    case Bound::launch:
        return "launch";
    case Bound::memory:
        return "memory";
    case Bound::arithmetic:
        return "arithmetic";
    case Bound::latency:
        return "latency";
    case Bound::unknown:
        break;
    }
    return "unknown";
}

std::vector<KernelTime> kernel_times(std::span<const FrameProfile> frames,
                                     std::span<const LaunchCounts> counts, const Roofs& roofs) {
    Counts of;
    for (const LaunchCounts& launch : counts) of[launch.kernel].push_back(launch);
    ByStageAndName all;
    for (const FrameProfile& frame : frames) add(frame, of, all);
    std::vector<KernelTime> result;
    for (const auto& [key, launches] : all) result.push_back(time_of(key, launches));
    if (result.empty()) return result;
    const double shortest = std::ranges::min_element(result, {}, &KernelTime::p10)->p10;
    for (KernelTime& kernel : result) kernel.bound = bound_of(kernel, roofs, shortest);
    std::ranges::stable_sort(result, std::greater{}, &KernelTime::sum);
    return result;
}

std::string kernel_table(std::span<const KernelTime> kernels, const Roofs& roofs) {
    std::string text =
        fmt::format("{:<14}{:<24}{:>9}{:>11}{:>9}{:>9}{:>9}{:>9}{:>9}{:>8}{:>9}{:>8}  {}\n",
                    "stage", "kernel", "launches", "median ms", "10 %", "90 %", "MB", "GB/s",
                    "% copy", "Mop", "Gop/s", "% roof", "bound by");
    for (const KernelTime& kernel : kernels) {
        text += fmt::format("{:<14}{:<24}{:>9}{:>11.4f}{:>9.4f}{:>9.4f}", kernel.stage, kernel.name,
                            kernel.launches, kernel.median * 1e-6, kernel.p10 * 1e-6,
                            kernel.p90 * 1e-6);
        text +=
            fmt::format("{:>9.3f}{:>9.2f}{:>9}{:>8.2f}{:>9.2f}{:>8}  {}\n", kernel.bytes * 1e-6,
                        kernel.gigabytes_per_second, share(kernel.gigabytes_per_second, roofs.copy),
                        kernel.operations * 1e-6, kernel.gigaops_per_second,
                        share(kernel.gigaops_per_second, roofs.arithmetic), name_of(kernel.bound));
    }
    return text + fmt::format("roofs: a copy {:.2f} GB/s; products and sums {:.1f} Gop/s\n",
                              roofs.copy, roofs.arithmetic);
}

std::string kernel_csv(std::span<const KernelTime> kernels, const Roofs& roofs) {
    std::string text = "stage,kernel,launches,median_us,p10_us,p90_us,bytes,operations,gb_per_s,"
                       "copy_gb_per_s,gop_per_s,roof_gop_per_s,bound\n";
    for (const KernelTime& kernel : kernels) {
        fmt::format_to(
            std::back_inserter(text),
            "{},{},{},{:.3f},{:.3f},{:.3f},{:.0f},{:.0f},{:.3f},{:.3f},{:.3f},{:.3f},{}\n",
            kernel.stage, kernel.name, kernel.launches, kernel.median * 1e-3, kernel.p10 * 1e-3,
            kernel.p90 * 1e-3, kernel.bytes, kernel.operations, kernel.gigabytes_per_second,
            roofs.copy, kernel.gigaops_per_second, roofs.arithmetic, name_of(kernel.bound));
    }
    return text;
}

std::string kernel_json(std::span<const KernelTime> kernels, const Roofs& roofs) {
    nlohmann::ordered_json json{
        {"roofs", {{"copy_gb_per_s", roofs.copy}, {"arithmetic_gop_per_s", roofs.arithmetic}}},
        {"kernels", nlohmann::ordered_json::array()}};
    for (const KernelTime& kernel : kernels) {
        json["kernels"].push_back({{"stage", kernel.stage},
                                   {"kernel", kernel.name},
                                   {"launches", kernel.launches},
                                   {"median_us", kernel.median * 1e-3},
                                   {"p10_us", kernel.p10 * 1e-3},
                                   {"p90_us", kernel.p90 * 1e-3},
                                   {"bytes", kernel.bytes},
                                   {"operations", kernel.operations},
                                   {"gb_per_s", kernel.gigabytes_per_second},
                                   {"gop_per_s", kernel.gigaops_per_second},
                                   {"bound", name_of(kernel.bound)}});
    }
    return json.dump(1) + "\n";
}

} // namespace lineatlas
