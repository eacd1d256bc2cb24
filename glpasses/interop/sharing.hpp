#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "compute/stages/stages.hpp"
#include "gl_events.hpp"
#include "shared.hpp"

namespace lineatlas::interop {

/// How a table is seen by both GL and the compute device.
enum class SharingMode {
    gl_sharing,   ///< one GL buffer, opened by OpenCL (cl_khr_gl_sharing): no copy
    host_pointer, ///< one piece of host memory, persistently mapped by GL and wrapped by compute:
                  ///< no copy
    copy,         ///< one buffer on each side; content is copied over at each hand-over
};

std::string_view name_of(SharingMode mode); ///< "gl-sharing", "host-pointer", "copy"

class SharedTable;

/// A compute device and the GL context of this thread, between which tables go to and fro. The only
/// code that orders the two APIs: without cl_khr_gl_event, waiting for one before the other starts
/// is all that the standards promise (glFinish, not glFlush, and clFinish). With it, what OpenCL
/// has opened needs neither wait.
class Sharing {
  public:
    /// `device` must outlive it.
    Sharing(compute::Device& device, SharingMode mode);
    Sharing(const Sharing&) = delete;
    Sharing& operator=(const Sharing&) = delete;

    compute::Device& device() const { return device_; }
    SharingMode mode() const { return mode_; }

    /// GL gets commands: before it is done with them, compute may take nothing that it had.
    void gl_works() { gl_works_ = true; }

    // Nothing is done for what is there already.
    void to_compute(Shared& one);
    void to_gl(Shared& one);
    /// One wait for all: a table goes by itself when GL asks for it, but a pass that reads several
    /// would wait for each. Tables without room are passed over.
    void to_gl(std::initializer_list<SharedTable*> tables);

    /// Told when something is handed over; not of the end where that failed.
    class Timer {
      public:
        virtual void begin_handover() = 0;
        virtual void end_handover() = 0;

      protected:
        ~Timer() = default;
    };
    /// Null: nobody. It must be here until another is set.
    void time_by(Timer* timer) { timer_ = timer; }

  private:
    void acquire(_cl_mem* object);
    void pass_to_gl();
    void release();

    compute::Device& device_;
    SharingMode mode_;
    compute::OpenClBackend* opencl_; ///< null for other devices, which open nothing
    GlEvents events_;
    bool gl_works_ = true; ///< since the last glFinish
    Timer* timer_ = nullptr;
    std::vector<Shared*> going_;   ///< kept for their memory
    std::vector<_cl_mem*> opened_; ///< of them
};

} // namespace lineatlas::interop
