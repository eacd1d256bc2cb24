#include "host_kernels.hpp"

#include <algorithm>

namespace lineatlas::compute {

// kernels.cpp, compiled once for each instruction set.
namespace baseline {
extern const std::uint32_t depth_lanes;
std::span<const HostKernel> kernels();
std::uint64_t multiply_and_add(std::uint64_t rounds, float& result);
} // namespace baseline
#ifdef LINEATLAS_X86
namespace avx2 {
extern const std::uint32_t depth_lanes;
std::span<const HostKernel> kernels();
std::uint64_t multiply_and_add(std::uint64_t rounds, float& result);
} // namespace avx2
namespace avx512 {
extern const std::uint32_t depth_lanes;
std::span<const HostKernel> kernels();
std::uint64_t multiply_and_add(std::uint64_t rounds, float& result);
} // namespace avx512
#endif
#ifdef LINEATLAS_COUNTED
namespace counted {
extern const std::uint32_t depth_lanes;
std::span<const HostKernel> kernels();
} // namespace counted
#endif

namespace {

struct InstructionSet {
    std::string_view name;
    std::uint32_t depth_lanes;
    std::span<const HostKernel> (*kernels)();
    std::uint64_t (*multiply_and_add)(std::uint64_t rounds, float& result);
};

InstructionSet best_instruction_set() {
#ifdef LINEATLAS_X86
    __builtin_cpu_init();
    const bool has_avx512 = __builtin_cpu_supports("avx512f") != 0 &&
                            __builtin_cpu_supports("avx512vl") != 0 &&
                            __builtin_cpu_supports("avx512dq") != 0;
    if (has_avx512)
        return {"avx512", avx512::depth_lanes, avx512::kernels, avx512::multiply_and_add};
    if (__builtin_cpu_supports("avx2") != 0)
        return {"avx2", avx2::depth_lanes, avx2::kernels, avx2::multiply_and_add};
#endif
    return {"baseline", baseline::depth_lanes, baseline::kernels, baseline::multiply_and_add};
}

const InstructionSet& instruction_set() {
    static const InstructionSet best = best_instruction_set();
    return best;
}

} // namespace

const HostKernel* find_form(std::span<const HostKernel> all, std::string_view name,
                            std::string_view defines) {
    const auto found = std::ranges::find_if(
        all, [&](const HostKernel& form) { return form.name == name && form.defines == defines; });
    return found != all.end() ? &*found : nullptr;
}

std::span<const HostKernel> host_kernels() {
    return instruction_set().kernels();
}

std::span<const HostKernel> counted_kernels() {
#ifdef LINEATLAS_COUNTED
    return counted::kernels();
#else
    return {};
#endif
}

std::uint32_t counted_depth_lanes() {
#ifdef LINEATLAS_COUNTED
    return counted::depth_lanes;
#else
    return 0;
#endif
}

std::uint64_t multiply_and_add(std::uint64_t rounds, float& result) {
    return instruction_set().multiply_and_add(rounds, result);
}

std::uint32_t host_depth_lanes() {
    return instruction_set().depth_lanes;
}

std::string_view host_instruction_set() {
    return instruction_set().name;
}

} // namespace lineatlas::compute
