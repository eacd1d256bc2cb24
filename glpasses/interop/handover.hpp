#pragma once

#include <initializer_list>
#include <span>

#include "shared_buffer.hpp"

namespace lineatlas::interop {

/// One buffer to pass on, and how much of its content the other side needs: 0 if it will only
/// write.
struct Passed {
    SharedBuffer& buffer;
    std::size_t bytes;
};

/// Passes buffers between GL and compute. The only code that orders the two APIs: without
/// cl_khr_gl_event, waiting for one before the other starts is all that the standards promise
/// (glFinish, not glFlush, and clFinish).
class Handover {
  public:
    explicit Handover(compute::Backend& backend) : backend_(backend) {}

    void to_compute(std::initializer_list<Passed> buffers) {
        to_compute({buffers.begin(), buffers.size()});
    }
    void to_compute(std::span<const Passed> buffers);
    void to_gl(std::initializer_list<Passed> buffers) { to_gl({buffers.begin(), buffers.size()}); }
    void to_gl(std::span<const Passed> buffers);

  private:
    compute::Backend& backend_;
};

} // namespace lineatlas::interop
