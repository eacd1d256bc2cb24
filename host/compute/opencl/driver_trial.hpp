#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lineatlas::compute {

/// What a trial of the OpenCL drivers has shown.
struct DriverTrial {
    /// Working platforms, by their places among all that the loader reports; nothing: not tried.
    std::optional<std::vector<std::size_t>> working;
    std::string cause; ///< why others do not work, for a message; empty if all work
};

/// Tries drivers before they are loaded, because drivers end the process if they lack memory, or
/// the linker that PoCL runs. Under a limit on memory, or with no `ld` in PATH, each driver builds
/// and runs a kernel in a copy of this process. Otherwise, if drivers are `mistrusted`, each lists
/// its devices in a copy. Otherwise nothing is done.
DriverTrial try_drivers(bool mistrusted);

} // namespace lineatlas::compute
