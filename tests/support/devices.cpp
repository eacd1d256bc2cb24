#include "devices.hpp"

#include <cctype>

#include <gtest/gtest.h>

#include "compute/cpp/cpp_device.hpp"
#include "compute/opencl/opencl_backend.hpp"

namespace lineatlas::test {
namespace {

/// The forms that are right for a CPU on a GPU and the other way round: slower, but equal in
/// result.
compute::Tuning other_tuning(const compute::OpenClDevice& device) {
    compute::OpenClDevice other = device;
    other.is_cpu = !device.is_cpu;
    return compute::tuning_for(other);
}

std::unique_ptr<compute::Device> make_own(std::size_t index) {
    return compute::make_opencl_backend(compute::list_opencl_devices()[index]);
}

std::unique_ptr<compute::Device> make_other(std::size_t index) {
    const compute::OpenClDevice device = compute::list_opencl_devices()[index];
    return compute::make_opencl_backend(device, {}, other_tuning(device));
}

std::unique_ptr<compute::Device> make_cpp(std::size_t) {
    return compute::make_cpp_device();
}

std::string identifier(const std::string& text) {
    std::string result;
    for (const char c : text) {
        result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    return result;
}

} // namespace

std::vector<TestDevice> test_devices() {
    std::vector<TestDevice> result{{"cpp", make_cpp, 0}};
    const std::vector<compute::OpenClDevice> devices = compute::list_opencl_devices();
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const std::string name = identifier(devices[i].platform_name) + "_" + std::to_string(i);
        const bool slow = devices[i].platform_name == "rusticl";
        result.push_back({name + (devices[i].is_cpu ? "_chunks" : "_tiles"), make_own, i, slow});
        // Compiling all kernels takes it a minute: only in the form in which they are used.
        if (slow) continue;
        result.push_back({name + (devices[i].is_cpu ? "_tiles" : "_chunks"), make_other, i});
    }
    return result;
}

TestDevice cpp_as_gpu() {
    return {"cpp_as_gpu",
            [](std::size_t) {
                return compute::make_cpp_device({.depth_each = true,
                                                 .long_atomics = true,
                                                 .stroke_pixels = true,
                                                 .face_lists = true});
            },
            0};
}

std::unique_ptr<compute::Device> in_other_form(const TestDevice& device) {
    compute::Tuning tuning = device.make()->tuning();
    tuning.depth_each = !tuning.depth_each;
    tuning.stroke_pixels = !tuning.stroke_pixels;
    if (device.name.starts_with("cpp")) return compute::make_cpp_device(tuning);
    return compute::make_opencl_backend(compute::list_opencl_devices()[device.index], {}, tuning);
}

std::vector<TestDevice> own_opencl_devices() {
    std::vector<TestDevice> result = test_devices();
    std::erase_if(result, [](const TestDevice& device) { return device.make_at != make_own; });
    return result;
}

TEST(Devices, OpenClIsThere) {
    EXPECT_FALSE(own_opencl_devices().empty())
        << "no OpenCL device: the kernel tests ran as C++ alone";
}

} // namespace lineatlas::test
