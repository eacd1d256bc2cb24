#include "commands.hpp"

#include <string>

#include <fmt/core.h>

#include "glpasses/headless_context.hpp"
#include "glpasses/interop/connect.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::apps {
namespace {

void print_device(const compute::OpenClDevice& device, bool is_default) {
    fmt::print("{} {}\n", is_default ? "*" : " ", device.name());
    fmt::print("    driver {}, {}\n", device.driver_version,
               device.is_cpu   ? "CPU"
               : device.is_gpu ? "GPU"
                               : "accelerator");
    for (const interop::ModeReport& report : interop::probe_modes(device)) {
        fmt::print("    {:<13} {:<3}  {}\n", interop::name_of(report.mode),
                   report.works ? "yes" : "no", report.reason);
    }
}

void list_devices() {
    const gl::HeadlessContext context;
    fmt::print("GL: {} ({})\n\n", reinterpret_cast<const char*>(glGetString(GL_RENDERER)),
               reinterpret_cast<const char*>(glGetString(GL_VERSION)));
    const std::vector<compute::OpenClDevice> devices = compute::list_opencl_devices();
    if (devices.empty()) {
        fmt::print("No OpenCL device was found; {}.\n", compute::opencl_advice());
    } else {
        const std::size_t chosen = interop::default_device(devices);
        for (std::size_t i = 0; i < devices.size(); ++i) print_device(devices[i], i == chosen);
        fmt::print("\n* is used by default; choose another with --device or LINEATLAS_DEVICE, by "
                   "any part of its names:\n  opencl:<platform>[:<device>]\n");
    }
    fmt::print("\nreference: plain C++ on the CPU (--compute reference)\n");
}

} // namespace

Command setup_devices(CLI::App& app) {
    app.footer("For every OpenCL device: whether it can share buffers with OpenGL in each of the "
               "three modes,\nand why or why not. Each answer is tried, not guessed.");
    return list_devices;
}

} // namespace lineatlas::apps
