#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "lineatlas/compute_device.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::compute {

/// A buffer of the device with these values. Without values it still has some size.
template <class T>
std::unique_ptr<Buffer> to_device(Device& device, const std::vector<T>& values) {
    auto buffer = device.allocate(std::max<std::size_t>(values.size(), 1) * sizeof(T));
    device.upload(*buffer, std::as_bytes(std::span{values}));
    return buffer;
}

/// Fills `values` with the first values of a buffer. Waits for the device.
template <class T>
void read_into(std::vector<T>& values, Device& device, Buffer& buffer, std::size_t count) {
    values.resize(count);
    device.download(buffer, std::as_writable_bytes(std::span{values}));
}

/// The first `count` values of a buffer. Waits for the device.
template <class T>
std::vector<T> read_back(Device& device, Buffer& buffer, std::size_t count) {
    std::vector<T> values;
    read_into(values, device, buffer, count);
    return values;
}

/// One value of a buffer. Waits for the device.
template <class T>
T read_one(Device& device, Buffer& buffer, std::size_t index = 0) {
    T value;
    device.download(buffer, std::as_writable_bytes(std::span{&value, 1}), index * sizeof(T));
    return value;
}

/// Waits for transfers that have begun, before the host's memory of them goes. An error may have
/// ended a frame before its finish().
inline void end_transfers(Device& device) {
    try {
        device.finish();
    } catch (const DeviceError&) {
        return; // a queue that failed runs nothing any more
    }
}

} // namespace lineatlas::compute
