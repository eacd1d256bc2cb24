#pragma once

#include <cstddef>

namespace lineatlas::test {

/// Counts the allocations of this thread by `new`, from the object's construction until stop().
/// Only this program and code compiled into it allocate so; drivers use other ways.
class AllocationCount {
  public:
    AllocationCount();
    ~AllocationCount() { stop(); }
    AllocationCount(const AllocationCount&) = delete;
    AllocationCount& operator=(const AllocationCount&) = delete;

    std::size_t stop();
};

} // namespace lineatlas::test
