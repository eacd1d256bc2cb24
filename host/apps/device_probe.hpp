#pragma once

#include <chrono>

#include "glpasses/interop/connect.hpp"

namespace lineatlas::apps {

/// The option of `lineatlas devices` that runs `answer_probe`.
inline constexpr const char* probe_option = "--probe";

/// Has a new process of this program try a mode with the device at `index` of
/// list_opencl_devices(): whatever a driver does, this returns.
interop::ModeReport probe_in_child(std::size_t index, interop::SharingMode mode,
                                   std::chrono::seconds limit);

/// The other end, in that process: tries it and prints the answer.
void answer_probe(std::size_t index, std::size_t mode);

} // namespace lineatlas::apps
