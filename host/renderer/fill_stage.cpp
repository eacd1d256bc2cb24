#include "fill_stage.hpp"

#include <glm/common.hpp>

#include "backdrop.hpp"

namespace lineatlas {

FillStage::FillStage(const interop::Connection& connection)
    : stages_(*connection.stages), device_(stages_.device()),
      pixels_(*connection.sharing, compute::table::pixels) {}

void FillStage::prepare(const Frame& frame) {
    shaded_.fit(frame.scene.triangle_count() * sizeof(la_uint));
    pixels_.fit(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
                sizeof(la_uint));
}

void FillStage::color(Frame& frame, DepthStage& depth, const PictureTile& tile, glm::ivec2 low) {
    size_ = tile.size;
    prepare(frame);
    // Only pixels whose texels have all been drawn. Kernels draw some texels more around the model.
    const int scale = frame.depth_scale();
    const glm::ivec2 origin = tile.low * scale - low;
    const TexelRectangle drawn = depth.drawn_texels();
    part_.low = (glm::max(drawn.low - origin, 0) + (scale - 1)) / scale;
    part_.high = glm::min(glm::max(drawn.high - origin, 0) / scale, size_);
    const Fill& fill = frame.options.style.fill;
    const bool is_lit = fill.mode == FillMode::lambert || fill.mode == FillMode::toon;
    const glm::vec2 step = 2.0F / glm::vec2{frame.camera.size * scale};
    frame.clock("fill", [&] {
        stages_.fill(
            {.model = frame.scene.meshlets(),
             .vertices = frame.scene.candidate_table().vertices,
             .seen = depth.seen(),
             .colors = frame.scene.colors(),
             .smooth = is_lit ? frame.scene.smooth_triangles() : compute::SmoothTriangles{},
             .fill = fill,
             .clip_from_world = frame.camera.clip_from_world(),
             .first_texel = (glm::vec2{tile.low * scale} + 0.5F) * step - 1.0F,
             .texel_step = step,
             .eye_from_world = frame.camera.view,
             .eye = frame.camera.eye(),
             .shaded = *shaded_,
             .numbers = depth.surfaces().numbers()->compute(),
             .row = depth.size().x,
             .origin = origin,
             .scale = scale,
             .size = size_,
             .part = part_,
             .pixels = pixels_.compute()});
        device_.flush();
    });
}

void FillStage::draw(Frame& frame, DepthStage& depth) {
    if (frame.options.style.fill.mode == FillMode::none) return frame.backdrop.forget_fill();
    if (!depth.wants_kernels(frame))
        return frame.backdrop.draw_fill(frame, frame.options.style.fill, depth.drawn());
    color(frame, depth, {{0, 0}, frame.camera.size}, {0, 0});
    lay(frame);
}

void FillStage::draw_tile(Frame& frame, DepthStage& depth) {
    if (frame.options.style.fill.mode == FillMode::none) return frame.backdrop.forget_fill();
    if (!depth.wants_kernels(frame))
        return frame.backdrop.draw_fill(frame, frame.options.style.fill);
    // Pictures, and tiles of them, may be as large as GL can draw. Depth is not kept for all of it.
    for (const PictureTile& part :
         make_tiles(frame.tile.size, most_fill_texels / frame.depth_scale())) {
        const PictureTile tile{frame.tile.low + part.low, part.size};
        const compute::DepthTile drawn = depth.draw_tile(frame, tile);
        color(frame, depth, tile, drawn.origin);
        lay(frame, part.low);
    }
}

void FillStage::lay(Frame& frame, glm::ivec2 at) {
    if (!layer_) layer_.emplace();
    frame.clock.gl("fill", [&] {
        layer_->draw(pixels_.gl(), size_, part_, frame.framebuffer, frame.camera.origin + at);
    });
}

} // namespace lineatlas
