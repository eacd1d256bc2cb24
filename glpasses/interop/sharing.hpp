#pragma once

#include <array>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compute/stages/stages.hpp"
#include "external_objects.hpp"
#include "shared.hpp"

namespace lineatlas::interop {

/// How a table is seen by both GL and the compute device.
enum class SharingMode {
    gl_sharing,      ///< one GL buffer, opened by OpenCL (cl_khr_gl_sharing): no copy
    external_memory, ///< memory of a Vulkan device, imported by GL and by OpenCL
                     ///< (cl_khr_external_memory): no copy
    host_pointer, ///< one piece of host memory, persistently mapped by GL and wrapped by compute:
                  ///< no copy
    copy,         ///< one buffer on each side; content is copied over at each hand-over
};

/// All modes, best first.
inline constexpr std::array all_modes{SharingMode::gl_sharing, SharingMode::external_memory,
                                      SharingMode::host_pointer, SharingMode::copy};

std::string_view name_of(SharingMode mode);                ///< "gl-sharing", "copy" and so on
std::optional<SharingMode> mode_of(std::string_view name); ///< none: there is no such mode
std::string mode_names();                                  ///< "gl-sharing, ..., copy"

/// Whether one device alone can have a table: comparing two takes another mode.
constexpr bool is_for_one_device(SharingMode mode) {
    return mode == SharingMode::gl_sharing || mode == SharingMode::external_memory;
}

class SharedTable;

/// A compute device and the GL context of this thread, between which tables go to and fro. The only
/// code that orders the two APIs: without cl_khr_gl_event, waiting for one before the other starts
/// is all that the standards promise (glFinish, not glFlush, and clFinish). With it, what OpenCL
/// has opened needs neither wait.
class Sharing {
  public:
    /// `device` must outlive it. Throws DeviceError where external_memory can't be.
    Sharing(compute::Device& device, SharingMode mode);
    Sharing(const Sharing&) = delete;
    Sharing& operator=(const Sharing&) = delete;

    compute::Device& device() const { return device_; }
    SharingMode mode() const { return mode_; }
    /// What opens the memory of SharingMode::external_memory; null in other modes.
    const ExternalObjects* external() const {
        return dynamic_cast<const ExternalObjects*>(objects_.get());
    }

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
    void pass_to_gl();

    compute::Device& device_;
    SharingMode mode_;
    std::unique_ptr<OpenedObjects> objects_; ///< null where OpenCL opens nothing
    bool gl_works_ = true;                   ///< since the last glFinish
    Timer* timer_ = nullptr;
    std::vector<Shared*> going_;   ///< kept for their memory
    std::vector<_cl_mem*> opened_; ///< of them
};

} // namespace lineatlas::interop
