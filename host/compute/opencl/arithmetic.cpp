#include "arithmetic.hpp"

#include <cstdint>
#include <string>

#include "compute/perf/best_rate.hpp"
#include "guarded.hpp"
#include "quirks.hpp"

namespace lineatlas::compute {
namespace {

/// A work-item multiplies and adds in enough chains to hide that each waits for its last sum.
constexpr const char* source = R"(
#pragma OPENCL FP_CONTRACT OFF
__kernel void multiply_and_add(__global float* out, const uint rounds, const float addend) {
    NUMBERS a = addend, b = a + 1.0f, c = a + 2.0f, d = a + 3.0f;
    NUMBERS e = a + 4.0f, f = a + 5.0f, g = a + 6.0f, h = a + 7.0f;
    for (uint i = 0; i < rounds; ++i) {
        a = a * 0.999f + addend; b = b * 0.999f + addend;
        c = c * 0.999f + addend; d = d * 0.999f + addend;
        e = e * 0.999f + addend; f = f * 0.999f + addend;
        g = g * 0.999f + addend; h = h * 0.999f + addend;
    }
    const NUMBERS sum = a + b + c + d + e + f + g + h;
    out[get_global_id(0)] = FIRST(sum);
}
)";

constexpr std::uint64_t chains = 8;

/// The form of the kernel for a kind of device, and how much of it fills the device.
struct Form {
    const char* defines;
    std::uint64_t lanes; ///< numbers in a vector of a work-item
    std::size_t group;   ///< work-items of a work-group
    std::size_t groups;  ///< work-groups for each processor
};

Form form_for(const OpenClDevice& device) {
    if (device.is_cpu) return {"#define NUMBERS float16\n#define FIRST(v) (v).s0\n", 16, 1, 4};
    return {"#define NUMBERS float\n#define FIRST(v) (v)\n", 1, 64, 32};
}

double rate_of(const OpenClBackend& backend) {
    const OpenClDevice& device = backend.device();
    const cl::CommandQueue& queue = backend.queue();
    const Form form = form_for(device);
    cl::Program program{backend.context(), std::string{form.defines} + source};
    try {
        program.build({device.device}, ("-cl-std=CL1.2 " + quirk_options(device)).c_str());
    } catch (const cl::BuildError&) {
        return 0;
    }
    cl::Kernel kernel{program, "multiply_and_add"};
    const std::size_t items =
        device.device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>() * form.groups * form.group;
    const cl::Buffer out{backend.context(), CL_MEM_WRITE_ONLY, items * sizeof(float)};
    kernel.setArg(0, out);
    kernel.setArg(2, 0.5F);
    const auto operations = [&](cl_uint rounds) {
        kernel.setArg(1, rounds);
        queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange{items},
                                   cl::NDRange{form.group});
        queue.finish();
        return 2 * chains * form.lanes * items * rounds;
    };
    constexpr cl_uint rounds = 1U << 14U; // rusticl on llvmpipe ends loops after 65,535
    operations(1);                        // PoCL builds at the first launch
    return best_rate([&] { return operations(rounds); });
}

} // namespace

double measure_arithmetic(const OpenClBackend& backend) {
    return guarded(backend.device(), "measuring arithmetic", [&] { return rate_of(backend); });
}

} // namespace lineatlas::compute
