#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>

#include "core/limits.hpp"
#include "lineatlas/compute_device.hpp"

namespace lineatlas::compute {

/// What a table gets that must hold `needed` bytes, or things of `size` bytes, and may have to grow
/// again soon: room for that where there is some.
inline std::uint64_t room_to_grow(const Device& device, std::uint64_t needed,
                                  std::size_t size = 1) {
    return with_room_to_grow(needed,
                             std::min(device.largest_buffer(), device.free_memory()) / size);
}

/// A first guess at how many elements a table must hold that can grow: no more than a buffer does.
template <class Element>
std::uint32_t first_capacity(const Device& device, std::uint32_t guess) {
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>(guess, device.largest_buffer() / sizeof(Element)));
}

/// How many elements a table gets that must hold `needed` of them and may have to grow again.
template <class Element>
std::uint32_t capacity_for(const Device& device, std::uint32_t needed) {
    constexpr std::uint64_t most_counted = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(
        std::min(room_to_grow(device, needed, sizeof(Element)), most_counted));
}

/// As Device::allocate; the message of a Shortage says what the memory was for.
inline std::unique_ptr<Buffer> allocate(Device& device, std::size_t bytes, const Purpose& purpose) {
    return for_purpose(purpose, [&] { return device.allocate(bytes); });
}

/// The tables of a stage, by the names of an enumeration that ends in `count`: made when a frame
/// needs them, and made anew when one needs more than they have.
template <class Name>
class GrowingTables {
  public:
    /// `device` and `purpose` must outlive it.
    GrowingTables(Device& device, const Purpose& purpose) : device_(device), purpose_(purpose) {}

    /// Makes room for so many bytes; true if the table is new, and nothing stands in it.
    bool fit(Name name, std::uint64_t bytes) { return make_room(name, bytes, bytes); }
    /// The same of a table that may have to grow again soon.
    bool make_room(Name name, std::uint64_t bytes) {
        return make_room(name, bytes, has(name) ? room_to_grow(device_, bytes) : bytes);
    }
    Buffer& operator[](Name name) const { return *tables_[index(name)]; }
    bool has(Name name) const { return tables_[index(name)] != nullptr; }
    void release() {
        for (std::unique_ptr<Buffer>& table : tables_) table.reset();
    }
    std::uint64_t bytes() const {
        std::uint64_t sum = 0;
        for (const std::unique_ptr<Buffer>& table : tables_) sum += table ? table->size() : 0;
        return sum;
    }

  private:
    static constexpr std::size_t index(Name name) { return static_cast<std::size_t>(name); }

    bool make_room(Name name, std::uint64_t needed, std::uint64_t bytes) {
        std::unique_ptr<Buffer>& table = tables_[index(name)];
        if (table && table->size() >= needed) return false;
        table.reset(); // it may not fit beside another
        table = allocate(device_, bytes, purpose_);
        return true;
    }

    Device& device_;
    const Purpose& purpose_;
    std::array<std::unique_ptr<Buffer>, index(Name::count)> tables_;
};

} // namespace lineatlas::compute
