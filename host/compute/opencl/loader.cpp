// The functions of OpenCL that the library calls. Each calls that of libOpenCL.so.1, which nothing
// links.
#include "loader.hpp"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <tuple>

#include <dlfcn.h>

#include "opencl.hpp"

#include <CL/cl_gl.h>

/// All functions, with their numbers of arguments.
// clang-format off
#define LA_OPENCL_FUNCTIONS(F) \
    F(1, clFinish) F(1, clFlush) F(1, clReleaseCommandQueue) F(1, clReleaseContext) \
    F(1, clReleaseDevice) F(1, clReleaseEvent) F(1, clReleaseKernel) F(1, clReleaseMemObject) \
    F(1, clReleaseProgram) F(1, clRetainCommandQueue) F(1, clRetainContext) F(1, clRetainDevice) \
    F(1, clRetainEvent) F(1, clRetainKernel) F(1, clRetainMemObject) F(1, clRetainProgram) \
    F(2, clGetExtensionFunctionAddressForPlatform) F(2, clWaitForEvents) F(3, clCreateKernel) \
    F(4, clCreateCommandQueue) F(4, clCreateFromGLBuffer) \
    F(4, clSetKernelArg) F(5, clCreateBuffer) F(5, clCreateProgramWithSource) \
    F(5, clGetCommandQueueInfo) F(5, clGetContextInfo) F(5, clGetDeviceIDs) F(5, clGetDeviceInfo) \
    F(5, clGetEventInfo) F(5, clGetEventProfilingInfo) F(5, clGetKernelInfo) \
    F(5, clGetPlatformInfo) F(5, clGetProgramInfo) F(6, clBuildProgram) F(6, clCreateContext) \
    F(6, clCreateFromGLTexture) F(6, clEnqueueAcquireGLObjects) F(6, clEnqueueReleaseGLObjects) \
    F(6, clEnqueueUnmapMemObject) F(6, clGetKernelWorkGroupInfo) F(6, clGetProgramBuildInfo) \
    F(7, clCreateProgramWithBinary) F(9, clCompileProgram) F(9, clEnqueueCopyBuffer) F(9, clEnqueueFillBuffer) \
    F(9, clEnqueueNDRangeKernel) F(9, clEnqueueReadBuffer) F(9, clEnqueueWriteBuffer) \
    F(10, clEnqueueMapBuffer) F(11, clEnqueueReadImage) F(11, clEnqueueWriteImage)
// clang-format on

namespace lineatlas::compute {
namespace {

constexpr const char* file = "libOpenCL.so.1";

#define LA_NAME(arity, name) #name,
constexpr std::array names{LA_OPENCL_FUNCTIONS(LA_NAME) "clGetPlatformIDs"};
#undef LA_NAME

/// The address at which the file was loaded that holds an address.
void* base_of(const void* address) {
    Dl_info info{};
    return ::dladdr(address, &info) != 0 ? info.dli_fbase : nullptr;
}

/// Whether the process has functions of OpenCL other than those below. The latter are visible too
/// if the library comes in shared parts (./run bundle).
bool has_others() {
    const void* const found = ::dlsym(RTLD_DEFAULT, "clGetPlatformIDs");
    return found != nullptr && base_of(found) != base_of(file);
}

OpenClLibrary open_library() {
    OpenClLibrary library;
    // Functions that the process already has take precedence over the library's.
    library.in_front = has_others();
    library.handle = library.in_front ? RTLD_DEFAULT : ::dlopen(file, RTLD_NOW | RTLD_LOCAL);
    if (!library.in_front && library.handle == nullptr) {
        const char* const error = ::dlerror();
        library.cause = error != nullptr ? error : std::string{file} + " cannot be opened";
        return library;
    }
    for (const char* name : names) {
        if (::dlsym(library.handle, name) != nullptr) continue;
        library.cause = std::string{file} + " is older than OpenCL 1.2: it has no " + name;
        return library;
    }
    library.works = true;
    return library;
}

template <class Function>
struct Signature;
template <class Result_, class... Arguments_>
struct Signature<Result_(Arguments_...)> {
    using Result = Result_;
    using Arguments = std::tuple<Arguments_...>;
};
template <class Function>
using ResultOf = typename Signature<Function>::Result;
template <class Function, std::size_t i>
using ArgumentOf = std::tuple_element_t<i, typename Signature<Function>::Arguments>;

} // namespace

void* OpenClLibrary::function(const char* name) const {
    return ::dlsym(handle, name);
}

const OpenClLibrary& opencl_library() {
    static const OpenClLibrary library = open_library();
    return library;
}

} // namespace lineatlas::compute

