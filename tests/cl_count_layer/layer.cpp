#include "layer.hpp"

#include <atomic>
#include <cstring>
#include <type_traits>

#include <CL/cl_icd.h>
#include <CL/cl_layer.h>

// Function pointers as template arguments lose attributes that say nothing on this platform.
#pragma GCC diagnostic ignored "-Wignored-attributes"

namespace lineatlas::test {
namespace {

const cl_icd_dispatch* driver = nullptr;
std::array<std::atomic<long>, cl_kinds> references{};

/// An enqueued command that was asked for its event made one.
template <class Argument>
void count_event(Argument argument) {
    if constexpr (std::is_same_v<Argument, cl_event*>) {
        if (argument != nullptr) ++references[cl_events];
    }
}

template <auto member, ClKind kind, class Function>
struct Watch;

template <auto member, ClKind kind, class Result, class... Arguments>
struct Watch<member, kind, Result(CL_API_CALL*)(Arguments...)> {
    static Result CL_API_CALL create(Arguments... arguments) {
        Result made = (driver->*member)(arguments...);
        if (made != nullptr) ++references[kind];
        return made;
    }
    static Result CL_API_CALL retain(Arguments... arguments) {
        ++references[kind];
        return (driver->*member)(arguments...);
    }
    static Result CL_API_CALL release(Arguments... arguments) {
        --references[kind];
        return (driver->*member)(arguments...);
    }
    static Result CL_API_CALL enqueue(Arguments... arguments) {
        Result result = (driver->*member)(arguments...);
        (count_event(arguments), ...);
        return result;
    }
};

#define WATCH(kind, what, function)                                                                \
    table.function =                                                                               \
        Watch<&cl_icd_dispatch::function, kind, decltype(cl_icd_dispatch::function)>::what

void watch(cl_icd_dispatch& table) {
    WATCH(cl_contexts, create, clCreateContext);
    WATCH(cl_contexts, create, clCreateContextFromType);
    WATCH(cl_contexts, retain, clRetainContext);
    WATCH(cl_contexts, release, clReleaseContext);
    WATCH(cl_queues, create, clCreateCommandQueue);
    WATCH(cl_queues, create, clCreateCommandQueueWithProperties);
    WATCH(cl_queues, retain, clRetainCommandQueue);
    WATCH(cl_queues, release, clReleaseCommandQueue);
    WATCH(cl_memory, create, clCreateBuffer);
    WATCH(cl_memory, create, clCreateSubBuffer);
    WATCH(cl_memory, create, clCreateImage);
    WATCH(cl_memory, retain, clRetainMemObject);
    WATCH(cl_memory, release, clReleaseMemObject);
    WATCH(cl_programs, create, clCreateProgramWithSource);
    WATCH(cl_programs, create, clCreateProgramWithBinary);
    WATCH(cl_programs, retain, clRetainProgram);
    WATCH(cl_programs, release, clReleaseProgram);
    WATCH(cl_kernels, create, clCreateKernel);
    WATCH(cl_kernels, retain, clRetainKernel);
    WATCH(cl_kernels, release, clReleaseKernel);
    WATCH(cl_events, retain, clRetainEvent);
    WATCH(cl_events, release, clReleaseEvent);
    WATCH(cl_events, create, clCreateUserEvent);
    WATCH(cl_events, enqueue, clEnqueueNDRangeKernel);
    WATCH(cl_events, enqueue, clEnqueueReadBuffer);
    WATCH(cl_events, enqueue, clEnqueueWriteBuffer);
    WATCH(cl_events, enqueue, clEnqueueCopyBuffer);
    WATCH(cl_events, enqueue, clEnqueueFillBuffer);
    WATCH(cl_events, enqueue, clEnqueueMapBuffer);
    WATCH(cl_events, enqueue, clEnqueueUnmapMemObject);
    WATCH(cl_events, enqueue, clEnqueueMarkerWithWaitList);
    WATCH(cl_events, enqueue, clEnqueueBarrierWithWaitList);
}

} // namespace
} // namespace lineatlas::test

extern "C" lineatlas::test::ClCounts lineatlas_test_count_cl_references() {
    lineatlas::test::ClCounts counts{};
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = lineatlas::test::references[i];
    return counts;
}

cl_int CL_API_CALL clGetLayerInfo(cl_layer_info name, size_t size, void* value,
                                  size_t* size_needed) {
    if (name != CL_LAYER_API_VERSION) return CL_INVALID_VALUE;
    constexpr cl_layer_api_version version = CL_LAYER_API_VERSION_100;
    if (size_needed != nullptr) *size_needed = sizeof(version);
    if (value == nullptr) return CL_SUCCESS;
    if (size < sizeof(version)) return CL_INVALID_VALUE;
    std::memcpy(value, &version, sizeof(version));
    return CL_SUCCESS;
}

cl_int CL_API_CALL clInitLayer(cl_uint entries, const cl_icd_dispatch* next,
                               cl_uint* entries_result, const cl_icd_dispatch** result) {
    static cl_icd_dispatch table{};
    constexpr auto own_entries = static_cast<cl_uint>(sizeof(table) / sizeof(table.clFinish));
    if (entries < own_entries) return CL_INVALID_VALUE;
    lineatlas::test::driver = next;
    table = *next;
    lineatlas::test::watch(table);
    *entries_result = own_entries;
    *result = &table;
    return CL_SUCCESS;
}
