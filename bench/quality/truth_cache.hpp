#pragma once

#include <filesystem>

#include "truth.hpp"

namespace lineatlas::bench {

/// $XDG_CACHE_HOME/lineatlas-truth, or ~/.cache/lineatlas-truth.
std::filesystem::path truth_cache_folder();

/// The result of `oracle.visibility()`, from `folder` if it has the result for exactly this input.
/// A cache that cannot be read or written only costs time. Its files may be deleted at any time.
std::vector<float> cached_visibility(const Oracle& oracle, const ClippedLines& lines,
                                     const Camera& camera, const TruthOptions& options,
                                     const std::filesystem::path& folder);

} // namespace lineatlas::bench
