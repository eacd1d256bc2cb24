#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compute/stages/stages.hpp"
#include "compute/transfer.hpp"

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

/// `cpp` with the forms of a GPU that it has.
TestDevice cpp_as_gpu();

/// The device with triangles and strokes drawn in the other form: those of a GPU, or of a CPU.
std::unique_ptr<compute::Device> in_other_form(const TestDevice& device);

/// Of these each OpenCL device once, in its own tuning; `index`: in list_opencl_devices().
std::vector<TestDevice> own_opencl_devices();

using compute::read_back;
using compute::to_device;

} // namespace lineatlas::test
