#pragma once

#include <cstdint>

// For programs that link poison.cpp.
namespace lineatlas::test {

/// From now on every byte of a new OpenCL buffer has this value; 0: whatever the driver leaves
/// there. A kernel whose result depends on the value has read what nobody had written.
void poison_new_buffers(std::uint8_t value);

} // namespace lineatlas::test
