#include "host_kernels.hpp"

namespace lineatlas::compute {

// kernels.cpp, compiled once for each instruction set.
namespace baseline {
std::span<const HostKernel> kernels();
}
#ifdef LINEATLAS_X86
namespace avx2 {
std::span<const HostKernel> kernels();
}
namespace avx512 {
std::span<const HostKernel> kernels();
}
#endif

namespace {

struct InstructionSet {
    std::string_view name;
    std::span<const HostKernel> (*kernels)();
};

InstructionSet best_instruction_set() {
#ifdef LINEATLAS_X86
    __builtin_cpu_init();
    const bool has_avx512 = __builtin_cpu_supports("avx512f") != 0 &&
                            __builtin_cpu_supports("avx512vl") != 0 &&
                            __builtin_cpu_supports("avx512dq") != 0;
    if (has_avx512) return {"avx512", avx512::kernels};
    if (__builtin_cpu_supports("avx2") != 0) return {"avx2", avx2::kernels};
#endif
    return {"baseline", baseline::kernels};
}

const InstructionSet& instruction_set() {
    static const InstructionSet best = best_instruction_set();
    return best;
}

} // namespace

std::span<const HostKernel> host_kernels() {
    return instruction_set().kernels();
}

std::string_view host_instruction_set() {
    return instruction_set().name;
}

} // namespace lineatlas::compute
