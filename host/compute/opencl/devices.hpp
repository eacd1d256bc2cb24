#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "opencl.hpp"

namespace lineatlas::compute {

/// One OpenCL device of this machine.
struct OpenClDevice {
    cl::Platform platform;
    cl::Device device;
    std::string platform_name;
    std::string device_name;
    std::string driver_version;
    std::string extensions;
    bool is_cpu = false;
    bool is_gpu = false;
    int number = 0; ///< from 1 among devices with this name; 0: no other has it

    /// The device's name with its number.
    std::string own_name() const;
    /// The name by which users choose it: "opencl:<platform>:<device>".
    std::string name() const;
    /// The name shown to users: "opencl: <device> (<platform>)".
    std::string description() const;
    bool has_extension(std::string_view extension) const;
};

/// Whether `part` stands in `text`, letters of either case.
bool contains_ignoring_case(std::string_view text, std::string_view part);

/// Every device of every platform that works (driver_trial.hpp), in the order the loader reports
/// them. Empty without OpenCL.
std::vector<OpenClDevice> list_opencl_devices();

/// The devices that `name` selects: "opencl:<platform substring>[:<device substring>]", letters of
/// either case. The whole name of a device selects it alone. Throws UsageError if the form is
/// wrong, or DeviceError, listing the known devices, if there is none.
std::vector<OpenClDevice> find_opencl_devices(std::string_view name);

/// From the call on, drivers list their devices in a copy of this process before they are loaded,
/// because some drivers end the process that asks. It is for programs that may fork when they first
/// ask for a device.
void mistrust_drivers();

/// The faults of installed drivers that do not work, one by one.
std::vector<std::string> drivers_that_fail();

/// Why list_opencl_devices() is empty: the beginning of a message.
std::string why_no_device();
/// The whole message, with the way out.
std::string no_device_message();
/// Whether drivers are installed but lack the memory that they need.
bool drivers_lack_memory();

} // namespace lineatlas::compute
