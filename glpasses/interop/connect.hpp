#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compute/opencl/devices.hpp"
#include "compute/stages/stages.hpp"
#include "lineatlas/device_options.hpp"
#include "sharing.hpp"

namespace lineatlas::interop {

/// Whether a sharing mode works with a device and the current GL context.
struct ModeReport {
    SharingMode mode;
    bool works;
    std::string reason; ///< why the mode works, or why not
};

/// Tries a mode with a round trip. Needs a current GL context. A faulty driver may crash or hang in
/// the call, so `lineatlas devices` calls it in a child process.
ModeReport probe_mode(const compute::OpenClDevice& device, SharingMode mode);

/// What the user chose, and what has failed since.
struct Choice {
    DeviceOptions options{};
    /// OpenCL devices that are not taken, and the reason for a message.
    std::vector<compute::OpenClDevice> without{};
    std::string why_without{};
};

/// The stages on a device, and how it shares tables with the current GL context.
struct Connection {
    std::unique_ptr<compute::Device> device;
    std::unique_ptr<compute::Stages> stages; ///< on it
    std::unique_ptr<Sharing> sharing;        ///< of it
    std::string note{}; ///< one line for the user if the device is not the one to be expected
    /// The choice without this device, for connect_next(); none if the user chose the device.
    std::optional<Choice> otherwise{};
};

/// The device to use by default: the first that can share with the current GL context, else one
/// that shares memory with it, else a GPU, else any. `devices` must not be empty.
std::size_t default_device(const std::vector<compute::OpenClDevice>& devices);

/// Chooses device and mode, as far as the options leave them open, and connects. Throws UsageError
/// for an unknown device or mode, or a mode in which devices cannot be compared. Throws DeviceError
/// if there is no OpenCL or the chosen mode does not work.
Connection connect(const DeviceOptions& options);

/// Connects to the next device after the device of `failed` did not build a kernel. `failed` must
/// have Connection::otherwise. `why`: the reason, for a message. Throws as connect() does.
Connection connect_next(const Connection& failed, const std::string& why);

} // namespace lineatlas::interop
