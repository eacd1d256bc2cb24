#include "tuning.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "constants.h"
#include "quirks.hpp"
#include "sources/sources.hpp"
#include "tuning_table.hpp"

namespace lineatlas::compute {
namespace {

constexpr std::string_view file_name = "tuning.toml";

/// A folder of kernels need not have a table: then the built-in one holds.
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
    return within_quirks(user_table().values_for(device), device);
}

Tuning within_groups(Tuning tuning, const cl::Device& device) {
    const std::size_t most = device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
    const std::size_t in_local_memory =
        device.getInfo<CL_DEVICE_LOCAL_MEM_SIZE>() / sizeof(cl_uint);
    const auto limit = [](std::uint32_t& size, std::size_t largest) {
        size = static_cast<std::uint32_t>(std::min<std::size_t>(size, largest));
    };
    limit(tuning.local_size, most);
    limit(tuning.block_local_size, most);
    limit(tuning.scan_tile, std::bit_floor(std::min(most, in_local_memory)));
    // depth.cl: rows of a tile are longer by two vectors, and a texel has a depth and a number.
    const auto depth_tile_size = [&] {
        return 2 * tuning.depth_tile * (tuning.depth_tile + 2 * tuning.depth_lanes);
    };
    while (tuning.depth_tile > LA_TILE && depth_tile_size() > in_local_memory)
        tuning.depth_tile -= LA_TILE;
    return tuning;
}

} // namespace lineatlas::compute
