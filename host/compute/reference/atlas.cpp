#include <algorithm>

#include "probe.hpp"
#include "stages.hpp"

namespace lineatlas::compute::reference {
namespace {

std::uint32_t count_visible(const AtlasInput& in, const Spine& spine, std::uint32_t j,
                            float inverse_l) {
    const Depth depth{in.depth, in.depth_size, in.depth_scale, in.tolerance};
    std::uint32_t visible = 0;
    const float inverse_axis = 1.0F / static_cast<float>(in.probes);
    const float shift =
        in.probes == 1 ? spine.outside() * LA_FOLD_CLEARANCE * (1.0F / in.depth_scale) : 0;
    const float middle = 0.5F * static_cast<float>(in.probes - 1);
    const float inverse_probes = 1.0F / static_cast<float>(in.probes * in.probes);
    for (std::uint32_t row = 0; row < in.probes; ++row) {
        for (std::uint32_t column = 0; column < in.probes; ++column) {
            const float row_shift = (static_cast<float>(column) - middle) * inverse_probes;
            const float column_shift = (static_cast<float>(row) - middle) * inverse_probes;
            const float row_place = (static_cast<float>(row) + 0.5F) * inverse_axis + row_shift;
            const float side =
                (static_cast<float>(column) + 0.5F) * inverse_axis - 0.5F + column_shift + shift;
            const float u = (static_cast<float>(j) + row_place) * inverse_l;
            visible += sees_line(spine, u, side, depth) ? 1 : 0;
        }
    }
    return visible;
}

/// Judged by the place in the whole picture, see atlas.cl.
bool is_in_core(const DepthTile& tile, const Spine& spine, std::uint32_t j, float inverse_l) {
    const glm::vec2 place = spine.p + spine.d * ((static_cast<float>(j) + 0.5F) * inverse_l);
    const glm::ivec2 texel{std::floor(place.x), std::floor(place.y)};
    return texel.x >= tile.core_low.x && texel.y >= tile.core_low.y && texel.x < tile.core_high.x &&
           texel.y < tile.core_high.y;
}

} // namespace

void atlas(const AtlasInput& in, std::span<std::uint8_t> alpha) {
    const std::uint32_t probes = in.probes * in.probes;
    for (std::size_t i = 0; i + 1 < in.offsets.size(); ++i) {
        const std::uint32_t begin = in.offsets[i];
        const std::uint32_t l = in.offsets[i + 1] - begin;
        if (l == 0) continue;
        if (begin >= in.capacity) return;
        const Spine whole = make_spine(in.clipped[i], in.viewport, in.depth_scale);
        Spine spine = whole;
        if (in.tile != nullptr) spine.p -= glm::vec2{in.tile->origin};
        const float inverse_l = 1.0F / static_cast<float>(l);
        const std::uint32_t address = in.layout.address(begin);
        const std::uint32_t stop = std::min(l, in.capacity - begin);
        for (std::uint32_t j = 0; j < stop; ++j) {
            if (in.tile != nullptr && !is_in_core(*in.tile, whole, j, inverse_l)) continue;
            const std::uint32_t visible = count_visible(in, spine, j, inverse_l);
            alpha[address + j] = static_cast<std::uint8_t>((visible * 255 + probes / 2) / probes);
        }
    }
}

} // namespace lineatlas::compute::reference
