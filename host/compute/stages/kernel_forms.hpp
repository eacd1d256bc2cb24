#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "compute/kernel_bytes.hpp"
#include "lineatlas/compute_device.hpp"

namespace lineatlas::compute {

/// A kernel in the form in which Stages launches it on a device. Drivers build another form for
/// other work-groups.
struct KernelForm {
    const Kernel* kernel;
    std::uint32_t group; ///< Launch::group
    bool per_element;    ///< has a work-item per element of a table: there may be very many
};

/// Of all kernels of these stages, those that a frame launches that takes `probes` per axis (1 to
/// 4) and is drawn whole, in the order of all_kernels().
std::vector<KernelForm> kernel_forms(std::span<const std::string_view> stages, std::uint32_t probes,
                                     const Tuning& tuning);

/// Launches kernels with nothing to do, so that they are built before there is.
class IdleLaunches {
  public:
    /// `device` must outlive it.
    explicit IdleLaunches(Device& device);

    /// Waits. `many`: for `many_items` work-items and more, of kernels per element.
    void launch(const KernelForm& form, bool many = false);

    /// From so many on PoCL builds a kernel once more.
    static constexpr std::uint32_t many_items = 1U << 16U;

  private:
    Device& device_;
    std::array<std::unique_ptr<Buffer>, most_tables> tables_; ///< of zeros
};

} // namespace lineatlas::compute
