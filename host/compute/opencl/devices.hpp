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

    /// How the user names it: "opencl:<platform>:<device>".
    std::string name() const;
    /// How it is named to the user: "opencl: <device> (<platform>)".
    std::string description() const;
    bool has_extension(std::string_view extension) const;
};

/// Whether `part` stands in `text`, letters of either case.
bool contains_ignoring_case(std::string_view text, std::string_view part);

/// Every device of every platform, in the order the loader reports them. Empty without OpenCL.
std::vector<OpenClDevice> list_opencl_devices();

/// The devices that `name` selects: "opencl:<platform substring>[:<device substring>]", letters of
/// either case. Throws UsageError if the form is wrong, or DeviceError, listing the known devices,
/// if there is none.
std::vector<OpenClDevice> find_opencl_devices(std::string_view name);

/// Which package brings an OpenCL device, and what to do without one.
std::string opencl_advice();

} // namespace lineatlas::compute
