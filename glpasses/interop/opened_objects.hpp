#pragma once

#include <span>

struct _cl_mem;

namespace lineatlas::interop {

/// Throws DeviceError, with the way out, unless a call of OpenCL's returned CL_SUCCESS.
void check_handover(int status, const char* call);

/// How OpenCL takes and gives back what it has opened of another API's objects.
class OpenedObjects {
  public:
    OpenedObjects() = default;
    virtual ~OpenedObjects() = default;
    OpenedObjects(const OpenedObjects&) = delete;
    OpenedObjects& operator=(const OpenedObjects&) = delete;

    /// Whether the two APIs wait for each other by themselves. Else the host does: GL must be done
    /// before acquire() (glFinish), and OpenCL before GL goes on (clFinish).
    virtual bool are_ordered() const { return false; }
    /// Throw DeviceError.
    virtual void acquire(_cl_mem* object) = 0;
    virtual void release(std::span<_cl_mem* const> objects) = 0;
};

} // namespace lineatlas::interop
