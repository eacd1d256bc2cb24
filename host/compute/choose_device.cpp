#include "choose_device.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "compare/comparing_device.hpp"
#include "lineatlas/error.hpp"
#include "opencl/opencl_backend.hpp"

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

std::vector<OpenClDevice> opencl_devices(const WantedDevice& wanted) {
    return wanted.device.empty() ? list_opencl_devices() : find_opencl_devices(wanted.device);
}

std::string note_of_cpp() {
    return why_no_device() + ", so kernels run as C++ on all cores";
}

std::unique_ptr<Device> with_comparison(std::unique_ptr<Device> device, const std::string& other,
                                        const std::string& until) {
    if (other.empty()) return device;
    const std::string kind = other.substr(0, other.find(':'));
    return make_comparing_device(std::move(device), make_device(kind, other == kind ? "" : other),
                                 until);
}

FoundDevice find_device(const DeviceOptions& options) {
    if (!options.interop.empty()) {
        throw UsageError("visibility: nothing is shared with GL; leave out DeviceOptions::interop");
    }
    FoundDevice found{.wanted = wanted_device(options.compute, options.device)};
    // A driver takes longer to start than most lines to find.
    if (found.wanted.kind.empty() && found.wanted.device.empty()) found.wanted.kind = "cpp";
    if (!found.wanted.may_be_opencl()) {
        check_device_kind(found.wanted.kind);
        return found;
    }
    const std::vector<OpenClDevice> devices = opencl_devices(found.wanted);
    const auto rank = [](const OpenClDevice& device) {
        return device.is_gpu ? 0 : device.is_cpu ? 1 : 2;
    };
    const auto best = std::ranges::min_element(devices, {}, rank);
    if (best == devices.end()) throw DeviceError(no_device_message());
    found.opencl = *best;
    return found;
}

std::unique_ptr<Device> make_device(const FoundDevice& found, const DeviceOptions& options) {
    std::unique_ptr<Device> device = found.opencl
                                         ? make_opencl_backend(*found.opencl)
                                         : make_device(found.wanted.kind, found.wanted.device);
    return with_comparison(std::move(device), options.compare_with, options.compare_until);
}

} // namespace lineatlas::compute
