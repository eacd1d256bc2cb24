#pragma once

#include <cstdint>

namespace lineatlas {

/// The numbers of vertices, triangles and the like in a model.
struct ModelCounts {
    std::uint64_t vertices, triangles, segments;
};

/// Throws DeviceError for a model with more than kernels and GL can count.
void check_counts(const ModelCounts& counts);

} // namespace lineatlas
