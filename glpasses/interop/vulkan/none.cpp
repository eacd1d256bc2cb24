#include "glpasses/interop/vulkan_memory.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::interop {

const VulkanMemory& vulkan_memory(const DeviceUuid&) {
    throw DeviceError("this program was built without Vulkan's headers");
}

} // namespace lineatlas::interop
