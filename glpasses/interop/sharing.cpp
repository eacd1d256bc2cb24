#include "sharing.hpp"

#include <string>

#include "compute/opencl/opencl_backend.hpp"
#include "lineatlas/error.hpp"
#include "shared_table.hpp"

namespace lineatlas::interop {
namespace {

void check(cl_int status, const char* call) {
    if (status == CL_SUCCESS) return;
    throw DeviceError(std::string{"handing over between GL and OpenCL failed: "} + call +
                      " returned " + std::to_string(status) + "; use DeviceOptions::interop copy");
}

} // namespace

std::string_view name_of(SharingMode mode) {
    switch (mode) {
    case SharingMode::gl_sharing:
        return "gl-sharing";
    case SharingMode::host_pointer:
        return "host-pointer";
    case SharingMode::copy:
        return "copy";
    }
    return "unknown";
}

Sharing::Sharing(compute::Device& device, SharingMode mode)
    : device_(device), mode_(mode), opencl_(dynamic_cast<compute::OpenClBackend*>(&device)),
      events_(opencl_) {}

void Sharing::to_compute(Shared& one) {
    if (!one.with_gl_) return;
    if (timer_ != nullptr) timer_->begin_handover();
    _cl_mem* const object = one.opened();
    const bool ordered = events_.usable() && object != nullptr;
    if (gl_works_ && !ordered) {
        glFinish();
        gl_works_ = false;
    }
    if (object != nullptr) acquire(object);
    one.enter_compute();
    one.with_gl_ = false;
    if (timer_ != nullptr) timer_->end_handover();
}

void Sharing::to_gl(Shared& one) {
    going_.clear();
    if (!one.with_gl_) going_.push_back(&one);
    pass_to_gl();
}

void Sharing::to_gl(std::initializer_list<SharedTable*> tables) {
    going_.clear();
    for (SharedTable* table : tables)
        if (*table && !table->memory_->with_gl_) going_.push_back(table->memory_.get());
    pass_to_gl();
}

void Sharing::pass_to_gl() {
    if (going_.empty()) return;
    if (timer_ != nullptr) timer_->begin_handover();
    opened_.clear();
    for (Shared* one : going_) {
        if (_cl_mem* object = one->opened()) opened_.push_back(object);
        one->leave_compute();
    }
    release();
    if (!events_.usable() || opened_.size() != going_.size()) device_.finish();
    for (Shared* one : going_) {
        one->enter_gl();
        one->with_gl_ = true;
    }
    if (timer_ != nullptr) timer_->end_handover();
}

void Sharing::acquire(_cl_mem* object) {
    const cl::Event after = events_.usable() ? events_.gl_commands_so_far() : cl::Event{};
    const cl_event handle = after();
    check(clEnqueueAcquireGLObjects(opencl_->queue()(), 1, &object, handle != nullptr ? 1 : 0,
                                    handle != nullptr ? &handle : nullptr, nullptr),
          "clEnqueueAcquireGLObjects");
}

void Sharing::release() {
    if (opened_.empty()) return;
    check(clEnqueueReleaseGLObjects(opencl_->queue()(), static_cast<cl_uint>(opened_.size()),
                                    opened_.data(), 0, nullptr, nullptr),
          "clEnqueueReleaseGLObjects");
    // With cl_khr_gl_event, GL commands from here on wait for what is submitted.
    if (events_.usable()) check(clFlush(opencl_->queue()()), "clFlush");
}

} // namespace lineatlas::interop
