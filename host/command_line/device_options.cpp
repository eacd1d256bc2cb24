#include "device_options.hpp"

#include <CLI/App.hpp>

#include "lineatlas/compute_device.hpp"

namespace lineatlas {

void declare_device(CLI::App& app, DeviceOptions& options, const std::string& group) {
    app.add_option("--compute", options.compute, "Backend: " + compute::device_kind_names())
        ->capture_default_str()
        ->group(group);
    app.add_option("--device", options.device,
                   "OpenCL device: opencl:<platform>[:<device>], any part of the names; see "
                   "`lineatlas devices`")
        ->group(group);
    app.add_option(
           "--interop", options.interop,
           "How buffers are shared with GL: gl-sharing, external-memory, host-pointer or copy")
        ->group(group);
}

} // namespace lineatlas
