#include "fault_layer.hpp"

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include <CL/cl_icd.h>

#include "opencl_layer_entry.hpp"
#include "quick_builds.hpp"

namespace lineatlas::test {
namespace {

std::uint64_t number_from(const char* variable) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : 0;
}

OpenClFaults faults{.memory = number_from("LINEATLAS_TEST_MEMORY"),
                    .largest_buffer = number_from("LINEATLAS_TEST_BUFFER"),
                    .largest_group = number_from("LINEATLAS_TEST_GROUP")};
const cl_icd_dispatch* driver = nullptr;
bool is_lost = false;           ///< from the failed command on, if OpenClFaults::lost is set
cl_int late_error = CL_SUCCESS; ///< the result of the next wait

/// Several threads may count at the same time.
template <class Number>
void count_up(Number& number, int by = 1) {
    std::atomic_ref{number} += by;
}

/// Counts a call. Returns true if the call must fail.
bool fails(int& count, int& wanted) {
    count_up(count);
    if (is_lost && !faults.lost) is_lost = false;
    if (is_lost) return true;
    if (wanted == 0 || --wanted > 0) return false;
    is_lost = faults.lost;
    return true; // wanted is 0 now, so later calls succeed
}

/// True if a command must fail at once.
bool command_fails() {
    if (!fails(faults.commands, faults.fail_command)) return false;
    if (faults.late) late_error = CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST;
    return !faults.late;
}

/// The result of a wait.
cl_int wait_status(cl_int status) {
    const cl_int error = late_error;
    late_error = CL_SUCCESS;
    return error != CL_SUCCESS ? error : status;
}

/// Counts the event of a command if the caller asked for one.
template <class Argument>
void count_event(Argument argument) {
    if constexpr (std::is_same_v<Argument, cl_event*>) {
        if (argument != nullptr) count_up(faults.references[cl_events]);
    }
}

template <auto function, ClKind kind = cl_kinds>
struct Hook;

template <class Result, class... Arguments,
          Result (CL_API_CALL* cl_icd_dispatch::*function)(Arguments...), ClKind kind>
struct Hook<function, kind> {
    /// For functions that make an object and return a status through their last argument.
    static Result CL_API_CALL create(Arguments... arguments) {
        if (fails(faults.creations, faults.fail_creation)) {
            auto* status = std::get<sizeof...(Arguments) - 1>(std::tie(arguments...));
            if (status != nullptr) *status = CL_OUT_OF_HOST_MEMORY;
            return nullptr;
        }
        Result result = (driver->*function)(arguments...);
        if (result != nullptr) count_up(faults.references[kind]);
        return result;
    }
    static Result CL_API_CALL build(Arguments... arguments) {
        count_up(faults.builds);
        if (fails(faults.creations, faults.fail_creation)) return CL_OUT_OF_HOST_MEMORY;
        return (driver->*function)(arguments...);
    }
    static Result CL_API_CALL command(Arguments... arguments) {
        if (command_fails()) return faults.status;
        const Result status = (driver->*function)(arguments...);
        if (status == CL_SUCCESS) (count_event(arguments), ...);
        return status;
    }
    /// For commands that wait for earlier commands. On a lost device these have ended.
    static Result CL_API_CALL wait(Arguments... arguments) {
        const Result status = wait_status(command(arguments...));
        if (is_lost) (driver->*function)(arguments...);
        return status;
    }
    /// For commands that wait if their third argument asks for it.
    static Result CL_API_CALL transfer(Arguments... arguments) {
        const bool waits = std::get<2>(std::tie(arguments...)) == CL_TRUE;
        const Result status = command(arguments...);
        return waits ? wait_status(status) : status;
    }
    /// For commands that map memory, whose last argument takes the status.
    static Result CL_API_CALL map(Arguments... arguments) {
        if (command_fails()) {
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
        if (status == CL_SUCCESS) count_up(faults.references[kind]);
        return status;
    }
    static Result CL_API_CALL release(Arguments... arguments) {
        const Result status = (driver->*function)(arguments...);
        if (status == CL_SUCCESS) count_up(faults.references[kind], -1);
        return status;
    }
};

/// Atomic, because buffers may end in the driver's threads.
std::atomic_ref<std::uint64_t> allocated() {
    return std::atomic_ref{faults.allocated};
}

bool is_too_large(size_t bytes, cl_int* status) {
    const bool for_a_buffer = faults.largest_buffer != 0 && bytes > faults.largest_buffer;
    const bool for_all = faults.memory != 0 && allocated() + bytes > faults.memory;
    if (status != nullptr && for_all) *status = CL_MEM_OBJECT_ALLOCATION_FAILURE;
    if (status != nullptr && for_a_buffer) *status = CL_INVALID_BUFFER_SIZE;
    return for_a_buffer || for_all;
}

cl_mem CL_API_CALL create_buffer(cl_context context, cl_mem_flags flags, size_t size, void* host,
                                 cl_int* status) {
    if (is_too_large(size, status)) return nullptr;
    cl_mem buffer = Hook<&cl_icd_dispatch::clCreateBuffer, cl_memory>::create(context, flags, size,
                                                                              host, status);
    if (buffer == nullptr) return nullptr;
    allocated() += size;
    driver->clSetMemObjectDestructorCallback(
        buffer, [](cl_mem, void* bytes) { allocated() -= reinterpret_cast<std::uintptr_t>(bytes); },
        reinterpret_cast<void*>(size));
    return buffer;
}

/// Imitates a fault of the compiler: replaces the text before => in LINEATLAS_TEST_MISCOMPILE by
/// the text after it, where it occurs first.
cl_program CL_API_CALL create_program(cl_context context, cl_uint count, const char** texts,
                                      const size_t* lengths, cl_int* status) {
    using Created = Hook<&cl_icd_dispatch::clCreateProgramWithSource, cl_programs>;
    const char* variable = std::getenv("LINEATLAS_TEST_MISCOMPILE");
    if (variable == nullptr) return Created::create(context, count, texts, lengths, status);
    const std::string fault = variable;
    const std::size_t arrow = fault.find("=>");
    std::string source;
    for (cl_uint i = 0; i < count; ++i)
        source += lengths == nullptr || lengths[i] == 0 ? std::string{texts[i]}
                                                        : std::string{texts[i], lengths[i]};
    const std::size_t place = source.find(fault.substr(0, arrow));
    if (place != std::string::npos) source.replace(place, arrow, fault.substr(arrow + 2));
    const char* text = source.c_str();
    return Created::create(context, 1, &text, nullptr, status);
}

/// Changes a value that a program asked for to `limit`, if there is one.
template <class Value>
void pretend(Value limit, void* value) {
    if (limit != 0 && value != nullptr) std::memcpy(value, &limit, sizeof(limit));
}

cl_int CL_API_CALL device_info(cl_device_id device, cl_device_info name, size_t size, void* value,
                               size_t* size_needed) {
    const cl_int status = driver->clGetDeviceInfo(device, name, size, value, size_needed);
    if (status != CL_SUCCESS || !faults.says_limits) return status;
    if (name == CL_DEVICE_GLOBAL_MEM_SIZE) pretend(faults.memory, value);
    if (name == CL_DEVICE_MAX_MEM_ALLOC_SIZE) pretend(faults.largest_buffer, value);
    if (name == CL_DEVICE_MAX_WORK_GROUP_SIZE) pretend(faults.largest_group, value);
    return status;
}

cl_int CL_API_CALL kernel_info(cl_kernel kernel, cl_device_id device,
                               cl_kernel_work_group_info name, size_t size, void* value,
                               size_t* size_needed) {
    const cl_int status =
        driver->clGetKernelWorkGroupInfo(kernel, device, name, size, value, size_needed);
    if (status == CL_SUCCESS && name == CL_KERNEL_WORK_GROUP_SIZE) {
        pretend(faults.largest_group, value);
    }
    return status;
}

cl_int CL_API_CALL set_argument(cl_kernel kernel, cl_uint index, size_t size, const void* value) {
    if (static_cast<int>(index) == faults.fail_argument) return CL_INVALID_ARG_SIZE;
    return driver->clSetKernelArg(kernel, index, size, value);
}

/// The form of a kernel that drivers build: "scan_list -DSCAN_SATURATE=0 ..., groups of 64".
std::string form_of(cl_kernel kernel, std::size_t items, std::size_t group) {
    constexpr std::size_t many = 1U << 16U; // for PoCL

    char name[64] = "", options[1024] = "";
    cl_program program = nullptr;
    cl_context context = nullptr;
    cl_device_id device = nullptr;
    driver->clGetKernelInfo(kernel, CL_KERNEL_FUNCTION_NAME, sizeof(name), name, nullptr);
    driver->clGetKernelInfo(kernel, CL_KERNEL_PROGRAM, sizeof(program), &program, nullptr);
    driver->clGetKernelInfo(kernel, CL_KERNEL_CONTEXT, sizeof(context), &context, nullptr);
    driver->clGetContextInfo(context, CL_CONTEXT_DEVICES, sizeof(device), &device, nullptr);
    driver->clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_OPTIONS, sizeof(options),
                                  options, nullptr);
    return std::string{name} + ' ' + options +
           (items < many ? ", groups of " : ", many groups of ") + std::to_string(group);
}

void look_at(cl_kernel kernel, std::size_t items, std::size_t group) {
    static std::set<std::string> known;
    static int period = 0;
    if (faults.period == 0) return;
    if (std::exchange(period, faults.period) != faults.period) known.clear();
    const auto [form, is_new] = known.insert(form_of(kernel, items, group));
    if (!is_new) return;
    ++faults.new_forms;
    faults.new_form = form->c_str();
}

cl_int CL_API_CALL launch(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions,
                          const size_t* offset, const size_t* global, const size_t* local,
                          cl_uint waits, const cl_event* wait_list, cl_event* event) {
    if (faults.largest_group != 0 && local[0] > faults.largest_group) {
        return CL_INVALID_WORK_GROUP_SIZE;
    }
    look_at(kernel, global[0], local[0]);
    return Hook<&cl_icd_dispatch::clEnqueueNDRangeKernel>::command(
        queue, kernel, dimensions, offset, global, local, waits, wait_list, event);
}

} // namespace

