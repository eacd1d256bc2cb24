#pragma once

#include "compute/opencl/opencl_backend.hpp"

namespace lineatlas::interop {

/// cl_khr_gl_event: OpenCL waits for GL commands, and GL for OpenCL's, without the host.
class GlEvents {
  public:
    /// `backend` may be null: not usable.
    explicit GlEvents(const compute::OpenClBackend* backend);

    /// Whether the device lists the extension and the driver has its function.
    bool usable() const { return create_ != nullptr; }
    /// Complete when all GL commands of this thread's context so far are.
    cl::Event gl_commands_so_far() const;

  private:
    using CreateEvent = cl_event(CL_API_CALL*)(cl_context, void* gl_sync, cl_int*);

    const compute::OpenClBackend* backend_;
    CreateEvent create_ = nullptr;
};

} // namespace lineatlas::interop
