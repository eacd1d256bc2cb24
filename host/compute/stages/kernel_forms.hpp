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
/// other sizes of work-groups.
struct KernelForm {
    const Kernel* kernel;
    std::uint32_t group; ///< Launch::group
    bool per_element;    ///< has a work-item per element of a table, so there may be very many
};

/// The kernels of these stages that a frame launches if it takes `probes` per axis (1 to 4) and is
/// drawn whole, in the order of all_kernels().
std::vector<KernelForm> kernel_forms(std::span<const std::string_view> stages, std::uint32_t probes,
                                     const Tuning& tuning);

/// Launches kernels with nothing to do, so that they are built before they are needed.
class IdleLaunches {
  public:
    /// `device` must outlive it.
    explicit IdleLaunches(Device& device);

    /// Launches a kernel and waits. `many`: kernels per element get the form for `many_items`
    /// work-items and more.
    void launch(const KernelForm& form, bool many = false);

    /// The number of work-items from which on PoCL builds a kernel once more.
    static constexpr std::uint32_t many_items = 1U << 16U;

  private:
    Device& device_;
    std::array<std::unique_ptr<Buffer>, most_tables> tables_; ///< of zeros
};

} // namespace lineatlas::compute
