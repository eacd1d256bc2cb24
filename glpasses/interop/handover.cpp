#include "handover.hpp"

#include <string>

#include "compute/opencl/opencl_backend.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::interop {
namespace {

void check(cl_int status, const char* call) {
    if (status == CL_SUCCESS) return;
    throw DeviceError(std::string{"handing over between GL and OpenCL failed: "} + call +
                      " returned " + std::to_string(status) + "; use --interop copy");
}

cl_uint count_of(std::span<_cl_mem* const> opened) {
    return static_cast<cl_uint>(opened.size());
}

} // namespace

Handover::Handover(compute::Backend& backend)
    : backend_(backend), opencl_(dynamic_cast<compute::OpenClBackend*>(&backend)),
      events_(opencl_) {}

std::vector<_cl_mem*> Handover::opened_of(std::span<const Passed> passed) {
    std::vector<_cl_mem*> opened;
    for (const Passed& one : passed) {
        if (_cl_mem* object = one.shared.opened()) opened.push_back(object);
    }
    return opened;
}

void Handover::to_compute(std::span<const Passed> passed) {
    const std::vector<_cl_mem*> opened = opened_of(passed);
    if (!events_.usable() || opened.size() < passed.size()) glFinish();
    acquire(opened);
    for (const Passed& one : passed) one.shared.enter_compute(one.bytes);
}

void Handover::to_gl(std::span<const Passed> passed) {
    const std::vector<_cl_mem*> opened = opened_of(passed);
    for (const Passed& one : passed) one.shared.leave_compute(one.bytes);
    release(opened);
    if (!events_.usable() || opened.size() < passed.size()) backend_.finish();
    for (const Passed& one : passed) one.shared.enter_gl(one.bytes);
}

void Handover::acquire(std::span<_cl_mem* const> opened) {
    if (opened.empty()) return;
    const cl::Event after = events_.usable() ? events_.gl_commands_so_far() : cl::Event{};
    const cl_event handle = after();
    check(clEnqueueAcquireGLObjects(opencl_->queue()(), count_of(opened), opened.data(),
                                    handle != nullptr ? 1 : 0,
                                    handle != nullptr ? &handle : nullptr, nullptr),
          "clEnqueueAcquireGLObjects");
}

void Handover::release(std::span<_cl_mem* const> opened) {
    if (opened.empty()) return;
    check(clEnqueueReleaseGLObjects(opencl_->queue()(), count_of(opened), opened.data(), 0, nullptr,
                                    nullptr),
          "clEnqueueReleaseGLObjects");
    // With cl_khr_gl_event, GL commands from here on wait for what is submitted.
    if (events_.usable()) check(clFlush(opencl_->queue()()), "clFlush");
}

} // namespace lineatlas::interop
