#include "devices.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <sstream>

#include "core/memory_limit.hpp"
#include "driver_trial.hpp"
#include "icd_files.hpp"
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

bool mistrusted = false;

/// State that is found once, before the drivers are loaded.
struct DriverState {
    std::string no_cache = give_pocl_a_cache();
    DriverTrial trial = try_drivers(mistrusted);
};

const DriverState& driver_state() {
    static const DriverState state;
    return state;
}

/// Whether a platform works. `platform`: its place among all.
bool works(std::size_t platform) {
    const std::optional<std::vector<std::size_t>>& working = driver_state().trial.working;
    return !working || std::ranges::find(*working, platform) != working->end();
}

/// Numbers devices that have the same name.
void tell_apart(std::vector<OpenClDevice>& devices) {
    std::map<std::string, int> counts;
    for (const OpenClDevice& device : devices) ++counts[device.name()];
    std::map<std::string, int> numbers;
    for (OpenClDevice& device : devices) {
        const std::string name = device.name();
        if (counts[name] > 1) device.number = ++numbers[name];
    }
}

std::string joined(const std::vector<std::string>& causes) {
    std::string text;
    for (const std::string& cause : causes) text += (text.empty() ? "" : "; ") + cause;
    return text;
}

} // namespace

bool contains_ignoring_case(std::string_view text, std::string_view part) {
    return lower(text).find(lower(part)) != std::string::npos;
}

std::string OpenClDevice::own_name() const {
    return number == 0 ? device_name : device_name + " #" + std::to_string(number);
}

std::string OpenClDevice::name() const {
    return "opencl:" + platform_name + ":" + own_name();
}

std::string OpenClDevice::description() const {
    return "opencl: " + own_name() + " (" + platform_name + ")";
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
    // Drivers that do not even load in the copy are not loaded here.
    if (const DriverTrial& trial = driver_state().trial; trial.working && trial.working->empty())
        return result;
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error&) {
        return result; // the loader reports "no platform" as an error
    }
    for (std::size_t i = 0; i < platforms.size(); ++i) {
        if (!works(i)) continue;
        try {
            std::vector<cl::Device> devices;
            platforms[i].getDevices(CL_DEVICE_TYPE_ALL, &devices);
            for (const cl::Device& device : devices)
                result.push_back(describe(platforms[i], device));
        } catch (const cl::Error&) {
            continue; // a platform without devices is an error too
        }
    }
    tell_apart(result);
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
    const auto named = std::ranges::find(all, wanted, &OpenClDevice::name);
    if (named != all.end()) return {*named}; // another name may begin with it
    std::vector<OpenClDevice> found;
    for (const OpenClDevice& candidate : all) {
        if (contains_ignoring_case(candidate.platform_name, platform) &&
            contains_ignoring_case(candidate.own_name(), device)) {
            found.push_back(candidate);
        }
    }
    if (found.empty()) {
        std::string known;
        for (const OpenClDevice& candidate : all) known += " \"" + candidate.name() + "\"";
        const bool disabled =
            contains_ignoring_case(platform, "rusticl") && std::getenv("RUSTICL_ENABLE") == nullptr;
        const std::string failed = joined(drivers_that_fail());
        throw UsageError("no OpenCL device matches \"" + wanted + "\"; there is" + known +
                         (failed.empty() ? "" : "; " + failed) +
                         (disabled ? "; rusticl has devices only where RUSTICL_ENABLE names their "
                                     "drivers, as in RUSTICL_ENABLE=llvmpipe"
                                   : ""));
    }
    return found;
}

void mistrust_drivers() {
    mistrusted = true;
}

std::vector<std::string> drivers_that_fail() {
    std::vector<std::string> causes;
    const DriverTrial& trial = driver_state().trial;
    if (!trial.cause.empty()) causes.push_back(trial.cause);
    if (trial.working && trial.working->empty()) return causes; // no driver is loaded here
    for (const IcdFile& icd : icd_files())
        if (!icd.cause.empty()) causes.push_back(icd.path + ": " + icd.cause);
    return causes;
}

std::string why_no_device() {
    const DriverState& state = driver_state();
    std::vector<std::string> causes;
    for (const std::string& cause : {state.trial.cause, state.no_cache})
        if (!cause.empty()) causes.push_back(cause);
    if (!causes.empty()) return "no OpenCL device can be used (" + joined(causes) + ")";
    if (const OpenClLibrary& library = opencl_library(); !library.works)
        causes.push_back(library.cause);
    bool has_pocl = false;
    for (const IcdFile& icd : icd_files()) {
        const bool loads = icd.cause.empty();
        causes.push_back(icd.path + ": " + (loads ? icd.library + " has no device" : icd.cause));
        has_pocl = has_pocl || contains_ignoring_case(icd.library, "pocl");
    }
    if (!has_pocl) causes.emplace_back("on Debian and Ubuntu: apt install pocl-opencl-icd");
    if (const std::optional<std::string> limit = memory_limit())
        causes.push_back("this process may have only " + *limit + " of memory");
    return "no OpenCL device was found (" + joined(causes) + ")";
}

bool drivers_lack_memory() {
    return !driver_state().trial.cause.empty() && memory_limit().has_value();
}

std::string no_device_message() {
    return why_no_device() + "; DeviceOptions::compute cpp does without";
}

} // namespace lineatlas::compute
