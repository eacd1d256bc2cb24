#pragma once

#include <string>
#include <vector>

#include "compute/opencl/devices.hpp"

namespace lineatlas::interop {

/// The GL context of this thread, made by EGL or GLX, as properties of an OpenCL context
/// (cl_khr_gl_sharing): pairs of name and value without the closing 0. Empty if none is current.
std::vector<cl_context_properties> current_gl_properties();

/// Why `device` cannot share with the GL context of this thread, or empty if nothing speaks against
/// trying. Only asks the driver (clGetGLContextInfoKHR) and creates nothing, because drivers are
/// known to fail in clCreateContext if the GL context belongs to another device or driver.
std::string gl_sharing_obstacle(const compute::OpenClDevice& device);

} // namespace lineatlas::interop
