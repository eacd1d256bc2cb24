#pragma once

#include <cstddef>
#include <memory>

namespace lineatlas::test {

/// What lavapipe has exported, as host memory: what is a driver's own business is found by writing
/// to it through GL. Takes the descriptor; null where it is nothing of the kind. The content is
/// garbage.
std::shared_ptr<std::byte> import(int descriptor, std::size_t bytes);

} // namespace lineatlas::test
