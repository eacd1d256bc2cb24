#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "lineatlas/compute_device.hpp"
#include "lineatlas/device_options.hpp"

namespace lineatlas::compute {

struct OpenClDevice;

/// The device that shall run the kernels, by options and the environment.
struct WantedDevice {
    std::string kind{};   ///< of device_kinds(); empty: OpenCL, else C++ where no driver works
    std::string device{}; ///< of that kind, as "opencl:<platform>[:<device>]"; empty: the best
    bool may_be_opencl() const { return kind.empty() || kind == "opencl"; }
};

/// Throws UsageError unless there is such a kind.
void check_device_kind(std::string_view name);
/// Where `device` is empty, the variable LINEATLAS_DEVICE counts.
WantedDevice wanted_device(const std::string& kind, const std::string& device);
/// The device, with another beside it to which it is compared (DeviceOptions::compare_with), if
/// that is wanted.
std::unique_ptr<Device> with_comparison(std::unique_ptr<Device> device, const std::string& other,
                                        const std::string& until);

/// A device that was found but is not made yet: that may take a while.
struct FoundDevice {
    WantedDevice wanted;
    std::shared_ptr<const OpenClDevice> opencl{}; ///< or one of another kind
};
/// The device to take that shares nothing with GL: C++ on all cores where none is named. Throws
/// UsageError and DeviceError as a LineVisibility.
FoundDevice find_device(const DeviceOptions& options);
std::unique_ptr<Device> make_device(const FoundDevice& found, const DeviceOptions& options);

} // namespace lineatlas::compute
