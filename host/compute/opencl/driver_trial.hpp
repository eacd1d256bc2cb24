#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lineatlas::compute {

/// What a trial of the OpenCL drivers has shown.
struct DriverTrial {
    std::optional<std::vector<std::string>> working; ///< platforms, by name; nothing: not tried
    std::string cause; ///< why others do not, for a message; empty if all do that were found
};

/// Drivers end the process when they lack memory, or the linker that PoCL runs. Where that is to be
/// feared, under a limit on memory or with no `ld` in PATH, they are tried in a copy of this
/// process first: each builds and runs a kernel. Elsewhere nothing is done. Call before they are
/// loaded.
DriverTrial try_drivers();

} // namespace lineatlas::compute
