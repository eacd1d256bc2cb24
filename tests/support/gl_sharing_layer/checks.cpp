#include <cstring>

#include "sharing.hpp"
#include "state.hpp"

namespace lineatlas::test {
namespace {

cl_int CL_API_CALL set_argument(cl_kernel kernel, cl_uint index, size_t size, const void* value) {
    auto& arguments = state().arguments[kernel];
    arguments.erase(index);
    if (size == sizeof(cl_mem) && value != nullptr) {
        // These may be any 8 bytes; they mean an object only if the handle is known.
        cl_mem memory = nullptr;
        std::memcpy(&memory, value, sizeof(memory));
        if (state().opened.contains(memory)) arguments[index] = memory;
    }
    return state().driver->clSetKernelArg(kernel, index, size, value);
}

cl_int CL_API_CALL launch(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions,
                          const size_t* offset, const size_t* global, const size_t* local,
                          cl_uint event_count, const cl_event* events, cl_event* event) {
    for (const auto& [index, memory] : state().arguments[kernel]) check_use(memory, "a kernel");
    return state().driver->clEnqueueNDRangeKernel(queue, kernel, dimensions, offset, global, local,
                                                  event_count, events, event);
}

// A driver holds its own references while commands run, so its count does not tell when the program
// has released an object. A handle that is used again must not inherit the state of an earlier
// object.

cl_kernel CL_API_CALL create_kernel(cl_program program, const char* name, cl_int* result) {
    cl_kernel kernel = state().driver->clCreateKernel(program, name, result);
    state().arguments.erase(kernel);
    return kernel;
}

cl_int CL_API_CALL retain_memory(cl_mem memory) {
    const auto found = state().opened.find(memory);
    if (found != state().opened.end()) ++found->second.references;
    return state().driver->clRetainMemObject(memory);
}

cl_int CL_API_CALL release_memory(cl_mem memory) {
    const auto found = state().opened.find(memory);
    if (found != state().opened.end() && --found->second.references == 0) {
        state().opened.erase(found);
    }
    return state().driver->clReleaseMemObject(memory);
}

cl_int CL_API_CALL read_buffer(cl_command_queue queue, cl_mem memory, cl_bool blocking,
                               size_t offset, size_t size, void* to, cl_uint event_count,
                               const cl_event* events, cl_event* event) {
    check_use(memory, "clEnqueueReadBuffer");
    return state().driver->clEnqueueReadBuffer(queue, memory, blocking, offset, size, to,
                                               event_count, events, event);
}

cl_int CL_API_CALL write_buffer(cl_command_queue queue, cl_mem memory, cl_bool blocking,
                                size_t offset, size_t size, const void* from, cl_uint event_count,
                                const cl_event* events, cl_event* event) {
    check_use(memory, "clEnqueueWriteBuffer");
    return state().driver->clEnqueueWriteBuffer(queue, memory, blocking, offset, size, from,
                                                event_count, events, event);
}

cl_int CL_API_CALL copy_buffer(cl_command_queue queue, cl_mem from, cl_mem to, size_t from_offset,
                               size_t to_offset, size_t size, cl_uint event_count,
                               const cl_event* events, cl_event* event) {
    check_use(from, "clEnqueueCopyBuffer");
    check_use(to, "clEnqueueCopyBuffer");
    return state().driver->clEnqueueCopyBuffer(queue, from, to, from_offset, to_offset, size,
                                               event_count, events, event);
}

cl_int CL_API_CALL fill_buffer(cl_command_queue queue, cl_mem memory, const void* pattern,
                               size_t pattern_size, size_t offset, size_t size, cl_uint event_count,
                               const cl_event* events, cl_event* event) {
    check_use(memory, "clEnqueueFillBuffer");
    return state().driver->clEnqueueFillBuffer(queue, memory, pattern, pattern_size, offset, size,
                                               event_count, events, event);
}

cl_int CL_API_CALL read_image(cl_command_queue queue, cl_mem image, cl_bool blocking,
                              const size_t* origin, const size_t* region, size_t row_pitch,
                              size_t slice_pitch, void* to, cl_uint event_count,
                              const cl_event* events, cl_event* event) {
    check_use(image, "clEnqueueReadImage");
    return state().driver->clEnqueueReadImage(queue, image, blocking, origin, region, row_pitch,
                                              slice_pitch, to, event_count, events, event);
}

cl_int CL_API_CALL write_image(cl_command_queue queue, cl_mem image, cl_bool blocking,
                               const size_t* origin, const size_t* region, size_t row_pitch,
                               size_t slice_pitch, const void* from, cl_uint event_count,
                               const cl_event* events, cl_event* event) {
    check_use(image, "clEnqueueWriteImage");
    return state().driver->clEnqueueWriteImage(queue, image, blocking, origin, region, row_pitch,
                                               slice_pitch, from, event_count, events, event);
}

cl_int CL_API_CALL finish(cl_command_queue queue) {
    const cl_int status = state().driver->clFinish(queue);
    ++state().counts.cl_waits;
    arrive_in_gl();
    return status;
}

} // namespace

void add_checks(cl_icd_dispatch& table) {
    table.clSetKernelArg = set_argument;
    table.clEnqueueNDRangeKernel = launch;
    table.clCreateKernel = create_kernel;
    table.clRetainMemObject = retain_memory;
    table.clReleaseMemObject = release_memory;
    table.clEnqueueReadBuffer = read_buffer;
    table.clEnqueueWriteBuffer = write_buffer;
    table.clEnqueueCopyBuffer = copy_buffer;
    table.clEnqueueFillBuffer = fill_buffer;
    table.clEnqueueReadImage = read_image;
    table.clEnqueueWriteImage = write_image;
    table.clFinish = finish;
}

} // namespace lineatlas::test
