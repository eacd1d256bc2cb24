#include "sharing.hpp"

#include <algorithm>

#include "gl_objects.hpp"
#include "lineatlas/error.hpp"
#include "shared_table.hpp"

namespace lineatlas::interop {
namespace {

std::unique_ptr<OpenedObjects> objects_for(compute::Device& device, SharingMode mode) {
    const auto* opencl = dynamic_cast<compute::OpenClBackend*>(&device);
    if (mode == SharingMode::external_memory && opencl == nullptr)
        throw DeviceError(device.description() +
                          " has no external-memory; use DeviceOptions::interop copy");
    if (mode == SharingMode::external_memory) return std::make_unique<ExternalObjects>(*opencl);
    if (mode == SharingMode::gl_sharing && opencl != nullptr)
        return std::make_unique<GlObjects>(*opencl);
    return nullptr;
}

} // namespace

void check_handover(int status, const char* call) {
    if (status == CL_SUCCESS) return;
    throw DeviceError(std::string{"handing over between GL and OpenCL failed: "} + call +
                      " returned " + std::to_string(status) + "; use DeviceOptions::interop copy");
}

std::string_view name_of(SharingMode mode) {
    constexpr std::string_view names[] = {"gl-sharing", "external-memory", "host-pointer", "copy"};
    static_assert(std::size(names) == all_modes.size()); // which stand in the same order
    return names[static_cast<std::size_t>(mode)];
}

std::optional<SharingMode> mode_of(std::string_view name) {
    const auto found = std::ranges::find(all_modes, name, name_of);
    if (found == all_modes.end()) return std::nullopt;
    return *found;
}

std::string mode_names() {
    std::string names;
    for (const SharingMode mode : all_modes)
        names += (names.empty() ? "" : ", ") + std::string{name_of(mode)};
    return names;
}

Sharing::Sharing(compute::Device& device, SharingMode mode)
    : device_(device), mode_(mode), objects_(objects_for(device, mode)) {}

void Sharing::to_compute(Shared& one) {
    if (!one.with_gl_) return;
    if (timer_ != nullptr) timer_->begin_handover();
    _cl_mem* const object = one.opened();
    const bool ordered = object != nullptr && objects_->are_ordered();
    if (one.leave_gl()) gl_works_ = true;
    if (gl_works_ && !ordered) {
        glFinish();
        gl_works_ = false;
    }
    if (object != nullptr) objects_->acquire(object);
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
    if (!opened_.empty()) objects_->release(opened_);
    const bool ordered = opened_.size() == going_.size() && objects_->are_ordered();
    if (!ordered) device_.finish();
    for (Shared* one : going_) {
        one->enter_gl();
        one->with_gl_ = true;
    }
    gl_works_ = true; // GL may have made copies
    if (timer_ != nullptr) timer_->end_handover();
}

} // namespace lineatlas::interop
