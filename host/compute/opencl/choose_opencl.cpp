#include "choose_opencl.hpp"

#include <algorithm>

#include "compute/choose_device.hpp"
#include "lineatlas/error.hpp"
#include "opencl_backend.hpp"

namespace lineatlas::compute {
namespace {

std::unique_ptr<Device> make_named(std::string_view device) {
    return make_opencl_backend(find_opencl_devices(device.empty() ? "opencl" : device).front());
}

} // namespace

std::optional<DeviceKind> opencl_kind() {
    return DeviceKind{"opencl", "kernels on an OpenCL device", make_named};
}

std::vector<OpenClDevice> opencl_devices(const WantedDevice& wanted) {
    return wanted.device.empty() ? list_opencl_devices() : find_opencl_devices(wanted.device);
}

std::shared_ptr<const OpenClDevice> best_opencl_device(const WantedDevice& wanted) {
    const std::vector<OpenClDevice> devices = opencl_devices(wanted);
    const auto rank = [](const OpenClDevice& device) {
        return device.is_gpu ? 0 : device.is_cpu ? 1 : 2;
    };
    const auto best = std::ranges::min_element(devices, {}, rank);
    if (best == devices.end()) throw DeviceError(no_device_message());
    return std::make_shared<const OpenClDevice>(*best);
}

std::unique_ptr<Device> make_opencl_device(const OpenClDevice& device) {
    return make_opencl_backend(device);
}

std::string note_of_cpp() {
    return why_no_device() + ", so kernels run as C++ on all cores";
}

} // namespace lineatlas::compute
