#pragma once

#include <cstdint>

#include "devices.hpp"

namespace lineatlas::compute {

/// How the kernels are launched on a device.
struct Tuning {
    bool scan_tiles = false;            ///< tiles in local memory instead of serial chunks
    std::uint32_t scan_chunks = 0;      ///< serial chunks per scan, or more so that none is longer
    std::uint32_t longest_chunk = ~0U;  ///< than this; not in the table, a quirk's
    std::uint32_t scan_tile = 0;        ///< work-group size of a tile; a power of two
    std::uint32_t scan_per_item = 0;    ///< values per work-item of a tile
    std::uint32_t local_size = 0;       ///< work-group size of kernels with a work-item per element
    std::uint32_t block_local_size = 0; ///< work-group size of kernels with a work-item per block
    std::uint32_t atlas_block = 0;      ///< samples per work-item
    bool atlas_vectors = false;         ///< all probes of a sample in one vector
    std::uint32_t halo_lanes = 0;       ///< lines tested at a time: 1, 8 or 16
    std::uint32_t segment_block = 0;    ///< segments per work-item of compact_runs
    std::uint32_t sample_block = 0;     ///< samples per work-item of compact_samples
    bool program_cache = false;         ///< built programs are kept in the user's cache
};

/// What kernels/tuning.toml says of a device, within what its quirks allow. Throws FileError if
/// that is LINEATLAS_KERNEL_DIR's and not right.
Tuning tuning_for(const OpenClDevice& device);

/// `tuning` with no work-group larger than the device takes, and tiles that fit its local memory.
Tuning within_groups(Tuning tuning, const cl::Device& device);

} // namespace lineatlas::compute
