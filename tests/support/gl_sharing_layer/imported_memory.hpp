#pragma once

#include <cstddef>
#include <memory>

namespace lineatlas::test {

/// Memory that lavapipe has exported, as host memory. Only the driver knows where that is, so it is
/// found by writing to it through GL. Takes the descriptor. Null if the descriptor is no such
/// memory. The content is garbage.
std::shared_ptr<std::byte> import(int descriptor, std::size_t bytes);

} // namespace lineatlas::test
