#pragma once

#include <cstddef>

struct _cl_mem;

namespace lineatlas::interop {

/// What GL passes and compute stages use in turn. It belongs to GL when made; `Handover`
/// (handover.hpp) passes it to and fro, and it knows whose it is and what must come along.
class Shared {
  public:
    virtual ~Shared() = default;
    Shared(const Shared&) = delete;
    Shared& operator=(const Shared&) = delete;

    /// The side that has it has written its first `bytes` bytes, or a part of them: what the other
    /// side must see when it gets it. Forgotten once passed on.
    void wrote(std::size_t bytes) { written_ = bytes; }

  protected:
    Shared() = default;

  private:
    friend class Handover;
    /// What OpenCL has opened of GL and must acquire and release; null where there is nothing.
    virtual _cl_mem* opened() const { return nullptr; }
    /// GL is done (glFinish was called); compute takes over the first `bytes` bytes.
    virtual void enter_compute(std::size_t /*bytes*/) {}
    /// Submits what must follow the kernels before GL may look; clFinish comes after.
    virtual void leave_compute(std::size_t /*bytes*/) {}
    /// Kernels are done; brings the content to GL where that takes a copy.
    virtual void enter_gl(std::size_t /*bytes*/) {}

    bool with_gl_ = true;
    std::size_t written_ = 0;
};

} // namespace lineatlas::interop
