#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "lineatlas/compute_device.hpp"

namespace lineatlas::compute {

/// A device that runs every kernel twice, on `first` and with the same input on a second device,
/// and compares what they write: integers bit by bit, floats within 1e-5 relative. Its results are
/// those of `first`. The first kernel that differs throws MismatchError with the first element that
/// differs. Both devices run the launches that suit `first`, except scans in tiles, which not every
/// device can run. It is meant for finding errors: every table is copied for every kernel.
class ComparingDevice : public Device {
  public:
    struct Summary {
        std::uint64_t kernels = 0;  ///< launches that were compared
        std::uint64_t elements = 0; ///< elements of the tables that these launches write
    };
    virtual Summary summary() const = 0;
};

/// Compares the stages from the first up to `until` in the order of a frame; empty: all. Throws
/// UsageError if there is no such stage.
std::unique_ptr<ComparingDevice> make_comparing_device(std::unique_ptr<Device> first,
                                                       std::unique_ptr<Device> second,
                                                       std::string_view until = {});

} // namespace lineatlas::compute
