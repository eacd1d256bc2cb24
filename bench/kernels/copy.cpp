// copy: n uint32 from one buffer to another. Its speed is the limit that other rows are compared
// with. Bytes: 4 read and 4 written per element.

#include <cmath>
#include <cstring>

#include "common.hpp"

namespace lineatlas::bench {
namespace {

constexpr const char* kernel_source = R"(
__kernel void copy_one(__global const uint* restrict from, __global uint* restrict to) {
    to[get_global_id(0)] = from[get_global_id(0)];
}
__kernel void copy_chunk(__global const uint16* restrict from, __global uint16* restrict to,
                         const uint chunk) {
    const uint begin = (uint)get_global_id(0) * chunk;
    for (uint i = begin; i < begin + chunk; ++i) to[i] = from[i];
}
)";

struct Pair {
    std::vector<std::uint32_t> values;
    SharedBuffer from, to;

    Pair(compute::Device& device, std::uint32_t n) : values(n) {
        Random random{1};
        for (std::uint32_t& value : values) value = random.below(700);
        from = to_device(device, values);
        to = device.allocate(n * sizeof(std::uint32_t));
    }
};

const cl::Buffer& memory_of(const SharedBuffer& buffer) {
    return static_cast<compute::OpenClBuffer&>(*buffer).memory;
}

/// Runs the job once and checks the copy.
Job checked(compute::Device& device, const Pair& pair, std::function<void()> run) {
    const std::size_t n = pair.values.size();
    run();
    require(read_back<std::uint32_t>(device, *pair.to, n) == pair.values, "copy");
    return {.run = std::move(run), .bytes = 8.0 * static_cast<double>(n)};
}

/// clEnqueueCopyBuffer. PoCL does it by memcpy in one thread.
Job prepare_enqueue(compute::OpenClBackend& device, std::uint32_t n) {
    const Pair pair{device, n};
    return checked(device, pair, [&device, from = pair.from, to = pair.to, n] {
        cl::CommandQueue queue = device.queue();
        queue.enqueueCopyBuffer(memory_of(from), memory_of(to), 0, 0, n * sizeof(cl_uint));
        device.finish();
    });
}

constexpr cl_uint pieces = 16, width = 16;

/// The plainest kernel that suits the device: on a CPU one work-item for each of `pieces` parts, as
/// `scan` has them; on a GPU one work-item per element. Sizes are multiples of pieces * width, so
/// no element is left over.
Job prepare_kernel(compute::OpenClBackend& device, std::uint32_t n) {
    const Pair pair{device, n};
    const bool chunks = device.device().is_cpu;
    cl::Program program{device.context(), kernel_source};
    program.build({device.device().device}, "-cl-std=CL1.2");
    cl::Kernel kernel{program, chunks ? "copy_chunk" : "copy_one"};
    kernel.setArg(0, memory_of(pair.from));
    kernel.setArg(1, memory_of(pair.to));
    if (chunks) kernel.setArg(2, n / (pieces * width));
    const cl::NDRange global{chunks ? pieces : n}, local{chunks ? 1U : 64U};
    return checked(device, pair, [&device, kernel, global, local, from = pair.from, to = pair.to] {
        cl::CommandQueue queue = device.queue();
        queue.enqueueNDRangeKernel(kernel, cl::NullRange, global, local);
        device.finish();
    });
}

Job prepare_memcpy(std::uint32_t n) {
    const auto from = std::make_shared<std::vector<std::uint32_t>>(n, 1);
    const auto to = std::make_shared<std::vector<std::uint32_t>>(n);
    return {.run = [from, to] { std::memcpy(to->data(), from->data(), from->size() * 4); },
            .bytes = 8.0 * n};
}

} // namespace

Rows copy_rows(const Devices& devices) {
    compute::OpenClBackend& device = *devices.opencl;
    return {{"copy/device_enqueue", [&](std::uint32_t n) { return prepare_enqueue(device, n); }},
            {"copy/device_kernel", [&](std::uint32_t n) { return prepare_kernel(device, n); }},
            {"copy/memcpy", prepare_memcpy}};
}

Row copy_row(const Devices& devices, const std::string& stage,
             std::function<double(std::uint32_t n)> bytes_of) {
    compute::OpenClBackend& device = *devices.opencl;
    return {stage + "/copy", [&device, bytes_of = std::move(bytes_of)](std::uint32_t n) {
                constexpr double bytes_each = 8.0 * pieces * width;
                const double units = std::ceil(bytes_of(n) / bytes_each);
                return prepare_kernel(device, static_cast<std::uint32_t>(units) * pieces * width);
            }};
}

} // namespace lineatlas::bench