void begin_layer(const cl_icd_dispatch& below, cl_icd_dispatch& table) {
    using D = cl_icd_dispatch;
    driver = &build_once(below, faults.builds_once);
    table = *driver;
    table.clCreateContext = Hook<&D::clCreateContext, cl_contexts>::create;
    table.clCreateContextFromType = Hook<&D::clCreateContextFromType, cl_contexts>::create;
    table.clRetainContext = Hook<&D::clRetainContext, cl_contexts>::retain;
    table.clReleaseContext = Hook<&D::clReleaseContext, cl_contexts>::release;
    table.clCreateCommandQueue = Hook<&D::clCreateCommandQueue, cl_queues>::create;
    table.clRetainCommandQueue = Hook<&D::clRetainCommandQueue, cl_queues>::retain;
    table.clReleaseCommandQueue = Hook<&D::clReleaseCommandQueue, cl_queues>::release;
    table.clCreateBuffer = create_buffer;
    table.clGetDeviceInfo = device_info;
    table.clGetKernelWorkGroupInfo = kernel_info;
    table.clCreateSubBuffer = Hook<&D::clCreateSubBuffer, cl_memory>::create;
    table.clCreateImage = Hook<&D::clCreateImage, cl_memory>::create;
    table.clRetainMemObject = Hook<&D::clRetainMemObject, cl_memory>::retain;
    table.clReleaseMemObject = Hook<&D::clReleaseMemObject, cl_memory>::release;
    table.clCreateProgramWithSource = create_program;
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
    table.clSetKernelArg = set_argument;
    table.clEnqueueNDRangeKernel = launch;
    table.clEnqueueReadBuffer = Hook<&D::clEnqueueReadBuffer>::transfer;
    table.clEnqueueWriteBuffer = Hook<&D::clEnqueueWriteBuffer>::transfer;
    table.clEnqueueCopyBuffer = Hook<&D::clEnqueueCopyBuffer>::command;
    table.clEnqueueFillBuffer = Hook<&D::clEnqueueFillBuffer>::command;
    table.clEnqueueUnmapMemObject = Hook<&D::clEnqueueUnmapMemObject>::command;
    table.clEnqueueMarkerWithWaitList = Hook<&D::clEnqueueMarkerWithWaitList>::command;
    table.clEnqueueBarrierWithWaitList = Hook<&D::clEnqueueBarrierWithWaitList>::command;
    table.clEnqueueMapBuffer = Hook<&D::clEnqueueMapBuffer>::map;
    table.clFlush = Hook<&D::clFlush>::command;
    table.clFinish = Hook<&D::clFinish>::wait;
}

} // namespace lineatlas::test

extern "C" lineatlas::test::OpenClFaults* lineatlas_test_opencl_faults() {
    return &lineatlas::test::faults;
}
