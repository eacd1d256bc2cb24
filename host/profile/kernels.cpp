#include <algorithm>
#include <map>
#include <optional>

#include "core/median.hpp"
#include "lineatlas/kernel_profile.hpp"

namespace lineatlas {
namespace {

/// The launches of a kernel within a stage.
struct Launches {
    std::vector<double> each{};                          ///< nanoseconds
    double bytes = 0, operations = 0;                    ///< sums of all counted launches
    std::vector<double> byte_rates{}, operation_rates{}; ///< of each counted launch, per nanosecond
    std::vector<PerfCounts> perf{};
};

/// The launches of each kernel in a frame that was counted.
template <class OfLaunch>
using ByKernel = std::map<std::string, std::vector<OfLaunch>>;

struct Counts {
    ByKernel<LaunchCounts> work;
    ByKernel<PerfCounts> perf;
};

template <class OfLaunch>
ByKernel<OfLaunch> by_kernel(std::span<const OfLaunch> launches) {
    ByKernel<OfLaunch> result;
    for (const OfLaunch& launch : launches) result[launch.kernel].push_back(launch);
    return result;
}

/// An equal part of all launches for each of `all` launches.
LaunchCounts equal_part(const std::vector<LaunchCounts>& counted, std::size_t all) {
    LaunchCounts sum;
    for (const LaunchCounts& launch : counted) {
        sum.bytes += launch.bytes;
        sum.operations += launch.operations;
    }
    return {{}, sum.bytes / all, sum.operations / all};
}

PerfCounts equal_part(const std::vector<PerfCounts>& counted, std::size_t all) {
    PerfCounts sum;
    const auto add = [](std::optional<std::uint64_t>& to, const std::optional<std::uint64_t>& own) {
        if (own) to = to.value_or(0) + *own;
    };
    for (const PerfCounts& launch : counted) {
        sum.time += launch.time;
        sum.resources = launch.resources;
        add(sum.cpu_time, launch.cpu_time);
        add(sum.cycles, launch.cycles);
        add(sum.instructions, launch.instructions);
        add(sum.cache_misses, launch.cache_misses);
    }
    sum.time /= all;
    for (auto* count : {&sum.cpu_time, &sum.cycles, &sum.instructions, &sum.cache_misses})
        if (*count) **count /= all;
    return sum;
}

/// The counts of the k-th of a frame's `all` launches of a kernel: those of the k-th counted
/// launch, or an equal part if a device divides the work differently. Nothing if it was not
/// counted.
template <class OfLaunch>
std::optional<OfLaunch> counts_of(const ByKernel<OfLaunch>& counts, const std::string& kernel,
                                  std::size_t k, std::size_t all) {
    const auto counted = counts.find(kernel);
    if (counted == counts.end()) return std::nullopt;
    return counted->second.size() == all ? counted->second[k] : equal_part(counted->second, all);
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
        const std::size_t k = seen[event.name]++, of_frame = launches[event.name];
        if (const auto perf = counts_of(counts.perf, event.name, k, of_frame))
            own.perf.push_back(*perf);
        const auto launch = counts_of(counts.work, event.name, k, of_frame);
        if (!launch) continue;
        const double taken = std::max(own.each.back(), 1.0);
        const auto bytes = static_cast<double>(launch->bytes);
        const auto operations = static_cast<double>(launch->operations);
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

/// Sets what the CPU counted, as means over launches, and what the driver tells.
void set_perf(KernelTime& kernel, const std::vector<PerfCounts>& launches) {
    if (launches.empty()) return;
    const PerfCounts mean = equal_part(launches, launches.size());
    kernel.resources = mean.resources;
    if (mean.cpu_time)
        kernel.cores = static_cast<double>(*mean.cpu_time) /
                       static_cast<double>(std::max<std::uint64_t>(mean.time, 1));
    const auto number = [](const std::optional<std::uint64_t>& count) {
        return count ? std::optional{static_cast<double>(*count)} : std::nullopt;
    };
    kernel.cycles = number(mean.cycles);
    kernel.instructions = number(mean.instructions);
    kernel.cache_misses = number(mean.cache_misses);
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
    set_perf(kernel, launches.perf);
    return kernel;
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
                                     std::span<const LaunchCounts> counts, const Roofs& roofs,
                                     std::span<const PerfCounts> perf) {
    const Counts of{by_kernel(counts), by_kernel(perf)};
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

} // namespace lineatlas
