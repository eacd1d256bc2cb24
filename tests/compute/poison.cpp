#include "poison.hpp"

#include <cstdint>
#include <vector>

#include "compute/opencl/loader.hpp"
#include "compute/opencl/opencl.hpp"

namespace lineatlas::test {
namespace {

std::uint8_t poison = 0;

} // namespace

void poison_new_buffers(std::uint8_t value) {
    poison = value;
}

} // namespace lineatlas::test

/// Replaces the loader's function of this name in this program.
extern "C" CL_API_ENTRY cl_mem CL_API_CALL clCreateBuffer(cl_context context, cl_mem_flags flags,
                                                          std::size_t size, void* memory,
                                                          cl_int* status) {
    static auto* const real = reinterpret_cast<decltype(&clCreateBuffer)>(
        lineatlas::compute::opencl_library().function("clCreateBuffer"));
    if (memory != nullptr || lineatlas::test::poison == 0) {
        return real(context, flags, size, memory, status);
    }
    std::vector<std::uint8_t> content(size, lineatlas::test::poison);
    return real(context, flags | CL_MEM_COPY_HOST_PTR, size, content.data(), status);
}
