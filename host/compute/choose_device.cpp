#include "choose_device.hpp"

#include <cstdlib>
#include <utility>

#include "lineatlas/error.hpp"
#include "opencl/choose_opencl.hpp"

namespace lineatlas::compute {

WantedDevice wanted_device(const std::string& kind, const std::string& device) {
    std::string name = device;
    if (name.empty()) {
        if (const char* variable = std::getenv("LINEATLAS_DEVICE")) name = variable;
    }
    if (kind.empty() && name == "cpp") return {.kind = name};
    if (kind.empty() || kind == "opencl") return {.kind = kind, .device = name};
    return {.kind = kind, .device = device};
}

FoundDevice find_device(const DeviceOptions& options) {
    if (!options.interop.empty()) {
        throw UsageError("visibility: nothing is shared with GL; leave out DeviceOptions::interop");
    }
    FoundDevice found{.wanted = wanted_device(options.compute, options.device)};
    // Starting a driver takes longer than finding most lines.
    if (found.wanted.kind.empty() && found.wanted.device.empty()) found.wanted.kind = "cpp";
    if (!found.wanted.may_be_opencl()) {
        check_device_kind(found.wanted.kind);
        return found;
    }
    found.opencl = best_opencl_device(found.wanted);
    return found;
}

std::unique_ptr<Device> make_device(const FoundDevice& found, const DeviceOptions& options) {
    std::unique_ptr<Device> device = found.opencl
                                         ? make_opencl_device(*found.opencl)
                                         : make_device(found.wanted.kind, found.wanted.device);
    return with_comparison(std::move(device), options.compare_with, options.compare_until);
}

} // namespace lineatlas::compute
