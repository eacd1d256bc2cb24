#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "lineatlas/compute_device.hpp"
#include "lineatlas/device_options.hpp"

namespace lineatlas::compute {

struct OpenClDevice;

/// The device that options and the environment choose for the kernels.
struct WantedDevice {
    std::string kind{};   ///< one of device_kinds(); empty: OpenCL, or C++ if no driver works
    std::string device{}; ///< a device of that kind, such as "opencl:<platform>[:<device>]"; empty:
                          ///< the best
    bool may_be_opencl() const { return kind.empty() || kind == "opencl"; }
};

/// Throws UsageError unless there is such a kind.
void check_device_kind(std::string_view name);
/// The wanted device. If `device` is empty, the variable LINEATLAS_DEVICE counts.
WantedDevice wanted_device(const std::string& kind, const std::string& device);
/// The device, compared with another one if that is wanted (DeviceOptions::compare_with).
std::unique_ptr<Device> with_comparison(std::unique_ptr<Device> device, const std::string& other,
                                        const std::string& until);

/// A device that was found but not made yet, because making it may take a while.
struct FoundDevice {
    WantedDevice wanted;
    std::shared_ptr<const OpenClDevice> opencl{}; ///< null for other kinds
};
/// Finds a device that shares nothing with GL: C++ on all cores if none is named. Throws UsageError
/// and DeviceError as LineVisibility does.
FoundDevice find_device(const DeviceOptions& options);
std::unique_ptr<Device> make_device(const FoundDevice& found, const DeviceOptions& options);

} // namespace lineatlas::compute
