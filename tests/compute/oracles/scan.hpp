#pragma once

#include <cstdint>
#include <span>

#include "compute/stages/stages.hpp"

namespace lineatlas::test::oracles {

/// The exclusive sums of `scan`, one after the other in 64 bits. values: n inputs and one more
/// element for the total.
void scan(std::span<std::uint32_t> values, compute::ScanKind kind);

} // namespace lineatlas::test::oracles
