#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tuning.hpp"

namespace lineatlas::compute {

/// Unexpected behaviour of an OpenCL implementation.
struct Quirk {
    std::string_view platform; ///< its name, or a part of it
    std::string_view what;
    std::string_view remedy;    ///< what this project does about it, and where
    std::string_view seen_with; ///< versions
    std::string_view link;
};

/// All that are known, for people to read; the remedies that are code stand below.
std::span<const Quirk> known_quirks();

/// `tuning` with no loop so long that the device would leave it early.
Tuning within_quirks(Tuning tuning, const OpenClDevice& device);

/// Options for its compiler, each with a blank behind it.
std::string quirk_options(const OpenClDevice& device);

/// Whether a process that draws by Mesa's llvmpipe, too, crashes.
bool collides_with_llvmpipe(const OpenClDevice& device);

/// Whether a program binary that the driver didn't write ends the process instead of an error.
/// Such a device must be given only binaries that are known to be whole and its own.
bool aborts_on_foreign_binary(const OpenClDevice& device);

} // namespace lineatlas::compute
