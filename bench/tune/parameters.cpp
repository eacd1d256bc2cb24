#include "parameters.hpp"

namespace lineatlas::bench {

std::vector<Parameter> parameters() {
    constexpr std::uint32_t many = 1U << 20U, fewer = 1U << 17U;
    const auto tiles = [](const compute::Tuning& tuning) { return tuning.scan_tiles; };
    const auto chunks = [](const compute::Tuning& tuning) { return !tuning.scan_tiles; };
    return {
        {"scan_tiles", {0, 1}, scan_rows, "scan/ours", many, nullptr},
        {"scan_chunks", {4, 8, 16, 32, 64, 256, 1024}, scan_rows, "scan/ours", many, chunks},
        {"scan_tile", {32, 64, 128, 256, 512}, scan_rows, "scan/ours", many, tiles},
        {"scan_per_item", {4, 8, 16, 32}, scan_rows, "scan/ours", many, tiles},
        {"local_size",
         {16, 32, 64, 128, 256},
         project_clip_rows,
         "project_clip/ours",
         many,
         nullptr},
        {"segment_block", {1, 4, 16, 64, 512, 4096}, compact_rows, "compact/ours", many, nullptr},
        {"block_local_size", {1, 16, 32, 64, 128}, compact_rows, "compact/ours", many, nullptr},
        {"atlas_vectors", {0, 1}, atlas_rows, "atlas/ours", many, nullptr},
        {"atlas_block", {1, 4, 16, 64, 256, 1024}, atlas_rows, "atlas/ours", many, nullptr},
        {"depth_lanes", {1, 4, 8}, depth_rows, "depth/ours", fewer, nullptr},
        {"depth_tile", {32, 64, 128, 256}, depth_rows, "depth/ours", fewer, nullptr},
        {"depth_each", {0, 1}, depth_rows, "depth/ours", fewer, nullptr},
        {"stroke_pixels", {0, 1}, strokes_rows, "strokes/ours", fewer, nullptr},
        {"halo_lanes", {1, 8, 16}, halo_rows, "halo/ours", fewer, nullptr},
    };
}

} // namespace lineatlas::bench
