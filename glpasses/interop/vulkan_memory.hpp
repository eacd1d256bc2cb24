#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/file_descriptor.hpp"

namespace lineatlas::interop {

/// The identity of a device in GL, OpenCL and Vulkan.
using DeviceUuid = std::array<std::uint8_t, 16>;

/// Memory that a Vulkan device exports (VK_KHR_external_memory_fd), for others to import.
struct ExportedMemory {
    std::size_t bytes;
    /// The same memory. Each is an importer's own; the memory is there as long as anybody has it.
    FileDescriptor for_gl, for_compute;
};

/// A Vulkan device, for its memory alone. Vulkan's library is loaded when the first is made.
class VulkanMemory {
  public:
    virtual ~VulkanMemory() = default;
    /// At least so many bytes. Throws DeviceError.
    virtual ExportedMemory allocate(std::size_t bytes) const = 0;
};

/// Of the device of that name; the same for all that ask, until the process ends. Throws
/// DeviceError where Vulkan has no such device, or none that exports memory.
const VulkanMemory& vulkan_memory(const DeviceUuid& uuid);

} // namespace lineatlas::interop
