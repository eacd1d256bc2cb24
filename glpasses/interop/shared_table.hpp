#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include <epoxy/gl.h>

#include "shared_memory.hpp"
#include "sharing.hpp"

namespace lineatlas::interop {

/// A table that kernels and GL passes use in turn. The table goes to the side that asks for it,
/// with everything that the other side has written since. Each side asks whenever it is about to
/// use the table.
class SharedTable {
  public:
    /// Without any room. `sharing` and `name` must outlive it.
    SharedTable(Sharing& sharing, const compute::TableName& name)
        : sharing_(&sharing), name_(&name) {}

    /// Makes room for `bytes` bytes, the size of the table from here on. Returns true if the table
    /// is new and its content is gone. Throws DeviceError when memory runs out or the mode does not
    /// work with the device.
    bool fit(std::size_t bytes) {
        const bool is_new = !memory_ || memory_->size() < bytes;
        if (is_new) {
            memory_.reset(); // another may not fit beside it
            memory_ = make_shared_memory(*sharing_, bytes, *name_);
            sharing_->gl_works(); // GL has made its part of the memory
        }
        memory_->used = bytes;
        return is_new;
    }
    void release() { memory_.reset(); }
    explicit operator bool() const { return memory_ != nullptr; }
    std::size_t room() const { return memory_ ? memory_->size() : 0; } ///< bytes

    /// Only the first `bytes` bytes mean something.
    void set_size(std::size_t bytes) { memory_->used = bytes; }

    /// The table for kernels. Their launches tell what they write.
    compute::Buffer& compute() {
        sharing_->to_compute(*memory_);
        return memory_->compute();
    }
    /// Writes the first bytes, as a kernel would. Only these mean something then.
    void upload(std::span<const std::byte> data) {
        if (!data.empty()) sharing_->device().upload(compute(), data);
        memory_->used = data.size();
        memory_->host_wrote = true;
    }
    /// The table for a pass that reads it.
    GLuint gl() {
        sharing_->to_gl(*memory_);
        sharing_->gl_works();
        return memory_->gl();
    }
    /// The table for a pass that writes to it.
    GLuint gl_to_write() {
        const GLuint name = gl();
        memory_->gl_wrote = true;
        return name;
    }

  private:
    friend class Sharing;

    Sharing* sharing_;
    const compute::TableName* name_;
    std::unique_ptr<SharedMemory> memory_;
};

} // namespace lineatlas::interop