using lineatlas::compute::ArgumentOf;
using lineatlas::compute::opencl_library;
using lineatlas::compute::ResultOf;

// Without the library there is no platform, and all other functions need one. They are weak, so
// that a test may have its own.
#define LA_PARAMETERS_1(of) ArgumentOf<decltype(of), 0> a
#define LA_PARAMETERS_2(of) LA_PARAMETERS_1(of), ArgumentOf<decltype(of), 1> b
#define LA_PARAMETERS_3(of) LA_PARAMETERS_2(of), ArgumentOf<decltype(of), 2> c
#define LA_PARAMETERS_4(of) LA_PARAMETERS_3(of), ArgumentOf<decltype(of), 3> d
#define LA_PARAMETERS_5(of) LA_PARAMETERS_4(of), ArgumentOf<decltype(of), 4> e
#define LA_PARAMETERS_6(of) LA_PARAMETERS_5(of), ArgumentOf<decltype(of), 5> f
#define LA_PARAMETERS_7(of) LA_PARAMETERS_6(of), ArgumentOf<decltype(of), 6> g
#define LA_PARAMETERS_8(of) LA_PARAMETERS_7(of), ArgumentOf<decltype(of), 7> h
#define LA_PARAMETERS_9(of) LA_PARAMETERS_8(of), ArgumentOf<decltype(of), 8> i
#define LA_PARAMETERS_10(of) LA_PARAMETERS_9(of), ArgumentOf<decltype(of), 9> j
#define LA_PARAMETERS_11(of) LA_PARAMETERS_10(of), ArgumentOf<decltype(of), 10> k
#define LA_ARGUMENTS_1 a
#define LA_ARGUMENTS_2 LA_ARGUMENTS_1, b
#define LA_ARGUMENTS_3 LA_ARGUMENTS_2, c
#define LA_ARGUMENTS_4 LA_ARGUMENTS_3, d
#define LA_ARGUMENTS_5 LA_ARGUMENTS_4, e
#define LA_ARGUMENTS_6 LA_ARGUMENTS_5, f
#define LA_ARGUMENTS_7 LA_ARGUMENTS_6, g
#define LA_ARGUMENTS_8 LA_ARGUMENTS_7, h
#define LA_ARGUMENTS_9 LA_ARGUMENTS_8, i
#define LA_ARGUMENTS_10 LA_ARGUMENTS_9, j
#define LA_ARGUMENTS_11 LA_ARGUMENTS_10, k
#define LA_FUNCTION(arity, name)                                                                   \
    extern "C" [[gnu::weak]] ResultOf<decltype(name)> name(LA_PARAMETERS_##arity(name)) {          \
        static auto* const real =                                                                  \
            reinterpret_cast<decltype(&name)>(opencl_library().function(#name));                   \
        return real(LA_ARGUMENTS_##arity);                                                         \
    }
LA_OPENCL_FUNCTIONS(LA_FUNCTION)

extern "C" [[gnu::weak]] cl_int clGetPlatformIDs(cl_uint entries, cl_platform_id* platforms,
                                                 cl_uint* count) {
    if (!opencl_library().works) return CL_PLATFORM_NOT_FOUND_KHR;
    static auto* const real = reinterpret_cast<decltype(&clGetPlatformIDs)>(
        opencl_library().function("clGetPlatformIDs"));
    return real(entries, platforms, count);
}
