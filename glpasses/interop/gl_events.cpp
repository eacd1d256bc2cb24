#include "gl_events.hpp"

#include <string>

#include <epoxy/gl.h>

#include "lineatlas/error.hpp"

namespace lineatlas::interop {

GlEvents::GlEvents(const compute::OpenClBackend* backend) : backend_(backend) {
    if (backend == nullptr || !backend->device().has_extension("cl_khr_gl_event")) return;
    create_ = reinterpret_cast<CreateEvent>(clGetExtensionFunctionAddressForPlatform(
        backend->device().platform(), "clCreateEventFromGLsyncKHR"));
}

cl::Event GlEvents::gl_commands_so_far() const {
    const GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush(); // or the fence would never be reached
    cl_int status = CL_SUCCESS;
    const cl::Event event{create_(backend_->context()(), fence, &status)};
    glDeleteSync(fence); // the event holds it
    if (status != CL_SUCCESS) {
        throw DeviceError("clCreateEventFromGLsyncKHR returned " + std::to_string(status) +
                          "; use DeviceOptions::interop copy");
    }
    return event;
}

} // namespace lineatlas::interop
