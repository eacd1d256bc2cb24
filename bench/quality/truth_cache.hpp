#pragma once

#include <filesystem>

#include "truth.hpp"

namespace lineatlas::bench {

/// $XDG_CACHE_HOME/lineatlas-truth, or ~/.cache/lineatlas-truth.
std::filesystem::path truth_cache_folder();

/// `oracle.visibility()`, from `folder` if it was computed before for exactly this input. A cache
/// that can't be read or written only costs time; files may be deleted at will.
std::vector<float> cached_visibility(const Oracle& oracle, const ClippedLines& lines,
                                     const Camera& camera, const TruthOptions& options,
                                     const std::filesystem::path& folder);

} // namespace lineatlas::bench
