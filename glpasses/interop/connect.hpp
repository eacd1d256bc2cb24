#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compute/opencl/devices.hpp"
#include "compute/stages/stages.hpp"
#include "sharing.hpp"

namespace lineatlas::interop {

/// Whether a sharing mode works with a device and the current GL context.
struct ModeReport {
    SharingMode mode;
    bool works;
    std::string reason; ///< why it does, or why not
};

/// Tries a mode with a round trip. Needs a current GL context. A driver that does not keep its
/// word may crash or hang in here: `lineatlas devices` calls it in a child process.
ModeReport probe_mode(const compute::OpenClDevice& device, SharingMode mode);

/// What the user chose; empty means: find the best.
struct ConnectOptions {
    /// One of compute::device_kinds(); empty: OpenCL, else C++ where no driver works.
    std::string kind{};
    std::string device{}; ///< "opencl:<platform>[:<device>]"
    std::optional<SharingMode> mode{};
    /// A device that every kernel runs on too, to be compared, and the last stage for which that is
    /// so (compare/comparing_device.hpp); empty: none, and all.
    std::string compare_with{}, compare_until{};
    bool one_picture = false; ///< DeviceOptions::one_picture
    /// OpenCL devices that are not taken, and why, for a message.
    std::vector<compute::OpenClDevice> without{};
    std::string why_without{};
};

/// The stages on a device, and how it shares tables with the current GL context.
struct Connection {
    std::unique_ptr<compute::Device> device;
    std::unique_ptr<compute::Stages> stages; ///< on it
    std::unique_ptr<Sharing> sharing;        ///< of it
    std::string note{}; ///< one line for the user where the device is not what he may expect
    /// Where the user did not choose the device: what leaves it out, for connect_next().
    std::optional<ConnectOptions> otherwise{};
};

/// Of the devices, the one to use by default: the first that can share with the current GL context,
/// else one that shares memory with it, else a GPU, else any. `devices` must not be empty.
std::size_t default_device(const std::vector<compute::OpenClDevice>& devices);

/// Chooses device and mode and connects. Throws UsageError for an unknown one and
/// DeviceError when there is no OpenCL or the mode asked for doesn't work.
Connection connect(const ConnectOptions& options);

/// Connects to the next device, since that of `failed`, which has Connection::otherwise, did not
/// build a kernel: `why`. Throws as connect().
Connection connect_next(const Connection& failed, const std::string& why);

} // namespace lineatlas::interop
