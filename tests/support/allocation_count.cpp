#include "allocation_count.hpp"

#include <cstdlib>
#include <new>

namespace {

thread_local bool counts = false;
thread_local std::size_t allocations = 0;

} // namespace

void* operator new(std::size_t bytes) {
    if (counts) ++allocations;
    if (void* memory = std::malloc(bytes == 0 ? 1 : bytes)) return memory;
    throw std::bad_alloc{};
}
// Replaced too, because a sanitizer's own one would not call the operator above.
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    if (counts) ++allocations;
    return std::malloc(bytes == 0 ? 1 : bytes);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace lineatlas::test {

AllocationCount::AllocationCount() {
    allocations = 0;
    counts = true;
}

std::size_t AllocationCount::stop() {
    counts = false;
    return allocations;
}

} // namespace lineatlas::test
