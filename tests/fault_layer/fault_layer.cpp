#include "fault_layer.hpp"

#include <tuple>
#include <type_traits>

#include <CL/cl_icd.h>

#include "opencl_layer_entry.hpp"

namespace lineatlas::test {
namespace {

OpenClFaults faults;
const cl_icd_dispatch* driver = nullptr;

/// Counts a call; whether it is the one that fails.
bool fails(int& count, int& wanted) {
    ++count;
    if (wanted == 0 || --wanted > 0) return false;
    return true; // wanted is 0 now: those after it succeed
}

/// A command that was asked for its event made one.
template <class Argument>
void count_event(Argument argument) {
    if constexpr (std::is_same_v<Argument, cl_event*>) {
        if (argument != nullptr) ++faults.references[cl_events];
    }
}

template <auto function, ClKind kind = cl_kinds>
struct Hook;

template <class Result, class... Arguments,
          Result (CL_API_CALL* cl_icd_dispatch::*function)(Arguments...), ClKind kind>
struct Hook<function, kind> {
    /// Of what makes an object and returns a status through its last argument.
    static Result CL_API_CALL create(Arguments... arguments) {
        if (fails(faults.creations, faults.fail_creation)) {
            auto* status = std::get<sizeof...(Arguments) - 1>(std::tie(arguments...));
            if (status != nullptr) *status = CL_OUT_OF_HOST_MEMORY;
            return nullptr;
        }
        Result result = (driver->*function)(arguments...);
        if (result != nullptr) ++faults.references[kind];
        return result;
    }
    static Result CL_API_CALL build(Arguments... arguments) {
        if (fails(faults.creations, faults.fail_creation)) return CL_OUT_OF_HOST_MEMORY;
        return (driver->*function)(arguments...);
    }
    static Result CL_API_CALL command(Arguments... arguments) {
        if (fails(faults.commands, faults.fail_command)) return CL_OUT_OF_RESOURCES;
        const Result status = (driver->*function)(arguments...);
        if (status == CL_SUCCESS) (count_event(arguments), ...);
        return status;
    }
    /// Of what maps memory: a command with the status last.
    static Result CL_API_CALL map(Arguments... arguments) {
        if (fails(faults.commands, faults.fail_command)) {
            auto* status = std::get<sizeof...(Arguments) - 1>(std::tie(arguments...));
            if (status != nullptr) *status = CL_MAP_FAILURE;
            return nullptr;
        }
        Result memory = (driver->*function)(arguments...);
        if (memory != nullptr) (count_event(arguments), ...);
        return memory;
    }
    static Result CL_API_CALL retain(Arguments... arguments) {
        const Result status = (driver->*function)(arguments...);
        if (status == CL_SUCCESS) ++faults.references[kind];
        return status;
    }
    static Result CL_API_CALL release(Arguments... arguments) {
        const Result status = (driver->*function)(arguments...);
        if (status == CL_SUCCESS) --faults.references[kind];
        return status;
    }
};

} // namespace

void begin_layer(const cl_icd_dispatch& below, cl_icd_dispatch& table) {
    using D = cl_icd_dispatch;
    driver = &below;
    table.clCreateContext = Hook<&D::clCreateContext, cl_contexts>::create;
    table.clCreateContextFromType = Hook<&D::clCreateContextFromType, cl_contexts>::create;
    table.clRetainContext = Hook<&D::clRetainContext, cl_contexts>::retain;
    table.clReleaseContext = Hook<&D::clReleaseContext, cl_contexts>::release;
    table.clCreateCommandQueue = Hook<&D::clCreateCommandQueue, cl_queues>::create;
    table.clRetainCommandQueue = Hook<&D::clRetainCommandQueue, cl_queues>::retain;
    table.clReleaseCommandQueue = Hook<&D::clReleaseCommandQueue, cl_queues>::release;
    table.clCreateBuffer = Hook<&D::clCreateBuffer, cl_memory>::create;
    table.clCreateSubBuffer = Hook<&D::clCreateSubBuffer, cl_memory>::create;
    table.clCreateImage = Hook<&D::clCreateImage, cl_memory>::create;
    table.clRetainMemObject = Hook<&D::clRetainMemObject, cl_memory>::retain;
    table.clReleaseMemObject = Hook<&D::clReleaseMemObject, cl_memory>::release;
    table.clCreateProgramWithSource = Hook<&D::clCreateProgramWithSource, cl_programs>::create;
    table.clCreateProgramWithBinary = Hook<&D::clCreateProgramWithBinary, cl_programs>::create;
    table.clRetainProgram = Hook<&D::clRetainProgram, cl_programs>::retain;
    table.clReleaseProgram = Hook<&D::clReleaseProgram, cl_programs>::release;
    table.clCreateKernel = Hook<&D::clCreateKernel, cl_kernels>::create;
    table.clRetainKernel = Hook<&D::clRetainKernel, cl_kernels>::retain;
    table.clReleaseKernel = Hook<&D::clReleaseKernel, cl_kernels>::release;
    table.clCreateUserEvent = Hook<&D::clCreateUserEvent, cl_events>::create;
    table.clRetainEvent = Hook<&D::clRetainEvent, cl_events>::retain;
    table.clReleaseEvent = Hook<&D::clReleaseEvent, cl_events>::release;
    table.clBuildProgram = Hook<&D::clBuildProgram>::build;
    table.clEnqueueNDRangeKernel = Hook<&D::clEnqueueNDRangeKernel>::command;
    table.clEnqueueReadBuffer = Hook<&D::clEnqueueReadBuffer>::command;
    table.clEnqueueWriteBuffer = Hook<&D::clEnqueueWriteBuffer>::command;
    table.clEnqueueCopyBuffer = Hook<&D::clEnqueueCopyBuffer>::command;
    table.clEnqueueFillBuffer = Hook<&D::clEnqueueFillBuffer>::command;
    table.clEnqueueUnmapMemObject = Hook<&D::clEnqueueUnmapMemObject>::command;
    table.clEnqueueMarkerWithWaitList = Hook<&D::clEnqueueMarkerWithWaitList>::command;
    table.clEnqueueBarrierWithWaitList = Hook<&D::clEnqueueBarrierWithWaitList>::command;
    table.clEnqueueMapBuffer = Hook<&D::clEnqueueMapBuffer>::map;
    table.clFlush = Hook<&D::clFlush>::command;
    table.clFinish = Hook<&D::clFinish>::command;
}

} // namespace lineatlas::test

extern "C" lineatlas::test::OpenClFaults* lineatlas_test_opencl_faults() {
    return &lineatlas::test::faults;
}
