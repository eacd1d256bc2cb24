// pyramid: n texels of depth, in pictures with sides of 2:1 or 1:1.
// Bytes: 4 read per texel, 4 written per tile.

#include <bit>

#include "common.hpp"

namespace lineatlas::bench {
namespace {

using Floats = std::vector<float>;

/// The size of a picture of n pixels. n is a power of two.
glm::ivec2 picture_of(std::uint32_t n) {
    const int bits = std::countr_zero(n);
    return {1 << (bits + 1) / 2, 1 << bits / 2};
}

std::size_t tile_count_of(std::uint32_t n) {
    const glm::ivec2 tiles = compute::tiles_for(picture_of(n));
    return static_cast<std::size_t>(tiles.x) * static_cast<std::size_t>(tiles.y);
}

double bytes_of(std::uint32_t n) {
    return 4.0 * n + 4.0 * static_cast<double>(tile_count_of(n));
}

Floats random_depth(std::uint32_t n) {
    Random random{6};
    Floats depth(n);
    for (float& value : depth) value = random.between(0, 1);
    return depth;
}

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const SharedBuffer depth = to_device(device, random_depth(n));
    const SharedBuffer tiles = device.allocate(tile_count_of(n) * sizeof(float));
    const auto run = [&stages, depth, tiles, n] {
        stages.pyramid(*depth, picture_of(n), *tiles);
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = bytes_of(n), .result = [&device, tiles, n] {
                return read_back<std::uint8_t>(device, *tiles, tile_count_of(n) * sizeof(float));
            }};
}

} // namespace

Rows pyramid_rows(const Devices& devices) {
    Rows rows = own_rows(devices, "pyramid", prepare);
    rows.push_back(copy_row(devices, "pyramid", bytes_of));
    return rows;
}

} // namespace lineatlas::bench
