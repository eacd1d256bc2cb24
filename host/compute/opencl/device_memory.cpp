#include "device_memory.hpp"

#include <string>

#include "core/limits.hpp"
#include "status.hpp"

namespace lineatlas::compute {

DeviceMemory::DeviceMemory(const cl::Device& device)
    : largest_buffer_(device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>()),
      total_(device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>()) {}

DeviceMemory::Share DeviceMemory::take(std::uint64_t bytes) {
    if (bytes > largest_buffer_) {
        throw Shortage(written_bytes(bytes), "a buffer of this OpenCL device holds " +
                                                 written_bytes(largest_buffer_) +
                                                 " (CL_DEVICE_MAX_MEM_ALLOC_SIZE)");
    }
    if (bytes > free()) {
        throw Shortage(written_bytes(bytes), "of the " + written_bytes(total_) +
                                                 " of this OpenCL device " + written_bytes(taken_) +
                                                 " are in use (CL_DEVICE_GLOBAL_MEM_SIZE)");
    }
    return Share{*this, bytes};
}

void DeviceMemory::check(cl_int status, std::uint64_t bytes) const {
    if (!is_shortage(status)) return;
    throw Shortage(written_bytes(bytes), "the OpenCL driver has no more (" + name_of(status) +
                                             " with " + written_bytes(taken_) + " of " +
                                             written_bytes(total_) + " in use)");
}

} // namespace lineatlas::compute
