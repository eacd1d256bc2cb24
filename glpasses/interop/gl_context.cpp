#include "gl_context.hpp"

#include <algorithm>
#include <iterator>

#include <CL/cl_gl.h>

#include "glpasses/current_context.hpp"

namespace lineatlas::interop {
namespace {

/// The devices that the driver names for the context; the status of the last query that failed.
struct ContextDevices {
    std::vector<cl_device_id> devices;
    cl_int status = CL_SUCCESS;
};

/// Asks for the context's own device and for all devices that could be associated. Drivers answer
/// one of the two queries, or both.
ContextDevices devices_of(clGetGLContextInfoKHR_fn get_info,
                          const std::vector<cl_context_properties>& properties) {
    ContextDevices result;
    for (const cl_gl_context_info which :
         {CL_CURRENT_DEVICE_FOR_GL_CONTEXT_KHR, CL_DEVICES_FOR_GL_CONTEXT_KHR}) {
        std::vector<cl_device_id> devices(64, nullptr);
        std::size_t bytes = 0;
        const cl_int status =
            get_info(properties.data(), static_cast<cl_gl_context_info>(which),
                     devices.size() * sizeof(cl_device_id), devices.data(), &bytes);
        if (status != CL_SUCCESS) {
            result.status = status;
            continue;
        }
        devices.resize(std::min(devices.size(), bytes / sizeof(cl_device_id)));
        result.devices.insert(result.devices.end(), devices.begin(), devices.end());
    }
    return result;
}

} // namespace

std::vector<cl_context_properties> current_gl_properties() {
    const gl::CurrentContext current = gl::current_context();
    if (current.context == nullptr) return {};
    const bool egl = current.system == gl::CurrentContext::System::egl;
    return {CL_GL_CONTEXT_KHR, reinterpret_cast<cl_context_properties>(current.context),
            egl ? CL_EGL_DISPLAY_KHR : CL_GLX_DISPLAY_KHR,
            reinterpret_cast<cl_context_properties>(current.display)};
}

std::string gl_sharing_obstacle(const compute::OpenClDevice& device) {
    if (!device.has_extension("cl_khr_gl_sharing")) {
        return "the device does not list cl_khr_gl_sharing";
    }
    const std::vector<cl_context_properties> of_gl = current_gl_properties();
    if (of_gl.empty()) return "no GL context is current";
    const auto get_info = reinterpret_cast<clGetGLContextInfoKHR_fn>(
        clGetExtensionFunctionAddressForPlatform(device.platform(), "clGetGLContextInfoKHR"));
    if (get_info == nullptr) return "the driver lacks clGetGLContextInfoKHR";
    std::vector<cl_context_properties> properties{
        CL_CONTEXT_PLATFORM, reinterpret_cast<cl_context_properties>(device.platform())};
    std::ranges::copy(of_gl, std::back_inserter(properties));
    properties.push_back(0);
    const ContextDevices found = devices_of(get_info, properties);
    if (std::ranges::find(found.devices, device.device()) != found.devices.end()) return {};
    if (found.devices.empty() && found.status != CL_SUCCESS) {
        return "the driver does not know this GL context (clGetGLContextInfoKHR returned " +
               std::to_string(found.status) + ")";
    }
    return "GL does not run on this device";
}

} // namespace lineatlas::interop
