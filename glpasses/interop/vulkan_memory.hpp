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
    /// Two descriptors of the same memory, one for each importer. The memory lives as long as
    /// anybody holds it.
    FileDescriptor for_gl, for_compute;
};

/// A Vulkan device, used for its memory alone. Making the first one loads Vulkan's library.
class VulkanMemory {
  public:
    virtual ~VulkanMemory() = default;
    /// Memory of at least `bytes` bytes. Throws DeviceError.
    virtual ExportedMemory allocate(std::size_t bytes) const = 0;
};

/// The memory of a device. All callers get the same object, until the process ends. Throws
/// DeviceError if Vulkan has no such device or the device does not export memory.
const VulkanMemory& vulkan_memory(const DeviceUuid& uuid);

} // namespace lineatlas::interop
