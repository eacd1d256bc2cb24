#pragma once

#include <memory>
#include <span>

#include "device_memory.hpp"
#include "devices.hpp"
#include "lineatlas/compute_device.hpp"
#include "lineatlas/kernel_profile.hpp"
#include "tuning.hpp"

namespace lineatlas::compute {

/// A buffer on an OpenCL device.
class OpenClBuffer final : public Buffer {
  public:
    OpenClBuffer(cl::Buffer buffer, std::size_t size, DeviceMemory::Share taken = {})
        : Buffer(size), share(std::move(taken)), memory(std::move(buffer)) {}

    DeviceMemory::Share share; ///< of the device's memory; none if GL has made the buffer
    cl::Buffer memory;
    void* mapped = nullptr; ///< while the host has access to a wrapped buffer
};

/// The interface for code that shares OpenCL objects with another API.
class OpenClBackend : public Device {
  public:
    virtual const OpenClDevice& device() const = 0;
    virtual const cl::Context& context() const = 0;
    virtual const cl::CommandQueue& queue() const = 0;
    /// What the driver tells of a kernel. Builds it if it was not built.
    virtual const KernelResources& resources(const Kernel& kernel) = 0;
};

/// Kernels on `device`. `context_properties`, if not empty, ties the context to a GL context: pairs
/// of name and value without the closing 0. Throws DeviceError if the driver refuses. A kernel is
/// built when it is first used, which may throw BuildError (build_error.hpp).
std::unique_ptr<OpenClBackend>
make_opencl_backend(const OpenClDevice& device,
                    std::span<const cl_context_properties> context_properties = {});

/// As above, with other launch parameters than those for the device.
std::unique_ptr<OpenClBackend>
make_opencl_backend(const OpenClDevice& device,
                    std::span<const cl_context_properties> context_properties,
                    const Tuning& tuning);

} // namespace lineatlas::compute
