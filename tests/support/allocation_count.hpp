#pragma once

#include <cstddef>

namespace lineatlas::test {

/// Counts what this thread allocates by `new`, from its making until stop(). That is this program's
/// own code and what it was compiled with; drivers allocate by other ways.
class AllocationCount {
  public:
    AllocationCount();
    ~AllocationCount() { stop(); }
    AllocationCount(const AllocationCount&) = delete;
    AllocationCount& operator=(const AllocationCount&) = delete;

    std::size_t stop();
};

} // namespace lineatlas::test
