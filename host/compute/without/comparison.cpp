#include "compute/choose_device.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::compute {

std::unique_ptr<Device> with_comparison(std::unique_ptr<Device> device, const std::string& other,
                                        const std::string&) {
    if (other.empty()) return device;
    throw UsageError("this build of lineatlas compares no devices; leave out "
                     "DeviceOptions::compare_with");
}

} // namespace lineatlas::compute
