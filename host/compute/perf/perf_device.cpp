#include "perf_device.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

#include "compute/forwarding_device.hpp"
#include "compute/opencl/opencl_backend.hpp"
#include "core/host_clock.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::compute {
namespace {

/// Nanoseconds that all threads of this process have run.
std::uint64_t cpu_nanoseconds() {
    constexpr std::uint64_t second = 1'000'000'000;
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<std::uint64_t>(time.tv_sec) * second +
           static_cast<std::uint64_t>(time.tv_nsec);
}

class PerfDevice final : public ForwardingDevice {
  public:
    PerfDevice(std::unique_ptr<Device> device, std::span<const PerfEvent> events,
               std::vector<PerfCounts>& counts)
        : ForwardingDevice(std::move(device)),
          opencl_(dynamic_cast<OpenClBackend*>(&this->device())), events_(events), counts_(counts) {
    }

    std::string description() const override { return device().description() + ", perf"; }

    void launch(const Launch& launch) override {
        device().finish(); // what was submitted before is not counted
        const std::vector<PerfReading> before = events_.read();
        const std::uint64_t cpu_time = cpu_nanoseconds();
        const std::int64_t start = host_nanoseconds();
        device().launch(launch);
        device().finish();
        PerfCounts own{.kernel = std::string{launch.kernel.name},
                       .time = static_cast<std::uint64_t>(host_nanoseconds() - start)};
        if (is_cpu()) set_events(own, before, cpu_time);
        if (opencl_ != nullptr) own.resources = opencl_->resources(launch.kernel);
        counts_.push_back(std::move(own));
    }

  private:
    bool is_cpu() const { return opencl_ == nullptr || opencl_->device().is_cpu; }

    /// Sets what was counted since `before` and `cpu_time` were read.
    void set_events(PerfCounts& own, std::span<const PerfReading> before,
                    std::uint64_t cpu_time) const {
        own.cpu_time = cpu_nanoseconds() - cpu_time;
        if (before.empty()) return;
        const std::vector<std::uint64_t> events = events_.since(before);
        own.cycles = events[0];
        own.instructions = events[1];
        own.cache_misses = events[2];
    }

    OpenClBackend* opencl_; ///< the same device; null if it is not OpenCL's
    PerfEvents events_;
    std::vector<PerfCounts>& counts_;
};

} // namespace

std::unique_ptr<Device> make_measured_device(std::string_view name) {
    const std::string_view kind = name.empty() ? "cpp" : name.substr(0, name.find(':'));
    if (kind == "cpp" || kind == "opencl") return make_device(kind, kind == name ? "" : name);
    throw UsageError("\"" + std::string{name} + "\" is not measured; cpp and OpenCL devices are");
}

std::unique_ptr<Device> make_perf_device(std::unique_ptr<Device> device,
                                         std::span<const PerfEvent> events,
                                         std::vector<PerfCounts>& counts) {
    return std::make_unique<PerfDevice>(std::move(device), events, counts);
}

} // namespace lineatlas::compute

namespace lineatlas {
namespace {

std::vector<PerfCounts>& all_counts() {
    static std::vector<PerfCounts> counts;
    return counts;
}

std::unique_ptr<compute::Device> make_perf(std::string_view device) {
    return compute::make_perf_device(compute::make_measured_device(device), compute::cpu_events(),
                                     all_counts());
}

} // namespace

void register_perf_device() {
    const auto& kinds = compute::device_kinds();
    if (std::ranges::find(kinds, "perf", &compute::DeviceKind::name) != kinds.end()) return;
    compute::register_device({"perf", "kernels of another device, one by one", make_perf});
}

std::vector<PerfCounts> take_perf_counts() {
    return std::exchange(all_counts(), {});
}

std::string why_no_perf_events() {
    return compute::PerfEvents{compute::cpu_events()}.refusal();
}

} // namespace lineatlas
