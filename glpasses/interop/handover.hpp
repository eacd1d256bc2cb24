#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "gl_events.hpp"
#include "shared_buffer.hpp"

namespace lineatlas::interop {

/// One thing to pass on, and how much of its content the other side needs: 0 if it will only
/// write. What is the same memory on both sides is passed whole.
struct Passed {
    Shared& shared;
    std::size_t bytes;
};

/// Passes what is shared between GL and compute. The only code that orders the two APIs: without
/// cl_khr_gl_event, waiting for one before the other starts is all that the standards promise
/// (glFinish, not glFlush, and clFinish). With it, what OpenCL has opened needs neither wait.
/// The GL context must be current on the calling thread.
class Handover {
  public:
    explicit Handover(compute::Backend& backend);

    void to_compute(std::initializer_list<Passed> passed) {
        to_compute({passed.begin(), passed.size()});
    }
    void to_compute(std::span<const Passed> passed);
    void to_gl(std::initializer_list<Passed> passed) { to_gl({passed.begin(), passed.size()}); }
    void to_gl(std::span<const Passed> passed);

  private:
    static std::vector<_cl_mem*> opened_of(std::span<const Passed> passed);
    void acquire(std::span<_cl_mem* const> opened);
    void release(std::span<_cl_mem* const> opened);

    compute::Backend& backend_;
    compute::OpenClBackend* opencl_; ///< null for other backends, which open nothing
    GlEvents events_;
};

} // namespace lineatlas::interop
