#include "devices.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>

#include "core/memory_limit.hpp"
#include "driver_trial.hpp"
#include "lineatlas/error.hpp"
#include "loader.hpp"
#include "pocl_cache.hpp"

namespace lineatlas::compute {
namespace {

std::string lower(std::string_view text) {
    std::string result{text};
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// Some drivers pad their strings with blanks or zeros.
std::string trimmed(std::string text) {
    const auto is_padding = [](char c) { return c == '\0' || c == ' '; };
    while (!text.empty() && is_padding(text.back())) text.pop_back();
    text.erase(text.begin(), std::ranges::find_if_not(text, is_padding));
    return text;
}

OpenClDevice describe(const cl::Platform& platform, const cl::Device& device) {
    const cl_device_type type = device.getInfo<CL_DEVICE_TYPE>();
    return {.platform = platform,
            .device = device,
            .platform_name = trimmed(platform.getInfo<CL_PLATFORM_NAME>()),
            .device_name = trimmed(device.getInfo<CL_DEVICE_NAME>()),
            .driver_version = trimmed(device.getInfo<CL_DRIVER_VERSION>()),
            .extensions = device.getInfo<CL_DEVICE_EXTENSIONS>(),
            .is_cpu = (type & CL_DEVICE_TYPE_CPU) != 0,
            .is_gpu = (type & CL_DEVICE_TYPE_GPU) != 0};
}

/// Found once, before the drivers are loaded.
struct DriverState {
    std::string no_cache = give_pocl_a_cache();
    DriverTrial trial = try_drivers();
};

const DriverState& driver_state() {
    static const DriverState state;
    return state;
}

bool works(const cl::Platform& platform) {
    const std::optional<std::vector<std::string>>& working = driver_state().trial.working;
    if (!working) return true;
    const std::string name = platform.getInfo<CL_PLATFORM_NAME>();
    return std::ranges::find(*working, name) != working->end();
}

} // namespace

bool contains_ignoring_case(std::string_view text, std::string_view part) {
    return lower(text).find(lower(part)) != std::string::npos;
}

std::string OpenClDevice::name() const {
    return "opencl:" + platform_name + ":" + device_name;
}

std::string OpenClDevice::description() const {
    return "opencl: " + device_name + " (" + platform_name + ")";
}

bool OpenClDevice::has_extension(std::string_view extension) const {
    std::istringstream words{extensions};
    for (std::string word; words >> word;) {
        if (word == extension) return true;
    }
    return false;
}

std::vector<OpenClDevice> list_opencl_devices() {
    std::vector<OpenClDevice> result;
    // What does not even load in the copy is not loaded here.
    if (const DriverTrial& trial = driver_state().trial; trial.working && trial.working->empty())
        return result;
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error&) {
        return result; // the loader reports "no platform" as an error
    }
    for (const cl::Platform& platform : platforms) {
        try {
            if (!works(platform)) continue;
            std::vector<cl::Device> devices;
            platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
            for (const cl::Device& device : devices) result.push_back(describe(platform, device));
        } catch (const cl::Error&) {
            continue; // a platform without devices is an error too
        }
    }
    return result;
}

std::vector<OpenClDevice> find_opencl_devices(std::string_view name) {
    constexpr std::string_view prefix = "opencl";
    const std::string wanted{name};
    if (!name.starts_with(prefix) || (name.size() > prefix.size() && name[prefix.size()] != ':')) {
        throw UsageError("device \"" + wanted +
                         "\" is not of the form opencl:<platform>[:<device>]; `lineatlas devices` "
                         "lists the devices of this machine");
    }
    name.remove_prefix(std::min(name.size(), prefix.size() + 1));
    const std::size_t colon = name.find(':');
    const std::string_view platform = name.substr(0, colon);
    const std::string_view device = colon == std::string_view::npos ? "" : name.substr(colon + 1);

    const std::vector<OpenClDevice> all = list_opencl_devices();
    if (all.empty()) throw DeviceError(no_device_message());
    std::vector<OpenClDevice> found;
    for (const OpenClDevice& candidate : all) {
        if (contains_ignoring_case(candidate.platform_name, platform) &&
            contains_ignoring_case(candidate.device_name, device)) {
            found.push_back(candidate);
        }
    }
    if (found.empty()) {
        std::string known;
        for (const OpenClDevice& candidate : all) known += " \"" + candidate.name() + "\"";
        const bool disabled =
            contains_ignoring_case(platform, "rusticl") && std::getenv("RUSTICL_ENABLE") == nullptr;
        throw UsageError("no OpenCL device matches \"" + wanted + "\"; there is" + known +
                         (disabled ? "; rusticl has devices only where RUSTICL_ENABLE names their "
                                     "drivers, as in RUSTICL_ENABLE=llvmpipe"
                                   : ""));
    }
    return found;
}

std::string why_no_device() {
    const DriverState& state = driver_state();
    std::string cause = state.trial.cause;
    if (!state.no_cache.empty()) cause += (cause.empty() ? "" : "; ") + state.no_cache;
    if (!cause.empty()) return "no OpenCL device can be used (" + cause + ")";
    const OpenClLibrary& library = opencl_library();
    const std::string absent = library.works ? "" : library.cause + "; ";
    const std::optional<std::string> limit = memory_limit();
    return "no OpenCL device was found (" + absent +
           "on Debian and Ubuntu: apt install pocl-opencl-icd" +
           (limit ? "; this process may have only " + *limit + " of memory)" : ")");
}

bool drivers_lack_memory() {
    return !driver_state().trial.cause.empty() && memory_limit().has_value();
}

std::string no_device_message() {
    return why_no_device() + "; DeviceOptions::compute cpp does without";
}

} // namespace lineatlas::compute
