// pyramid: n texels of depth, in pictures of one to two or one to one.
// Bytes: 4 read per texel, 4 written per tile.

#include <bit>

#include <tbb/parallel_for.h>

#include "common.hpp"
#include "compute/reference/stages.hpp"

namespace lineatlas::bench {
namespace {

using Floats = std::vector<float>;

/// n is a power of two.
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

Floats expected_tiles(const Floats& depth) {
    const auto n = static_cast<std::uint32_t>(depth.size());
    Floats tiles(tile_count_of(n));
    compute::reference::pyramid(depth, picture_of(n), tiles);
    return tiles;
}

Job prepare(compute::Backend& backend, std::uint32_t n) {
    const Floats values = random_depth(n);
    const SharedBuffer depth = to_device(backend, values);
    const SharedBuffer tiles = backend.allocate(tile_count_of(n) * sizeof(float));
    const auto run = [&backend, depth, tiles, n] {
        backend.pyramid({.depth = *depth, .depth_size = picture_of(n), .tiles = *tiles});
        backend.finish();
    };
    run();
    require(read_back<float>(backend, *tiles, tile_count_of(n)) == expected_tiles(values),
            "pyramid");
    return {.run = run, .bytes = bytes_of(n)};
}

/// The plain C++ for a row of tiles at a time.
Job prepare_tbb(std::uint32_t n) {
    const auto depth = std::make_shared<Floats>(random_depth(n));
    const auto tiles = std::make_shared<Floats>(tile_count_of(n));
    const glm::ivec2 size = picture_of(n), tile_count = compute::tiles_for(size);
    const auto run = [depth, tiles, size, tile_count] {
        const auto texels = static_cast<std::size_t>(size.x) * LA_TILE; // of a row of tiles
        const auto width = static_cast<std::size_t>(tile_count.x);
        tbb::parallel_for(
            std::size_t{0}, static_cast<std::size_t>(tile_count.y), [&](std::size_t y) {
                compute::reference::pyramid(std::span{*depth}.subspan(y * texels, texels),
                                            {size.x, LA_TILE},
                                            std::span{*tiles}.subspan(y * width, width));
            });
    };
    run();
    require(*tiles == expected_tiles(*depth), "pyramid/tbb");
    return {.run = run, .bytes = bytes_of(n)};
}

} // namespace

Rows pyramid_rows(const Backends& backends) {
    Rows rows = own_rows(backends, "pyramid", prepare);
    rows.push_back({"pyramid/tbb", prepare_tbb});
    rows.push_back(copy_row(backends, "pyramid", bytes_of));
    return rows;
}

} // namespace lineatlas::bench
