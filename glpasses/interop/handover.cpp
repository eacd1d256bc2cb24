#include "handover.hpp"

#include <string>
#include <utility>

#include "compute/opencl/opencl_backend.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::interop {
namespace {

void check(cl_int status, const char* call) {
    if (status == CL_SUCCESS) return;
    throw DeviceError(std::string{"handing over between GL and OpenCL failed: "} + call +
                      " returned " + std::to_string(status) + "; use DeviceOptions::interop copy");
}

} // namespace

Handover::Handover(compute::Device& device)
    : device_(device), opencl_(dynamic_cast<compute::OpenClBackend*>(&device)), events_(opencl_) {}

bool Handover::find_going(std::span<Shared* const> shared, bool to_gl) {
    going_.clear();
    opened_.clear();
    for (Shared* one : shared) {
        if (one == nullptr || one->with_gl_ == to_gl) continue;
        going_.push_back(one);
        if (_cl_mem* object = one->opened()) opened_.push_back(object);
    }
    return events_.usable() && opened_.size() == going_.size();
}

void Handover::to_compute(std::span<Shared* const> shared) {
    const bool ordered = find_going(shared, false);
    if (going_.empty()) return;
    if (!ordered) glFinish();
    acquire();
    for (Shared* one : going_) {
        one->enter_compute(std::exchange(one->written_, 0));
        one->with_gl_ = false;
    }
}

void Handover::to_gl(std::span<Shared* const> shared) {
    const bool ordered = find_going(shared, true);
    if (going_.empty()) return;
    for (Shared* one : going_) one->leave_compute(one->written_);
    release();
    if (!ordered) device_.finish();
    for (Shared* one : going_) {
        one->enter_gl(std::exchange(one->written_, 0));
        one->with_gl_ = true;
    }
}

void Handover::acquire() {
    if (opened_.empty()) return;
    const cl::Event after = events_.usable() ? events_.gl_commands_so_far() : cl::Event{};
    const cl_event handle = after();
    check(clEnqueueAcquireGLObjects(opencl_->queue()(), static_cast<cl_uint>(opened_.size()),
                                    opened_.data(), handle != nullptr ? 1 : 0,
                                    handle != nullptr ? &handle : nullptr, nullptr),
          "clEnqueueAcquireGLObjects");
}

void Handover::release() {
    if (opened_.empty()) return;
    check(clEnqueueReleaseGLObjects(opencl_->queue()(), static_cast<cl_uint>(opened_.size()),
                                    opened_.data(), 0, nullptr, nullptr),
          "clEnqueueReleaseGLObjects");
    // With cl_khr_gl_event, GL commands from here on wait for what is submitted.
    if (events_.usable()) check(clFlush(opencl_->queue()()), "clFlush");
}

} // namespace lineatlas::interop
