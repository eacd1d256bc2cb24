#include "compute/opencl/arithmetic.hpp"

#include <atomic>
#include <thread>

#include "base/parallel.hpp"
#include "best_rate.hpp"
#include "compute/cpp/host_kernels.hpp"
#include "lineatlas/kernel_profile.hpp"
#include "perf_device.hpp"

namespace lineatlas {
namespace {

/// Of kernels as C++, by their instruction set.
double arithmetic_of_cpp() {
    constexpr std::uint64_t rounds = 1U << 18U;
    const std::size_t pieces = std::size_t{4} * std::thread::hardware_concurrency();
    return compute::best_rate([&] {
        std::atomic<std::uint64_t> operations = 0;
        const auto compute_piece = [&](std::size_t piece) {
            float result = static_cast<float>(piece);
            operations += compute::multiply_and_add(rounds, result);
            volatile float seen = result; // so that the result must be computed
            static_cast<void>(seen);
        };
        for_each_index(pieces, compute_piece, 1);
        return operations.load();
    });
}

} // namespace

double measure_arithmetic(const std::string& device) {
    const auto made = compute::make_measured_device(device);
    const auto* opencl = dynamic_cast<const compute::OpenClBackend*>(made.get());
    return opencl != nullptr ? compute::measure_arithmetic(*opencl) : arithmetic_of_cpp();
}

} // namespace lineatlas
