#include "gl_objects.hpp"

#include <epoxy/gl.h>

namespace lineatlas::interop {

GlObjects::GlObjects(const compute::OpenClBackend& device) : device_(device) {
    if (!device.device().has_extension("cl_khr_gl_event")) return;
    create_event_ = reinterpret_cast<CreateEvent>(clGetExtensionFunctionAddressForPlatform(
        device.device().platform(), "clCreateEventFromGLsyncKHR"));
}

cl::Event GlObjects::gl_commands_so_far() const {
    const GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush(); // otherwise the fence might never be reached
    cl_int status = CL_SUCCESS;
    const cl::Event event{create_event_(device_.context()(), fence, &status)};
    glDeleteSync(fence); // the event holds it
    check_handover(status, "clCreateEventFromGLsyncKHR");
    return event;
}

void GlObjects::acquire(_cl_mem* object) {
    const cl::Event after = are_ordered() ? gl_commands_so_far() : cl::Event{};
    const cl_event handle = after();
    check_handover(clEnqueueAcquireGLObjects(device_.queue()(), 1, &object,
                                             handle != nullptr ? 1 : 0,
                                             handle != nullptr ? &handle : nullptr, nullptr),
                   "clEnqueueAcquireGLObjects");
}

void GlObjects::release(std::span<_cl_mem* const> objects) {
    check_handover(clEnqueueReleaseGLObjects(device_.queue()(),
                                             static_cast<cl_uint>(objects.size()), objects.data(),
                                             0, nullptr, nullptr),
                   "clEnqueueReleaseGLObjects");
    // With cl_khr_gl_event, GL commands from here on wait for what is submitted.
    if (are_ordered()) check_handover(clFlush(device_.queue()()), "clFlush");
}

} // namespace lineatlas::interop
