#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include <epoxy/gl.h>

#include "compute/stages/stages.hpp"
#include "core/limits.hpp"
#include "shared.hpp"

namespace lineatlas::interop {

/// How a buffer is seen by both GL and the compute device.
enum class SharingMode {
    gl_sharing,   ///< one GL buffer, opened by OpenCL (cl_khr_gl_sharing): no copy
    host_pointer, ///< one piece of host memory, persistently mapped by GL and wrapped by compute:
                  ///< no copy
    copy,         ///< one buffer on each side; content is copied over at each hand-over
};

std::string_view name_of(SharingMode mode); ///< "gl-sharing", "host-pointer", "copy"

/// A buffer that GL passes and compute stages use in turn.
class SharedBuffer : public Shared {
  public:
    std::size_t size() const { return size_; } ///< bytes
    virtual GLuint gl() const = 0;             ///< for GL, while GL has it
    virtual compute::Buffer& compute() = 0;    ///< for stages, while compute has it

  protected:
    explicit SharedBuffer(std::size_t size) : size_(size) {}

  private:
    std::size_t size_;
};

/// Throws DeviceError when memory runs out or the mode does not work with this device.
std::unique_ptr<SharedBuffer> make_shared_buffer(compute::Device& device, SharingMode mode,
                                                 std::size_t bytes,
                                                 const Purpose& purpose = purpose::scratch);

} // namespace lineatlas::interop
