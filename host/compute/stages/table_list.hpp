#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>

#include "lineatlas/compute_device.hpp"
#include "table_names.hpp"

namespace lineatlas::compute {

/// Counts the memory of a device's tables, by name.
class TableList {
  public:
    /// `buffer`, of `device`, is counted under this name as long as it lives.
    static void add(Device& device, Buffer& buffer, const TableName& name);
};

/// Device::allocate(), with the memory counted. The message of a Shortage says what the memory was
/// for.
std::unique_ptr<Buffer> allocate(Device& device, std::size_t bytes, const TableName& name);

/// A table with these values, which may be in any container.
template <class Values>
std::unique_ptr<Buffer> upload(Device& device, const Values& values, const TableName& name) {
    const auto bytes = std::as_bytes(std::span{values});
    std::unique_ptr<Buffer> buffer = allocate(device, bytes.size(), name);
    device.upload(*buffer, bytes);
    return buffer;
}

/// The bytes of all tables for any of these purposes.
std::uint64_t bytes_for(const Device& device, std::initializer_list<const Purpose*> purposes);

} // namespace lineatlas::compute
