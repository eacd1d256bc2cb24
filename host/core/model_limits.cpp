#include "model_limits.hpp"

#include <string>

#include "limits.hpp"

namespace lineatlas {
namespace {

constexpr std::uint64_t most_drawn = 0x7FFFFFFF; // GL's draws count in 31 bits

void check(std::uint64_t count, std::uint64_t most, const char* what, const Purpose& purpose) {
    if (count <= most) return;
    throw DeviceError(beyond_limit(purpose, std::to_string(count) + " " + what,
                                   "GL and kernels count to " + std::to_string(most)));
}

} // namespace

void check_counts(const ModelCounts& counts) {
    check(counts.vertices, most_drawn, "vertices", purpose::model);
    check(counts.triangles, most_drawn / 3, "triangles", purpose::model);
    check(counts.segments, most_drawn / 2, "line segments", purpose::segments);
}

} // namespace lineatlas
