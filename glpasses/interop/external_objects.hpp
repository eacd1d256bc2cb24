#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "compute/opencl/opencl_backend.hpp"
#include "opened_objects.hpp"
#include "vulkan_memory.hpp"

namespace lineatlas::interop {

/// Objects of memory that a Vulkan device exports and both GL and OpenCL import
/// (GL_EXT_memory_object_fd, cl_khr_external_memory_opaque_fd). The host waits for both. Semaphores
/// took longer (docs/interop.md).
class ExternalObjects final : public OpenedObjects {
  public:
    /// `device` must outlive it. Throws DeviceError if external_memory_obstacle() has a reason or
    /// Vulkan has no such memory.
    explicit ExternalObjects(const compute::OpenClBackend& device);

    /// Throws DeviceError when memory runs out.
    ExportedMemory allocate(std::size_t bytes) const { return vulkan_->allocate(bytes); }
    /// Takes the descriptor.
    std::unique_ptr<compute::OpenClBuffer> open(FileDescriptor& memory, std::size_t bytes) const;

    void acquire(_cl_mem* object) override;
    void release(std::span<_cl_mem* const> objects) override;

  private:
    using Handover = cl_int(CL_API_CALL*)(cl_command_queue, cl_uint, const cl_mem*, cl_uint,
                                          const cl_event*, cl_event*);
    using CreateBuffer = cl_mem(CL_API_CALL*)(cl_context, const cl_ulong* properties, cl_mem_flags,
                                              std::size_t, void*, cl_int*);

    template <class Function>
    Function function(const char* name) const;

    const compute::OpenClBackend& device_;
    const VulkanMemory* vulkan_;
    CreateBuffer create_;
    Handover acquire_, release_;
};

/// The reason against external memory, found without asking Vulkan; empty if there is none.
std::string external_memory_obstacle(const compute::OpenClDevice& device);

} // namespace lineatlas::interop
