#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace lineatlas::compute {

/// Runs the work-items from `first` to below `last`, of `count` in all, of a kernel, one after the
/// other. `parameters`: its struct; `tables`: the memory of each of its tables, in the order of
/// kernels/kernels.h.
using HostFunction = void (*)(const void* parameters, void* const* tables, std::size_t first,
                              std::size_t last, std::size_t count);

/// A kernel as C++.
struct HostKernel {
    std::string_view name;
    std::string_view defines; ///< as Kernel::defines
    HostFunction run;
};

/// The kernel with this name and these defines among `all`; null if there is none.
const HostKernel* find_form(std::span<const HostKernel> all, std::string_view name,
                            std::string_view defines);

/// All kernels, compiled for the best instruction set that this processor has.
std::span<const HostKernel> host_kernels();

/// All counting kernels, for counting_device.cpp. None in a build with sanitizers.
std::span<const HostKernel> counted_kernels();
/// DEPTH_LANES of counting kernels; 0 if there are none.
std::uint32_t counted_depth_lanes();

/// Multiplies and adds floats in registers, `rounds` times, as kernels do, without contraction.
/// Returns the number of operations. Adds to `result`, so that the compiler cannot leave them out.
std::uint64_t multiply_and_add(std::uint64_t rounds, float& result);

/// DEPTH_LANES of these kernels.
std::uint32_t host_depth_lanes();

/// The name of that instruction set, such as "avx2".
std::string_view host_instruction_set();

} // namespace lineatlas::compute
