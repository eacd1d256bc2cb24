#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compute/stages/stages.hpp"

namespace lineatlas::test {

/// A device and the stages on it.
struct DeviceStages {
    explicit DeviceStages(std::unique_ptr<compute::Device> made)
        : device(std::move(made)), stages(*device) {}

    std::unique_ptr<compute::Device> device;
    compute::Stages stages;
};

/// One device to test, or a form of launching on it.
struct TestDevice {
    std::string name; ///< letters, digits and _ alone, as GoogleTest wants it
    std::unique_ptr<compute::Device> (*make_at)(std::size_t index);
    std::size_t index;
    bool slow = false; ///< rusticl: too slow for what is large

    std::unique_ptr<compute::Device> make() const { return make_at(index); }
};

/// `cpp`, and every OpenCL device of this machine, each in its own tuning and in the other one (CPU
/// form on GPU devices, GPU form on CPU devices; not on slow ones). Without OpenCL
/// `Devices.OpenClIsThere` fails, so that nobody takes `cpp` alone for all.
std::vector<TestDevice> test_devices();

/// Of these each OpenCL device once, in its own tuning; `index`: in list_opencl_devices().
std::vector<TestDevice> own_opencl_devices();

/// Content of a device buffer.
template <class T>
std::vector<T> read_back(compute::Device& device, compute::Buffer& buffer, std::size_t count) {
    std::vector<T> values(count);
    device.download(buffer, std::as_writable_bytes(std::span{values}));
    return values;
}

template <class T>
std::unique_ptr<compute::Buffer> to_device(compute::Device& device, const std::vector<T>& values) {
    auto buffer = device.allocate(values.size() * sizeof(T));
    device.upload(*buffer, std::as_bytes(std::span{values}));
    return buffer;
}

} // namespace lineatlas::test
