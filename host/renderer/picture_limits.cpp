#include "picture_limits.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/limits.hpp"
#include "glpasses/storage.hpp"

namespace lineatlas {
namespace {

/// Texels per pixel of the largest texture that a frame draws to.
int texels_per_pixel(const FrameOptions& options) {
    switch (options.method) {
    case Method::opengl:
    case Method::exact:
        return 1;
    case Method::item_buffer:
        return static_cast<int>(std::lround(std::sqrt(options.probes)));
    case Method::atlas:
    case Method::spine:
        break;
    }
    return options.depth_scale;
}

/// Depth texels that a buffer of the device holds.
std::uint64_t most_depth_texels(const compute::Device& device) {
    return device.largest_buffer() / sizeof(float);
}

} // namespace

int probe_margin(float step, int depth_scale) {
    // Probes lie half a sample along the line and a pixel across it from the sample's middle.
    return static_cast<int>(std::ceil((0.5F * step + 1) * static_cast<float>(depth_scale))) + 1;
}

int tile_size_for(glm::ivec2 size, const FrameOptions& options, const compute::Device& device) {
    const int scale = texels_per_pixel(options);
    const int largest = gl::largest_side();
    const std::uint64_t most_texels = most_depth_texels(device);
    const auto texels = static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) *
                        static_cast<std::uint64_t>(scale) * static_cast<std::uint64_t>(scale);
    const bool exact = options.method == Method::exact;
    const bool by_tiles =
        exact || (options.method == Method::atlas && options.forms.atlas != StageForm::raster);
    const bool depth_fits = !by_tiles || exact || texels <= most_texels;
    if (std::max(size.x, size.y) <= largest / scale && depth_fits) return 0;
    if (!by_tiles) gl::check_side(size * scale, purpose::whole_picture);

    constexpr double usual_side = 4096; // more take memory, fewer time
    constexpr int smallest_tile = 16;
    const int margin = probe_margin(options.step, options.depth_scale);
    const double most_side = std::min<double>(largest, std::sqrt(static_cast<double>(most_texels)));
    const auto side = static_cast<int>(std::min(usual_side, most_side - 2 * margin));
    return std::max(side / options.depth_scale, smallest_tile);
}

} // namespace lineatlas
