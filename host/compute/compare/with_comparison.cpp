#include "comparing_device.hpp"
#include "compute/choose_device.hpp"

namespace lineatlas::compute {

std::unique_ptr<Device> with_comparison(std::unique_ptr<Device> device, const std::string& other,
                                        const std::string& until) {
    if (other.empty()) return device;
    const std::string kind = other.substr(0, other.find(':'));
    return make_comparing_device(std::move(device), make_device(kind, other == kind ? "" : other),
                                 until);
}

} // namespace lineatlas::compute
