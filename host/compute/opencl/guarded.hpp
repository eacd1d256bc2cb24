#pragma once

#include <string>
#include <string_view>

#include "devices.hpp"
#include "lineatlas/error.hpp"
#include "status.hpp"

namespace lineatlas::compute {

/// Runs `action`; an OpenCL error becomes a DeviceError that says where it came from. Allocates
/// nothing unless there is an error, because it runs in every frame.
template <class Action>
auto guarded(const OpenClDevice& device, std::string_view doing, Action&& action,
             std::string_view what = {}) -> decltype(action()) {
    try {
        return action();
    } catch (const cl::Error& error) {
        throw DeviceError(device.description() + ": " + std::string{doing} + std::string{what} +
                          " failed: " + error.what() + " returned " + name_of(error.err()) +
                          advice_on(error.err()));
    }
}

} // namespace lineatlas::compute
