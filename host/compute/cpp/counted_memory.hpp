#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace lineatlas::compute {

/// Records which parts of some tables counting kernels (LINEATLAS_COUNTED) touch on this thread
/// while the object lives. The compiler reports every access to memory as it would to the thread
/// sanitizer.
class CountedMemory {
  public:
    explicit CountedMemory(std::span<const std::span<const std::byte>> tables);
    ~CountedMemory();
    CountedMemory(const CountedMemory&) = delete;
    CountedMemory& operator=(const CountedMemory&) = delete;

    /// Bytes of the lines of 64 bytes that were read, plus bytes of those that were written. Each
    /// line counts once, however much of it was touched and how often.
    std::uint64_t bytes() const;
};

} // namespace lineatlas::compute
