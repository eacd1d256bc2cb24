#pragma once

#include <span>

struct _cl_mem;

namespace lineatlas::interop {

/// Throws DeviceError, with the way out, unless `status` is CL_SUCCESS.
void check_handover(int status, const char* call);

/// Takes and gives back objects of another API that OpenCL has opened.
class OpenedObjects {
  public:
    OpenedObjects() = default;
    virtual ~OpenedObjects() = default;
    OpenedObjects(const OpenedObjects&) = delete;
    OpenedObjects& operator=(const OpenedObjects&) = delete;

    /// Whether the two APIs wait for each other by themselves. If not, the host has to wait: for GL
    /// before acquire() (glFinish), and for OpenCL before GL goes on (clFinish).
    virtual bool are_ordered() const { return false; }
    /// Throw DeviceError.
    virtual void acquire(_cl_mem* object) = 0;
    virtual void release(std::span<_cl_mem* const> objects) = 0;
};

} // namespace lineatlas::interop
