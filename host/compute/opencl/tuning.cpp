#include "tuning.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "quirks.hpp"
#include "shared/constants.h"
#include "sources/sources.hpp"
#include "tuning_table.hpp"

namespace lineatlas::compute {
namespace {

constexpr std::string_view file_name = "tuning.toml";

/// The table in the user's folder of kernels. Without one there the built-in table counts.
TuningTable user_table() {
    const char* folder = std::getenv("LINEATLAS_KERNEL_DIR");
    if (folder != nullptr) {
        const std::filesystem::path path = std::filesystem::path{folder} / file_name;
        std::error_code ignored;
        if (std::filesystem::exists(path, ignored)) {
            return TuningTable{kernel_source(file_name), path.string()};
        }
    }
    const auto& sources = embedded_kernels();
    const auto own = std::ranges::find(sources, file_name, &EmbeddedSource::name);
    return TuningTable{own->text, "the built-in " + std::string{file_name}};
}

} // namespace

Tuning tuning_for(const OpenClDevice& device) {
    Tuning tuning = user_table().values_for(device);
    tuning.long_atomics = device.has_extension("cl_khr_int64_extended_atomics");
    return within_quirks(tuning, device);
}

GroupLimits group_limits(const cl::Device& device) {
    return {device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>(),
            device.getInfo<CL_DEVICE_LOCAL_MEM_SIZE>()};
}

Tuning within_groups(Tuning tuning, const GroupLimits& limits) {
    const std::size_t in_local_memory = limits.local_memory / sizeof(cl_uint);
    const auto limit = [](std::uint32_t& size, std::size_t largest) {
        size = static_cast<std::uint32_t>(std::min<std::size_t>(size, largest));
    };
    limit(tuning.local_size, limits.items);
    limit(tuning.block_local_size, limits.items);
    limit(tuning.scan_tile, std::bit_floor(std::min(limits.items, in_local_memory)));
    // As in depth.cl: rows of a tile are longer by two vectors, and a texel has a depth and a
    // number.
    const auto depth_tile_size = [&] {
        return 2 * tuning.depth_tile * (tuning.depth_tile + 2 * tuning.depth_lanes);
    };
    while (tuning.depth_tile > LA_TILE && depth_tile_size() > in_local_memory)
        tuning.depth_tile -= LA_TILE;
    return tuning;
}

std::string compiler_options(const Tuning& tuning) {
    const auto define = [](const char* name, std::uint32_t value) {
        return std::string{" -D"} + name + "=" + std::to_string(value);
    };
    return define("SCAN_TILE", tuning.scan_tile) + define("SCAN_PER_ITEM", tuning.scan_per_item) +
           define("DEPTH_LANES", tuning.depth_lanes) + define("DEPTH_TILE", tuning.depth_tile) +
           define("LONG_ATOMICS", tuning.long_atomics ? 1 : 0) +
           define("HALO_LANES", tuning.halo_lanes) + define("FACE_LANES", tuning.face_lanes) +
           define("PROBE_VECTORS", tuning.atlas_vectors ? 1 : 0);
}

} // namespace lineatlas::compute
