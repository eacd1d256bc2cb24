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
    std::string_view remedy;    ///< the way this project deals with it, and where
    std::string_view seen_with; ///< versions
    std::string_view link;
};

/// All known quirks, for people to read. Remedies that are code stand below.
std::span<const Quirk> known_quirks();

/// `tuning` changed so that no loop is so long that the device would leave it early.
Tuning within_quirks(Tuning tuning, const OpenClDevice& device);

/// Options for the device's compiler, each with a blank behind it.
std::string quirk_options(const OpenClDevice& device);

/// Whether a process that also draws by Mesa's llvmpipe crashes.
bool collides_with_llvmpipe(const OpenClDevice& device);

/// Whether the driver ends the process for a program binary that it has not written. Such a device
/// must get only its own, whole binaries.
bool aborts_on_foreign_binary(const OpenClDevice& device);

} // namespace lineatlas::compute
