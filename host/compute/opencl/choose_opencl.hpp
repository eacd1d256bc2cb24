#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lineatlas/compute_device.hpp"

// Questions of the rest of the library about OpenCL. choose_opencl.cpp answers them, or
// without/opencl.cpp in a build without OpenCL.
namespace lineatlas::compute {

struct OpenClDevice;
struct WantedDevice;

/// The kind "opencl"; nothing in a build without it.
std::optional<DeviceKind> opencl_kind();

/// OpenCL devices that may be taken. Empty if no driver works and none was named. Throws as
/// find_opencl_devices() does.
std::vector<OpenClDevice> opencl_devices(const WantedDevice& wanted);

/// The first GPU of these devices, else the first CPU. Throws DeviceError if there is none.
std::shared_ptr<const OpenClDevice> best_opencl_device(const WantedDevice& wanted);

std::unique_ptr<Device> make_opencl_device(const OpenClDevice& device);

/// The note for users if kernels run as C++ for want of a driver.
std::string note_of_cpp();

} // namespace lineatlas::compute
