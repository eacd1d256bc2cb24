#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "glpasses/interop/connect.hpp"

namespace lineatlas::apps {

/// The option of `lineatlas devices` that runs `answer_probe`.
inline constexpr const char* probe_option = "--probe";

/// Whether something works with a device, and why or why not.
struct Probe {
    bool works = false;
    std::string reason{};
    bool is_known = true; ///< false: it was not found out in time
};

/// Has a new process of this program compile all kernels for the device at `index` of
/// list_opencl_devices(): whatever a driver does, this returns.
Probe probe_kernels(std::size_t index, std::chrono::seconds limit);
/// Has a process compare a frame of the device with that of C++ (compute/opencl/device_trial.hpp).
Probe probe_frames(std::size_t index, std::chrono::seconds limit);
/// Has a process find out which forms of stages frames take by default, and what decides it.
Probe probe_forms(std::size_t index, std::chrono::seconds limit);
/// Has a process try a sharing mode.
Probe probe_mode(std::size_t index, interop::SharingMode mode, std::chrono::seconds limit);

/// Runs in that process: tries what the number `what` stands for and prints the answer.
void answer_probe(std::size_t index, std::size_t what);

} // namespace lineatlas::apps
