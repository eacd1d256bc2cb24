#include "counting_device.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "compute/forwarding_device.hpp"
#include "compute/kernel_bytes.hpp"
#include "compute/perf/perf_device.hpp"
#include "counted_float.hpp"
#include "counted_memory.hpp"
#include "cpp_device.hpp"
#include "host_kernels.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::compute {
namespace {

/// The tuning with those values for which counting kernels are compiled.
Tuning as_compiled(Tuning tuning) {
    constexpr Tuning of_host{};
    tuning.scan_tiles = false; // they have barriers
    tuning.depth_lanes = counted_depth_lanes();
    tuning.depth_tile = of_host.depth_tile;
    tuning.halo_lanes = of_host.halo_lanes;
    return tuning;
}

class CountingDevice final : public ForwardingDevice {
  public:
    CountingDevice(std::vector<LaunchCounts>& counts, const Tuning& tuning)
        : ForwardingDevice(make_cpp_device()), tuning_(as_compiled(tuning)), counts_(counts) {}

    std::string description() const override { return "cpp, counting"; }
    const Tuning& tuning() const override { return tuning_; }

    void launch(const Launch& launch) override {
        std::array<void*, most_tables> tables{};
        std::vector<std::span<const std::byte>> memory;
        for (std::size_t i = 0; i < launch.tables.size(); ++i) {
            tables[i] = memory_of_cpp(*launch.tables[i]);
            memory.emplace_back(static_cast<const std::byte*>(tables[i]), launch.tables[i]->size());
        }
        const CountedMemory touched{memory};
        const std::uint64_t before = counted_operations;
        find_form(counted_kernels(), launch.kernel.name, launch.kernel.defines)
            ->run(launch.parameters.data(), tables.data(), 0, launch.items, launch.items);
        counts_.push_back(
            {std::string{launch.kernel.name}, touched.bytes(), counted_operations - before});
    }

  private:
    const Tuning tuning_;
    std::vector<LaunchCounts>& counts_;
};

} // namespace

std::unique_ptr<Device> make_counting_device(std::vector<LaunchCounts>& counts,
                                             const Tuning& tuning) {
    if (counted_kernels().empty())
        throw UsageError("kernels do not count in a build with sanitizers; use another build");
    return std::make_unique<CountingDevice>(counts, tuning);
}

} // namespace lineatlas::compute

namespace lineatlas {
namespace {

std::vector<LaunchCounts>& all_counts() {
    static std::vector<LaunchCounts> counts;
    return counts;
}

std::unique_ptr<compute::Device> make_counting(std::string_view device) {
    return compute::make_counting_device(all_counts(),
                                         compute::make_measured_device(device)->tuning());
}

} // namespace

void register_counting_device() {
    const auto& kinds = compute::device_kinds();
    if (std::ranges::find(kinds, "counting", &compute::DeviceKind::name) != kinds.end()) return;
    compute::register_device({"counting", "kernels as C++ that count", make_counting});
}

std::vector<LaunchCounts> take_launch_counts() {
    return std::exchange(all_counts(), {});
}

} // namespace lineatlas
