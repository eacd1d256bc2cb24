#pragma once

struct _cl_mem;

namespace lineatlas::interop {

/// Memory that GL passes and compute stages use in turn. It belongs to GL when made. `Sharing`
/// (sharing.hpp) passes it to and fro; the object knows which side has it and what must be copied.
class Shared {
  public:
    virtual ~Shared() = default;
    Shared(const Shared&) = delete;
    Shared& operator=(const Shared&) = delete;

  protected:
    Shared() = default;
    bool is_with_gl() const { return with_gl_; }

  private:
    friend class Sharing;
    /// What OpenCL has opened of GL and must acquire and release; null where there is nothing.
    virtual _cl_mem* opened() const { return nullptr; }
    /// Lets GL bring along what compute needs of it; true if it got commands. glFinish comes after.
    virtual bool leave_gl() { return false; }
    /// GL is done (glFinish was called); compute takes over.
    virtual void enter_compute() {}
    /// Submits what must follow the kernels before GL may look; clFinish comes after.
    virtual void leave_compute() {}
    /// Kernels are done; lets GL take the content where that takes a copy.
    virtual void enter_gl() {}

    bool with_gl_ = true;
};

} // namespace lineatlas::interop
