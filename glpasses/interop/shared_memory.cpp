#include "shared_memory.hpp"

#include <algorithm>
#include <string>

#include "compute/opencl/opencl_backend.hpp"
#include "glpasses/storage.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::interop {
namespace {

/// Memory of another API that OpenCL has opened.
class OpenedMemory : public SharedMemory {
  protected:
    using SharedMemory::SharedMemory;
    void open(std::unique_ptr<compute::OpenClBuffer> buffer) {
        opened_ = buffer->memory();
        compute_ = std::move(buffer);
    }

  private:
    _cl_mem* opened() const override { return opened_; }

    _cl_mem* opened_ = nullptr;
};

/// One GL buffer opened by OpenCL.
class GlSharingMemory final : public OpenedMemory {
  public:
    GlSharingMemory(const compute::OpenClBackend& device, std::size_t bytes, const Purpose& purpose)
        : OpenedMemory(bytes) {
        gl::allocate(gl_, bytes, nullptr, GL_DYNAMIC_STORAGE_BIT, purpose);
        try {
            cl::BufferGL opened{device.context(), CL_MEM_READ_WRITE, gl_.id()};
            open(std::make_unique<compute::OpenClBuffer>(std::move(opened), bytes));
        } catch (const cl::Error& error) {
            throw DeviceError(std::string{"sharing a GL buffer failed: "} + error.what() +
                              " returned " + std::to_string(error.err()) +
                              "; use DeviceOptions::interop copy");
        }
    }
};

/// Memory of a Vulkan device that both GL and OpenCL have imported.
class ExternalMemory final : public OpenedMemory {
  public:
    ExternalMemory(const ExternalObjects& objects, std::size_t bytes, const Purpose& purpose)
        : OpenedMemory(bytes) {
        ExportedMemory memory = objects.allocate(bytes);
        gl::import(gl_, bytes, memory.for_gl.release(), memory.bytes, purpose);
        open(objects.open(memory.for_compute, bytes));
    }
};

/// Runs an action whose failure with a lost device does not matter.
template <class Action>
void quietly(Action&& action) {
    try {
        action();
    } catch (const Error&) {
        return; // a queue that failed runs nothing any more
    }
}

/// Gives the buffer memory of the host, which GL keeps mapped.
std::span<std::byte> map_for_good(const gl::Buffer& buffer, std::size_t bytes, GLbitfield flags,
                                  const Purpose& purpose) {
    constexpr GLbitfield access =
        GL_MAP_READ_BIT | GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    gl::allocate(buffer, bytes, nullptr, access | flags, purpose);
    return {static_cast<std::byte*>(gl::map(buffer, bytes, access, purpose)), bytes};
}

/// Host memory that GL keeps mapped and compute wraps.
class HostPointerMemory final : public SharedMemory {
  public:
    HostPointerMemory(compute::Device& device, std::size_t bytes, const Purpose& purpose)
        : SharedMemory(bytes), device_(device) {
        compute_ = device.wrap(map_for_good(gl_, bytes, GL_DYNAMIC_STORAGE_BIT, purpose));
        device.begin_host_access(*compute_);
    }
    ~HostPointerMemory() override {
        // The wrapper must be gone before GL frees its memory, and kernels must be done: an error
        // may have ended a frame before its kernels. PoCL 3.1 never frees a buffer that is released
        // while it is mapped.
        if (is_with_gl()) quietly([&] { device_.end_host_access(*compute_); });
        quietly([&] { device_.finish(); });
        compute_.reset();
        if (!gl::ForgetObjects::active()) glUnmapNamedBuffer(gl_.id());
    }

  private:
    void enter_compute() override { device_.end_host_access(*compute_); }
    void leave_compute() override { device_.begin_host_access(*compute_); }

    compute::Device& device_;
};

/// A buffer on each side, and host memory between them that GL keeps mapped. Drivers pin such
/// memory: both sides copy at the bus's speed, and nobody waits for a single table.
class CopiedMemory final : public SharedMemory {
  public:
    CopiedMemory(compute::Device& device, std::size_t bytes, const Purpose& purpose)
        : SharedMemory(bytes), device_(device), purpose_(purpose) {
        compute_ = device.allocate(bytes);
        gl::allocate(gl_, bytes, nullptr, GL_DYNAMIC_STORAGE_BIT, purpose);
    }
    ~CopiedMemory() override {
        // A copy from there may still run.
        if (!between_.empty()) quietly([&] { device_.finish(); });
    }

  private:
    std::span<std::byte> between(std::size_t bytes) {
        if (bytes > 0 && between_.empty()) {
            mapped_ = gl::Buffer::create();
            between_ = map_for_good(mapped_, size(), GL_CLIENT_STORAGE_BIT, purpose_);
        }
        return between_.first(bytes);
    }
    bool leave_gl() override {
        crossing_ = between(written_by_gl());
        if (!crossing_.empty()) copy(gl_, mapped_);
        return !crossing_.empty();
    }
    void enter_compute() override { device_.begin_upload(*compute_, crossing_); }
    void leave_compute() override {
        crossing_ = between(written_by_compute());
        device_.begin_download(*compute_, crossing_);
    }
    void enter_gl() override {
        if (!crossing_.empty()) copy(mapped_, gl_);
    }
    void copy(const gl::Buffer& from, const gl::Buffer& to) const {
        glCopyNamedBufferSubData(from.id(), to.id(), 0, 0,
                                 static_cast<GLsizeiptr>(crossing_.size()));
    }

    compute::Device& device_;
    const Purpose& purpose_;
    gl::Buffer mapped_;
    std::span<std::byte> between_;  ///< all of mapped_; empty until something is copied
    std::span<std::byte> crossing_; ///< the part that is being copied
};

std::unique_ptr<SharedMemory> make_memory(const Sharing& sharing, std::size_t bytes,
                                          const Purpose& purpose) {
    compute::Device& device = sharing.device();
    return for_purpose(purpose, [&]() -> std::unique_ptr<SharedMemory> {
        switch (sharing.mode()) {
        case SharingMode::gl_sharing: {
            auto* opencl = dynamic_cast<compute::OpenClBackend*>(&device);
            if (opencl == nullptr) {
                throw DeviceError(device.description() +
                                  " has no gl-sharing; use DeviceOptions::interop copy");
            }
            return std::make_unique<GlSharingMemory>(*opencl, bytes, purpose);
        }
        case SharingMode::external_memory:
            return std::make_unique<ExternalMemory>(*sharing.external(), bytes, purpose);
        case SharingMode::host_pointer:
            return std::make_unique<HostPointerMemory>(device, bytes, purpose);
        case SharingMode::copy:
            break;
        }
        return std::make_unique<CopiedMemory>(device, bytes, purpose);
    });
}

} // namespace

std::unique_ptr<SharedMemory> make_shared_memory(const Sharing& sharing, std::size_t bytes,
                                                 const compute::TableName& name) {
    constexpr std::size_t least = 64;
    std::unique_ptr<SharedMemory> memory =
        make_memory(sharing, std::max(bytes, least), name.purpose);
    compute::TableList::add(sharing.device(), memory->compute(), name);
    return memory;
}

} // namespace lineatlas::interop
