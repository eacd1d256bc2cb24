#pragma once

#include "compute/opencl/opencl_backend.hpp"
#include "opened_objects.hpp"

namespace lineatlas::interop {

/// Objects of GL that OpenCL opens (cl_khr_gl_sharing). If the device lists cl_khr_gl_event, OpenCL
/// and GL wait for each other's commands without the host.
class GlObjects final : public OpenedObjects {
  public:
    /// `device` must outlive it.
    explicit GlObjects(const compute::OpenClBackend& device);

    bool are_ordered() const override { return create_event_ != nullptr; }
    void acquire(_cl_mem* object) override;
    void release(std::span<_cl_mem* const> objects) override;

  private:
    using CreateEvent = cl_event(CL_API_CALL*)(cl_context, void* gl_sync, cl_int*);

    /// An event that is complete when all GL commands of this thread's context so far are complete.
    cl::Event gl_commands_so_far() const;

    const compute::OpenClBackend& device_;
    CreateEvent create_event_ = nullptr; ///< null: the host waits
};

} // namespace lineatlas::interop
