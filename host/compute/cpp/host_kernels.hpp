#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace lineatlas::compute {

/// Runs work-items `first` up to, without, `last` of `count` of a kernel, one after the other.
/// `parameters`: its struct; `tables`: the memory of each of its tables, in the order of
/// kernels/kernels.h.
using HostFunction = void (*)(const void* parameters, void* const* tables, std::size_t first,
                              std::size_t last, std::size_t count);

/// A kernel as C++.
struct HostKernel {
    std::string_view name;
    std::string_view defines; ///< as Kernel::defines
    HostFunction run;
};

/// That of a name and defines among `all`; null if it is not there.
const HostKernel* find_form(std::span<const HostKernel> all, std::string_view name,
                            std::string_view defines);

/// All kernels, compiled for the best instruction set that this processor has.
std::span<const HostKernel> host_kernels();

/// All kernels that count: what launches them is counting_device.cpp. None in a build with
/// sanitizers.
std::span<const HostKernel> counted_kernels();

/// Multiplies and adds floats in registers, `rounds` times, as kernels do, without contraction.
/// Returns how many operations these were; adds to `result`, so that they must be done.
std::uint64_t multiply_and_add(std::uint64_t rounds, float& result);

/// That instruction set, such as "avx2".
std::string_view host_instruction_set();

} // namespace lineatlas::compute
