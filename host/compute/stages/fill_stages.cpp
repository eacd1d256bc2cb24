// `fill` by kernels: the colours of triangles, then those of pixels.
#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "stages.hpp"

namespace lineatlas::compute {
namespace {

FillColorsParameters colors_parameters(const FillArgs& args) {
    const Fill& fill = args.fill;
    const float length = glm::length(fill.light);
    const glm::vec3 light = length > 0 ? fill.light / length : glm::vec3{0, 0, 1};
    const bool toon = fill.mode == FillMode::toon;
    return {.count = args.model.count,
            .has_colors = args.colors != nullptr ? 1U : 0U,
            .lit = toon || fill.mode == FillMode::lambert ? 1U : 0U,
            .has_smooth = args.smooth.normals != nullptr ? 1U : 0U,
            .plain = {fill.color, 1},
            .eye = args.eye,
            // Normals are turned by the transposed inverse of the matrix that turns faces.
            .eye_from_normal =
                glm::mat4{glm::transpose(glm::inverse(glm::mat3{args.eye_from_world}))},
            .light = {light, 0},
            .ambient = std::clamp(fill.ambient, 0.0F, 1.0F),
            .steps = toon ? static_cast<float>(std::max(fill.toon_steps, 2)) : 0.0F};
}

FillPixelsParameters pixels_parameters(const FillArgs& args, const FillColorsParameters& colors,
                                       std::uint32_t block, std::uint32_t blocks) {
    return {.size = args.size,
            .low = args.part.low,
            .wanted = args.part.size(),
            .origin = args.origin,
            .row = args.row,
            .scale = args.scale,
            .block = block,
            .blocks = blocks,
            .has_smooth = colors.has_smooth,
            .first = args.first_texel,
            .step = args.texel_step,
            .clip_from_world = args.clip_from_world,
            .eye = colors.eye,
            .eye_from_normal = colors.eye_from_normal,
            .light = colors.light,
            .ambient = colors.ambient,
            .steps = colors.steps};
}

} // namespace

void Stages::fill(const FillArgs& args) {
    const glm::ivec2 wanted = args.part.size();
    if (wanted.x <= 0 || wanted.y <= 0) return;
    const FillColorsParameters colors = colors_parameters(args);
    launch<kernels::fill_colors>(args.model.count, colors, args.model, args, args.smooth);
    const std::uint32_t block = tuning_.atlas_block;
    const std::uint32_t blocks = divide_up(static_cast<std::uint32_t>(wanted.x), block);
    launch_grouped<kernels::fill_pixels>(
        blocks * static_cast<std::uint32_t>(wanted.y), tuning_.block_local_size,
        pixels_parameters(args, colors, block, blocks), args, args.smooth);
}

} // namespace lineatlas::compute
