#include "tuning.hpp"

#include <algorithm>

namespace lineatlas::compute {
namespace {

// A CPU runs a work-group as a loop on one core: long serial pieces, few work-items.
constexpr Tuning cpu{.scan_tiles = false,
                     .scan_chunks = 16,
                     .longest_chunk = 0xFFFFFFFF,
                     .scan_tile = 64,
                     .scan_per_item = 8,
                     .local_size = 64,
                     .block_local_size = 1,
                     .atlas_block = 256,
                     .atlas_vectors = true,
                     .halo_lanes = 16,
                     .segment_block = 4096,
                     .sample_block = 16384};

// A GPU needs tens of thousands of work-items in flight.
constexpr Tuning gpu{.scan_tiles = true,
                     .scan_chunks = 16,
                     .longest_chunk = 0xFFFFFFFF,
                     .scan_tile = 256,
                     .scan_per_item = 8,
                     .local_size = 64,
                     .block_local_size = 64,
                     .atlas_block = 4,
                     .atlas_vectors = false,
                     .halo_lanes = 1,
                     .segment_block = 4,
                     .sample_block = 16};

} // namespace

Tuning tuning_for(const OpenClDevice& device) {
    const bool is_rusticl = device.platform_name == "rusticl";
    // Its compiler takes a minute for the vectors of a CPU's form.
    Tuning tuning = device.is_cpu && !is_rusticl ? cpu : gpu;
    if (is_rusticl) {
        // Mesa's llvmpipe, which rusticl runs on, leaves the loops of a work-item after 65,535
        // rounds in all (LP_MAX_TGSI_LOOP_ITERATIONS in its gallivm); seen with 22.3.6.
        tuning.longest_chunk = 60'000;
        tuning.segment_block = std::min(tuning.segment_block, 16U);
    }
    return tuning;
}

} // namespace lineatlas::compute
