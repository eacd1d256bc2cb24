#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "gl_events.hpp"
#include "shared_buffer.hpp"

namespace lineatlas::interop {

/// Passes what is shared between GL and compute. The only code that orders the two APIs: without
/// cl_khr_gl_event, waiting for one before the other starts is all that the standards promise
/// (glFinish, not glFlush, and clFinish). With it, what OpenCL has opened needs neither wait.
/// The GL context must be current on the calling thread.
class Handover {
  public:
    explicit Handover(compute::Device& device);

    /// Nothing is done for what is there already, nor for null.
    void to_compute(std::initializer_list<Shared*> shared) {
        to_compute(std::span{shared.begin(), shared.size()});
    }
    void to_compute(std::span<Shared* const> shared);
    void to_gl(std::initializer_list<Shared*> shared) {
        to_gl(std::span{shared.begin(), shared.size()});
    }
    void to_gl(std::span<Shared* const> shared);

  private:
    /// Finds what of `shared` is to go; returns whether all of it is opened by OpenCL and ordered
    /// by events, so that nobody has to wait.
    bool find_going(std::span<Shared* const> shared, bool to_gl);
    void acquire();
    void release();

    compute::Device& device_;
    compute::OpenClBackend* opencl_; ///< null for other devices, which open nothing
    GlEvents events_;
    std::vector<Shared*> going_;   ///< kept for their memory
    std::vector<_cl_mem*> opened_; ///< of them
};

} // namespace lineatlas::interop
