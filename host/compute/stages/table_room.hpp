#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>

#include "table_list.hpp"

namespace lineatlas::compute {

/// The size of a table that must hold `needed` bytes, or elements of `size` bytes, and may soon
/// have to grow: with room for growth if there is memory for it.
inline std::uint64_t room_to_grow(const Device& device, std::uint64_t needed,
                                  std::size_t size = 1) {
    return with_room_to_grow(needed,
                             std::min(device.largest_buffer(), device.free_memory()) / size);
}

/// The first capacity of a table that can grow: the guess, or less if a buffer does not hold it.
template <class Element>
std::uint32_t first_capacity(const Device& device, std::uint32_t guess) {
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>(guess, device.largest_buffer() / sizeof(Element)));
}

/// Capacity for `needed` elements with room to grow.
template <class Element>
std::uint32_t capacity_for(const Device& device, std::uint32_t needed) {
    constexpr std::uint64_t most_counted = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(
        std::min(room_to_grow(device, needed, sizeof(Element)), most_counted));
}

/// A table on the device alone. It is made when it is needed, and made anew when it is too small.
class Table {
  public:
    /// Makes a table without room. `device` and `name` must outlive it.
    Table(Device& device, const TableName& name) : device_(&device), name_(&name) {}

    /// Makes room for `bytes` bytes. Returns true if the table is new and its content is gone.
    bool fit(std::uint64_t bytes) { return make(bytes, bytes); }
    /// As fit(), for a table that may have to grow again soon.
    bool make_room(std::uint64_t bytes) {
        return make(bytes, buffer_ ? room_to_grow(*device_, bytes) : bytes);
    }
    void release() { buffer_.reset(); }
    explicit operator bool() const { return buffer_ != nullptr; }
    Buffer& operator*() const { return *buffer_; }
    Buffer* get() const { return buffer_.get(); }
    std::uint64_t bytes() const { return buffer_ ? buffer_->size() : 0; }

    /// Makes room for `data` and writes it to the beginning.
    template <class T>
    void upload(std::span<const T> data) {
        fit(data.size_bytes());
        device_->upload(*buffer_, std::as_bytes(data));
    }

  private:
    bool make(std::uint64_t needed, std::uint64_t bytes) {
        if (buffer_ && buffer_->size() >= needed) return false;
        buffer_.reset(); // another may not fit beside it
        buffer_ = allocate(*device_, bytes, *name_);
        return true;
    }

    Device* device_;
    const TableName* name_;
    std::unique_ptr<Buffer> buffer_;
};

/// A table that stages keep from call to call only for its memory.
class ScratchTable : public Table {
  public:
    explicit ScratchTable(Device& device) : Table(device, table::work_space) {}

    /// The table, with room for at least `count` uint32.
    Buffer& with_room(std::size_t count) {
        make_room(count * sizeof(std::uint32_t));
        return **this;
    }
};

/// The table for a launch, see kernels.hpp. Throws std::logic_error for one without room.
inline Buffer* address_of(const Table& table) {
    if (!table) throw std::logic_error{"a launch takes a table that has no room"};
    return table.get();
}

} // namespace lineatlas::compute
