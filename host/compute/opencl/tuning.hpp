#pragma once

#include <cstdint>

#include "devices.hpp"

namespace lineatlas::compute {

/// How the kernels are launched on a device.
struct Tuning {
    bool scan_tiles;                ///< tiles in local memory instead of serial chunks
    std::uint32_t scan_chunks;      ///< serial chunks per scan, or more so that none is longer
    std::uint32_t longest_chunk;    ///< than this
    std::uint32_t scan_tile;        ///< work-group size of a tile; a power of two
    std::uint32_t scan_per_item;    ///< values per work-item of a tile
    std::uint32_t local_size;       ///< work-group size of kernels with a work-item per element
    std::uint32_t block_local_size; ///< work-group size of kernels with a work-item per block
    std::uint32_t atlas_block;      ///< samples per work-item
    bool atlas_vectors;             ///< all probes of a sample in one vector
    std::uint32_t halo_lanes;       ///< lines tested at a time: 1, 8 or 16
    std::uint32_t segment_block;    ///< segments per work-item of compact_runs
    std::uint32_t sample_block;     ///< samples per work-item of compact_samples
    bool program_cache = false;     ///< built programs are kept in the user's cache
};

Tuning tuning_for(const OpenClDevice& device);

} // namespace lineatlas::compute
