#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lineatlas::compute {

/// What a trial of the OpenCL drivers has shown.
struct DriverTrial {
    /// Platforms, by their places among all that the loader reports; nothing: not tried.
    std::optional<std::vector<std::size_t>> working;
    std::string cause; ///< why others do not, for a message; empty if all do that were found
};

/// Drivers end the process when they lack memory, or the linker that PoCL runs. Where that is to be
/// feared, under a limit on memory or with no `ld` in PATH, they are tried in a copy of this
/// process first: each builds and runs a kernel. Elsewhere each says what devices it has, in a
/// copy, if they are `mistrusted`; else nothing is done. Call before they are loaded.
DriverTrial try_drivers(bool mistrusted);

} // namespace lineatlas::compute
