#pragma once

#include <string>

namespace lineatlas::compute {

/// PoCL has no device unless it can write its cache, which lies in the user's home; without a home
/// it takes a folder that all users share. In both cases this tells PoCL (POCL_CACHE_DIR) to use a
/// private folder under the temporary directory. Call it before the drivers are loaded. Returns why
/// there is no such folder, for a message; empty if all is well.
std::string give_pocl_a_cache();

} // namespace lineatlas::compute
