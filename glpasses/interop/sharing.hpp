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

/// Whether only one device can have a table in this mode. Comparing two devices takes another mode.
constexpr bool is_for_one_device(SharingMode mode) {
    return mode == SharingMode::gl_sharing || mode == SharingMode::external_memory;
}

class SharedTable;

/// Passes tables between a compute device and the GL context of this thread. No other code orders
/// the two APIs. Without cl_khr_gl_event the standards promise an order only if the host waits for
/// one API before the other starts (glFinish, not glFlush, and clFinish). With it, objects that
/// OpenCL has opened need neither wait.
class Sharing {
  public:
    /// `device` must outlive it. Throws DeviceError if external_memory does not work.
    Sharing(compute::Device& device, SharingMode mode);
    Sharing(const Sharing&) = delete;
    Sharing& operator=(const Sharing&) = delete;

    compute::Device& device() const { return device_; }
    SharingMode mode() const { return mode_; }
    /// What opens the memory of SharingMode::external_memory; null in other modes.
    const ExternalObjects* external() const {
        return dynamic_cast<const ExternalObjects*>(objects_.get());
    }

    /// Says that GL gets commands. Compute may not take a table from GL before GL is done with
    /// them.
    void gl_works() { gl_works_ = true; }

    // These do nothing for a table that is on that side already.
    void to_compute(Shared& one);
    void to_gl(Shared& one);
    /// Passes several tables to GL with one wait. SharedTable::gl() passes one table, so a pass
    /// that reads several would wait for each. Tables without room are skipped.
    void to_gl(std::initializer_list<SharedTable*> tables);

    /// Is told when a hand-over begins and ends; not of the end if it fails.
    class Timer {
      public:
        virtual void begin_handover() = 0;
        virtual void end_handover() = 0;

      protected:
        ~Timer() = default;
    };
    /// Sets the timer, or none with null. It must live until another is set.
    void time_by(Timer* timer) { timer_ = timer; }

  private:
    void pass_to_gl();

    compute::Device& device_;
    SharingMode mode_;
    std::unique_ptr<OpenedObjects> objects_; ///< null if OpenCL opens nothing
    bool gl_works_ = true;                   ///< GL got commands since the last glFinish
    Timer* timer_ = nullptr;
    std::vector<Shared*> going_;   ///< kept for their memory
    std::vector<_cl_mem*> opened_; ///< the opened objects of `going_`
};

} // namespace lineatlas::interop
