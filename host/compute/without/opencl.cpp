#include "compute/opencl/choose_opencl.hpp"
#include "compute/opencl/device_trial.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::compute {
namespace {

[[noreturn]] void refuse() {
    throw DeviceError("this build of lineatlas has no OpenCL; name cpp, or no device");
}

} // namespace

std::optional<DeviceKind> opencl_kind() {
    return std::nullopt;
}

std::shared_ptr<const OpenClDevice> best_opencl_device(const WantedDevice&) {
    refuse();
}

std::unique_ptr<Device> make_opencl_device(const OpenClDevice&) {
    refuse();
}

bool try_device(const Device&, std::string_view, const std::function<void(const DeviceOptions&)>&) {
    return false;
}

} // namespace lineatlas::compute
