#pragma once

#include <nlohmann/json.hpp>

#include "lineatlas/kernel_profile.hpp"

namespace lineatlas {

/// The figures of a kernel by their keys (docs/profiling.md), without its stage and its name; null
/// if unknown.
nlohmann::ordered_json figures_of(const KernelTime& kernel);

/// profile_trace(), each launch of `kernels` with their figures.
std::string trace_of(std::span<const FrameProfile> frames, std::span<const KernelTime> kernels,
                     const std::string& description);

} // namespace lineatlas
