#pragma once

#include <string>

namespace lineatlas::compute {

/// Gives PoCL a private folder under the temporary directory for its cache (POCL_CACHE_DIR), if it
/// cannot write to the user's home or there is no home. PoCL has no device without a cache, and
/// without a home it would use a folder that all users share. Call it before the drivers are
/// loaded. Returns the reason, for a message, if there is no such folder; empty if all is well.
std::string give_pocl_a_cache();

} // namespace lineatlas::compute
