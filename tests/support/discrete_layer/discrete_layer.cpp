#include "discrete_layer.hpp"

#include <chrono>
#include <cstring>
#include <utility>

#include "opencl_layer_entry.hpp"

namespace lineatlas::test {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::nanoseconds;

constexpr nanoseconds launch_time{5'000}, copy_time{10'000};
constexpr std::uint64_t bytes_per_nanosecond = 4;

const cl_icd_dispatch* driver = nullptr;
BusCounts counts{};

void spend(nanoseconds time) {
    for (const auto end = Clock::now() + time; Clock::now() < end;) {
    }
}

void cross(cl_bool blocking, std::size_t bytes) {
    ++counts.copies;
    counts.bytes += bytes;
    if (blocking != CL_FALSE) ++counts.waits;
    spend(copy_time + nanoseconds{bytes / bytes_per_nanosecond});
}

cl_int CL_API_CALL get_device_info(cl_device_id device, cl_device_info name, size_t size,
                                   void* value, size_t* size_needed) {
    if (name != CL_DEVICE_TYPE)
        return driver->clGetDeviceInfo(device, name, size, value, size_needed);
    constexpr cl_device_type type = CL_DEVICE_TYPE_GPU;
    if (size_needed != nullptr) *size_needed = sizeof type;
    if (value == nullptr) return CL_SUCCESS;
    if (size < sizeof type) return CL_INVALID_VALUE;
    std::memcpy(value, &type, sizeof type);
    return CL_SUCCESS;
}

cl_mem CL_API_CALL create_buffer(cl_context context, cl_mem_flags flags, size_t size, void* host,
                                 cl_int* result) {
    if ((flags & CL_MEM_USE_HOST_PTR) == 0)
        return driver->clCreateBuffer(context, flags, size, host, result);
    if (result != nullptr) *result = CL_INVALID_HOST_PTR;
    return nullptr;
}

cl_int CL_API_CALL launch(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions,
                          const size_t* offset, const size_t* global, const size_t* local,
                          cl_uint event_count, const cl_event* events, cl_event* event) {
    ++counts.launches;
    spend(launch_time);
    return driver->clEnqueueNDRangeKernel(queue, kernel, dimensions, offset, global, local,
                                          event_count, events, event);
}

cl_int CL_API_CALL read(cl_command_queue queue, cl_mem memory, cl_bool blocking, size_t offset,
                        size_t size, void* to, cl_uint event_count, const cl_event* events,
                        cl_event* event) {
    cross(blocking, size);
    return driver->clEnqueueReadBuffer(queue, memory, blocking, offset, size, to, event_count,
                                       events, event);
}

cl_int CL_API_CALL write(cl_command_queue queue, cl_mem memory, cl_bool blocking, size_t offset,
                         size_t size, const void* from, cl_uint event_count, const cl_event* events,
                         cl_event* event) {
    cross(blocking, size);
    return driver->clEnqueueWriteBuffer(queue, memory, blocking, offset, size, from, event_count,
                                        events, event);
}

cl_int CL_API_CALL finish(cl_command_queue queue) {
    ++counts.waits;
    return driver->clFinish(queue);
}

} // namespace

void begin_layer(const cl_icd_dispatch& own_driver, cl_icd_dispatch& table) {
    driver = &own_driver;
    table.clGetDeviceInfo = get_device_info;
    table.clCreateBuffer = create_buffer;
    table.clEnqueueNDRangeKernel = launch;
    table.clEnqueueReadBuffer = read;
    table.clEnqueueWriteBuffer = write;
    table.clFinish = finish;
}

} // namespace lineatlas::test

lineatlas::test::BusCounts lineatlas_test_take_bus_counts() {
    return std::exchange(lineatlas::test::counts, {});
}
