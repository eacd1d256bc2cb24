#pragma once

#include <string>

#include "devices.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas::compute {

/// Runs `action`; an OpenCL error becomes a DeviceError that says where it came from.
template <class Action>
auto guarded(const OpenClDevice& device, const std::string& doing, Action&& action)
    -> decltype(action()) {
    try {
        return action();
    } catch (const cl::Error& error) {
        throw DeviceError(device.description() + ": " + doing + " failed: " + error.what() +
                          " returned " + std::to_string(error.err()));
    }
}

} // namespace lineatlas::compute
