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
    /// The object of GL that OpenCL has opened and must acquire and release; null if there is none.
    virtual _cl_mem* opened() const { return nullptr; }
    /// Lets GL copy the content that compute needs. Returns true if GL got commands. glFinish comes
    /// after.
    virtual bool leave_gl() { return false; }
    /// GL is done (glFinish was called); compute takes over.
    virtual void enter_compute() {}
    /// Submits the commands that must follow the kernels before GL may read. clFinish comes after.
    virtual void leave_compute() {}
    /// Kernels are done. Copies the content to GL if the mode needs a copy.
    virtual void enter_gl() {}

    bool with_gl_ = true;
};

} // namespace lineatlas::interop
