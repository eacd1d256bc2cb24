#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include <epoxy/gl.h>

#include "compute/stages/stages.hpp"
#include "core/limits.hpp"
#include "glpasses/objects.hpp"
#include "sharing.hpp"

namespace lineatlas::interop {

/// The memory of a SharedTable, on both sides.
class SharedMemory : public Shared {
  public:
    std::size_t size() const { return size_; }       ///< bytes
    GLuint gl() const { return gl_.id(); }           ///< for GL, while GL has it
    compute::Buffer& compute() { return *compute_; } ///< for stages, while compute has it

    // The content that is copied if each side has memory of its own: the first `used` bytes, once
    // they have been written. Launches count what kernels write.
    std::size_t used = 0;
    bool gl_wrote = false, host_wrote = false;

  protected:
    explicit SharedMemory(std::size_t size) : size_(size) {}
    /// Bytes that GL has written since compute had the memory.
    std::size_t written_by_gl() { return std::exchange(gl_wrote, false) ? used : 0; }
    /// Bytes that kernels or the host have written since GL had the memory.
    std::size_t written_by_compute() {
        const bool kernels = std::exchange(seen_, compute().writes()) != compute().writes();
        return std::exchange(host_wrote, false) || kernels ? used : 0;
    }

    gl::Buffer gl_ = gl::Buffer::create();
    std::unique_ptr<compute::Buffer> compute_; ///< made by the mode

  private:
    std::size_t size_;
    std::uint64_t seen_ = 0; ///< compute::Buffer::writes() when GL got the memory
};

/// Throws DeviceError when memory runs out or the mode does not work with this device.
std::unique_ptr<SharedMemory> make_shared_memory(const Sharing& sharing, std::size_t bytes,
                                                 const compute::TableName& name);

} // namespace lineatlas::interop
