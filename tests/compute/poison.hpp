#pragma once

#include <cstdint>

// For programs that link poison.cpp.
namespace lineatlas::test {

/// From now on every byte of a new OpenCL buffer has this value; 0: the buffers keep the driver's
/// bytes. If a kernel's result depends on the value, the kernel has read memory that nobody had
/// written.
void poison_new_buffers(std::uint8_t value);

} // namespace lineatlas::test
