#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compute/backend.hpp"

namespace lineatlas::test {

/// One backend to test: an OpenCL device, or a form of launching on it.
struct TestDevice {
    std::string name; ///< letters, digits and _ alone, as GoogleTest wants it
    std::unique_ptr<compute::Backend> (*make)(std::size_t index);
    std::size_t index;

    std::unique_ptr<compute::Backend> backend() const { return make(index); }
};

/// Every OpenCL device of this machine, each in its own tuning and in the other one (CPU form on
/// GPU devices, GPU form on CPU devices; not on rusticl, which is slow). Without OpenCL the list is
/// empty and the suites are skipped, which `Devices.AtLeastOne` reports as a failure.
std::vector<TestDevice> test_devices();

/// Of these each device once, in its own tuning.
std::vector<TestDevice> own_test_devices();

/// Content of a device buffer.
template <class T>
std::vector<T> read_back(compute::Backend& backend, compute::Buffer& buffer, std::size_t count) {
    std::vector<T> values(count);
    backend.download(buffer, std::as_writable_bytes(std::span{values}));
    return values;
}

template <class T>
std::unique_ptr<compute::Buffer> to_device(compute::Backend& backend,
                                           const std::vector<T>& values) {
    auto buffer = backend.allocate(values.size() * sizeof(T));
    backend.upload(*buffer, std::as_bytes(std::span{values}));
    return buffer;
}

} // namespace lineatlas::test
