#include "fault_layer.hpp"

#include <cstring>
#include <tuple>

#include <CL/cl_icd.h>
#include <CL/cl_layer.h>

namespace {

using lineatlas::test::OpenClFaults;

OpenClFaults faults;
const cl_icd_dispatch* driver = nullptr;

/// Counts a call; whether it is the one that fails.
bool fails(int& count, int& wanted) {
    ++count;
    if (wanted == 0 || --wanted > 0) return false;
    return true; // wanted is 0 now: those after it succeed
}

template <auto function>
struct Hook;

template <class Result, class... Arguments,
          Result (CL_API_CALL* cl_icd_dispatch::*function)(Arguments...)>
struct Hook<function> {
    /// Of what makes an object and returns a status through its last argument.
    static Result CL_API_CALL create(Arguments... arguments) {
        if (fails(faults.creations, faults.fail_creation)) {
            auto* status = std::get<sizeof...(Arguments) - 1>(std::tie(arguments...));
            if (status != nullptr) *status = CL_OUT_OF_HOST_MEMORY;
            return nullptr;
        }
        Result result = (driver->*function)(arguments...);
        if (result != nullptr) ++faults.live;
        return result;
    }
    static Result CL_API_CALL build(Arguments... arguments) {
        if (fails(faults.creations, faults.fail_creation)) return CL_OUT_OF_HOST_MEMORY;
        return (driver->*function)(arguments...);
    }
    static Result CL_API_CALL command(Arguments... arguments) {
        if (fails(faults.commands, faults.fail_command)) return CL_OUT_OF_RESOURCES;
        return (driver->*function)(arguments...);
    }
    /// Of what maps memory: a command with the status last.
    static Result CL_API_CALL map(Arguments... arguments) {
        if (fails(faults.commands, faults.fail_command)) {
            auto* status = std::get<sizeof...(Arguments) - 1>(std::tie(arguments...));
            if (status != nullptr) *status = CL_MAP_FAILURE;
            return nullptr;
        }
        return (driver->*function)(arguments...);
    }
    static Result CL_API_CALL retain(Arguments... arguments) {
        const Result status = (driver->*function)(arguments...);
        if (status == CL_SUCCESS) ++faults.live;
        return status;
    }
    static Result CL_API_CALL release(Arguments... arguments) {
        const Result status = (driver->*function)(arguments...);
        if (status == CL_SUCCESS) --faults.live;
        return status;
    }
};

void add_hooks(cl_icd_dispatch& table) {
    using D = cl_icd_dispatch;
    table.clCreateContext = Hook<&D::clCreateContext>::create;
    table.clCreateCommandQueue = Hook<&D::clCreateCommandQueue>::create;
    table.clCreateBuffer = Hook<&D::clCreateBuffer>::create;
    table.clCreateProgramWithSource = Hook<&D::clCreateProgramWithSource>::create;
    table.clCreateProgramWithBinary = Hook<&D::clCreateProgramWithBinary>::create;
    table.clCreateKernel = Hook<&D::clCreateKernel>::create;
    table.clBuildProgram = Hook<&D::clBuildProgram>::build;
    table.clEnqueueNDRangeKernel = Hook<&D::clEnqueueNDRangeKernel>::command;
    table.clEnqueueReadBuffer = Hook<&D::clEnqueueReadBuffer>::command;
    table.clEnqueueWriteBuffer = Hook<&D::clEnqueueWriteBuffer>::command;
    table.clEnqueueCopyBuffer = Hook<&D::clEnqueueCopyBuffer>::command;
    table.clEnqueueFillBuffer = Hook<&D::clEnqueueFillBuffer>::command;
    table.clEnqueueUnmapMemObject = Hook<&D::clEnqueueUnmapMemObject>::command;
    table.clEnqueueMapBuffer = Hook<&D::clEnqueueMapBuffer>::map;
    table.clFlush = Hook<&D::clFlush>::command;
    table.clFinish = Hook<&D::clFinish>::command;
    table.clRetainContext = Hook<&D::clRetainContext>::retain;
    table.clRetainCommandQueue = Hook<&D::clRetainCommandQueue>::retain;
    table.clRetainMemObject = Hook<&D::clRetainMemObject>::retain;
    table.clRetainProgram = Hook<&D::clRetainProgram>::retain;
    table.clRetainKernel = Hook<&D::clRetainKernel>::retain;
    table.clReleaseContext = Hook<&D::clReleaseContext>::release;
    table.clReleaseCommandQueue = Hook<&D::clReleaseCommandQueue>::release;
    table.clReleaseMemObject = Hook<&D::clReleaseMemObject>::release;
    table.clReleaseProgram = Hook<&D::clReleaseProgram>::release;
    table.clReleaseKernel = Hook<&D::clReleaseKernel>::release;
}

} // namespace

extern "C" OpenClFaults* lineatlas_test_opencl_faults() {
    return &faults;
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

cl_int CL_API_CALL clInitLayer(cl_uint entries, const cl_icd_dispatch* below,
                               cl_uint* entries_result, const cl_icd_dispatch** result) {
    static cl_icd_dispatch table{};
    constexpr auto own_entries = static_cast<cl_uint>(sizeof(table) / sizeof(table.clFinish));
    if (entries < own_entries) return CL_INVALID_VALUE;
    driver = below;
    table = *below;
    add_hooks(table);
    *entries_result = own_entries;
    *result = &table;
    return CL_SUCCESS;
}
