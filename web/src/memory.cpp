// Operators new that throw std::bad_alloc. Those of Debian's libc++abi for wasm32-wasi end the
// program instead, because it has no exceptions. malloc() returns nullptr if memory cannot grow.
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

void* checked(void* memory) {
    if (memory == nullptr) throw std::bad_alloc{};
    return memory;
}

void* allocate(std::size_t size) noexcept {
    return std::malloc(std::max<std::size_t>(size, 1));
}

void* allocate(std::size_t size, std::align_val_t alignment) noexcept {
    void* memory = nullptr;
    const auto bytes = std::max(static_cast<std::size_t>(alignment), sizeof(void*));
    return ::posix_memalign(&memory, bytes, std::max<std::size_t>(size, 1)) == 0 ? memory : nullptr;
}

} // namespace

void* operator new(std::size_t size) {
    return checked(allocate(size));
}
void* operator new[](std::size_t size) {
    return checked(allocate(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return checked(allocate(size, alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return checked(allocate(size, alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, const std::nothrow_t&) noexcept {
    std::free(memory);
}
