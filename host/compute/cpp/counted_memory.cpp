#include "counted_memory.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>
#include <vector>

namespace lineatlas::compute {
namespace {

constexpr std::uintptr_t line = 64;

/// A table, and a bit for each of its lines.
struct Touched {
    std::uintptr_t first, last; ///< lines of memory; `last` is one of them
    std::vector<std::uint64_t> read{}, written{};

    explicit Touched(std::span<const std::byte> table)
        : first(reinterpret_cast<std::uintptr_t>(table.data()) / line),
          last((reinterpret_cast<std::uintptr_t>(table.data()) + table.size() - 1) / line),
          read((last - first) / 64 + 1), written(read.size()) {}
};

thread_local std::vector<Touched> tables;
thread_local Touched* recent = nullptr; ///< most often this table is touched again

/// The table that has this line; null if the line belongs to a variable of the kernel.
Touched* table_with(std::uintptr_t at) {
    const auto has = [&](const Touched& table) { return at >= table.first && at <= table.last; };
    if (recent != nullptr && has(*recent)) return recent;
    const auto found = std::ranges::find_if(tables, has);
    return found == tables.end() ? nullptr : recent = &*found;
}

void touch(const void* address, std::size_t size, std::vector<std::uint64_t> Touched::*kind) {
    const auto begin = reinterpret_cast<std::uintptr_t>(address);
    for (std::uintptr_t at = begin / line; at <= (begin + size - 1) / line; ++at) {
        Touched* table = table_with(at);
        if (table == nullptr) continue;
        const std::uintptr_t place = at - table->first;
        (table->*kind)[place / 64] |= std::uint64_t{1} << (place % 64);
    }
}

} // namespace

CountedMemory::CountedMemory(std::span<const std::span<const std::byte>> of) {
    for (const std::span<const std::byte> table : of)
        if (!table.empty()) tables.emplace_back(table);
}

CountedMemory::~CountedMemory() {
    tables.clear();
    recent = nullptr;
}

std::uint64_t CountedMemory::bytes() const {
    std::uint64_t lines = 0;
    for (const Touched& table : tables) {
        for (const std::uint64_t bits : table.read) lines += std::popcount(bits);
        for (const std::uint64_t bits : table.written) lines += std::popcount(bits);
    }
    return lines * line;
}

namespace {

void note_read(const void* address, std::size_t size) {
    touch(address, size, &Touched::read);
}
void note_written(const void* address, std::size_t size) {
    touch(address, size, &Touched::written);
}

// One thread runs the kernels: nothing needs to be atomic.
template <class T>
T counted_load(const volatile T* at) {
    note_read(const_cast<const T*>(at), sizeof *at);
    return *at;
}
/// Returns the number that was there. The number becomes `value` if it was `expected`.
template <class T>
T counted_exchange(volatile T* at, T expected, T value) {
    const T old = counted_load(at);
    if (old != expected) return old;
    note_written(const_cast<T*>(at), sizeof *at);
    *at = value;
    return old;
}
/// 1 if it was done, else 0 and `expected` is what was there.
template <class T>
int is_exchanged(volatile T* at, T* expected, T value) {
    const T old = counted_exchange(at, *expected, value);
    return std::exchange(*expected, old) == old ? 1 : 0;
}

} // namespace
} // namespace lineatlas::compute

// Functions that the compiler calls, with the names of the thread sanitizer's run-time library.
// That library is not linked.
// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {

#define COUNTED_ACCESS(size)                                                                       \
    void __tsan_read##size(void* address) {                                                        \
        lineatlas::compute::note_read(address, size);                                              \
    }                                                                                              \
    void __tsan_write##size(void* address) {                                                       \
        lineatlas::compute::note_written(address, size);                                           \
    }                                                                                              \
    void __tsan_unaligned_read##size(void* address) {                                              \
        lineatlas::compute::note_read(address, size);                                              \
    }                                                                                              \
    void __tsan_unaligned_write##size(void* address) {                                             \
        lineatlas::compute::note_written(address, size);                                           \
    }
COUNTED_ACCESS(1)
COUNTED_ACCESS(2)
COUNTED_ACCESS(4)
COUNTED_ACCESS(8)
COUNTED_ACCESS(16)
#undef COUNTED_ACCESS

void __tsan_read_range(void* address, std::size_t size) {
    if (size > 0) lineatlas::compute::note_read(address, size);
}
void __tsan_write_range(void* address, std::size_t size) {
    if (size > 0) lineatlas::compute::note_written(address, size);
}

// Newer versions of Clang call these in place of the functions without a prefix.
void* __tsan_memcpy(void* to, const void* from, std::size_t size) {
    __tsan_read_range(const_cast<void*>(from), size);
    __tsan_write_range(to, size);
    return std::memcpy(to, from, size);
}
void* __tsan_memmove(void* to, const void* from, std::size_t size) {
    __tsan_read_range(const_cast<void*>(from), size);
    __tsan_write_range(to, size);
    return std::memmove(to, from, size);
}
void* __tsan_memset(void* to, int value, std::size_t size) {
    __tsan_write_range(to, size);
    return std::memset(to, value, size);
}

void __tsan_init() {}
void __tsan_func_entry(void*) {}
void __tsan_func_exit() {}
std::uint32_t __tsan_atomic32_load(const volatile std::uint32_t* at, int) {
    return lineatlas::compute::counted_load(at);
}
std::uint32_t __tsan_atomic32_fetch_add(volatile std::uint32_t* at, std::uint32_t value, int) {
    const std::uint32_t old = lineatlas::compute::counted_load(at);
    lineatlas::compute::note_written(const_cast<std::uint32_t*>(at), sizeof *at);
    *at = old + value;
    return old;
}
// For each size clang calls the first of these three functions, g++ the others.
std::uint32_t __tsan_atomic32_compare_exchange_val(volatile std::uint32_t* at,
                                                   std::uint32_t expected, std::uint32_t value, int,
                                                   int) {
    return lineatlas::compute::counted_exchange(at, expected, value);
}
int __tsan_atomic32_compare_exchange_strong(volatile std::uint32_t* at, std::uint32_t* expected,
                                            std::uint32_t value, int, int) {
    return lineatlas::compute::is_exchanged(at, expected, value);
}
int __tsan_atomic32_compare_exchange_weak(volatile std::uint32_t* at, std::uint32_t* expected,
                                          std::uint32_t value, int, int) {
    return lineatlas::compute::is_exchanged(at, expected, value);
}
std::uint64_t __tsan_atomic64_load(const volatile std::uint64_t* at, int) {
    return lineatlas::compute::counted_load(at);
}
std::uint64_t __tsan_atomic64_compare_exchange_val(volatile std::uint64_t* at,
                                                   std::uint64_t expected, std::uint64_t value, int,
                                                   int) {
    return lineatlas::compute::counted_exchange(at, expected, value);
}
int __tsan_atomic64_compare_exchange_strong(volatile std::uint64_t* at, std::uint64_t* expected,
                                            std::uint64_t value, int, int) {
    return lineatlas::compute::is_exchanged(at, expected, value);
}
int __tsan_atomic64_compare_exchange_weak(volatile std::uint64_t* at, std::uint64_t* expected,
                                          std::uint64_t value, int, int) {
    return lineatlas::compute::is_exchanged(at, expected, value);
}

} // extern "C"
// NOLINTEND(bugprone-reserved-identifier)
