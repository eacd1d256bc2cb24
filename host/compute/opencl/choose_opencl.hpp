#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lineatlas/compute_device.hpp"

// What the rest of the library asks of OpenCL without knowing it: choose_opencl.cpp answers, or
// none.cpp in a build that has no OpenCL.
namespace lineatlas::compute {

struct OpenClDevice;
struct WantedDevice;

/// The kind "opencl"; nothing in a build without it.
std::optional<DeviceKind> opencl_kind();

/// OpenCL devices that may be taken. Empty if no driver works, and none was named; throws as
/// find_opencl_devices().
std::vector<OpenClDevice> opencl_devices(const WantedDevice& wanted);

/// Of these the first GPU, else the first CPU. Throws DeviceError if there is none.
std::shared_ptr<const OpenClDevice> best_opencl_device(const WantedDevice& wanted);

std::unique_ptr<Device> make_opencl_device(const OpenClDevice& device);

/// What the user is told where kernels run as C++ for want of a driver.
std::string note_of_cpp();

} // namespace lineatlas::compute
