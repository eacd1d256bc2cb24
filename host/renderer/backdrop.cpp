#include "backdrop.hpp"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "core/limits.hpp"
#include "core/paper.hpp"
#include "core/tiles.hpp"
#include "depth_stage.hpp"

namespace lineatlas {

gl::Canvas& Backdrop::texels(glm::ivec2 size, GLuint framebuffer) {
    const int bits = has_bytes(framebuffer) ? 8 : 16;
    if (!texels_ || texels_->bits() != bits || glm::any(glm::greaterThan(size, texels_->size()))) {
        const glm::ivec2 room = texels_ ? glm::max(size, texels_->size()) : size;
        texels_.reset(); // before memory is asked for
        texels_.emplace(room, bits, purpose::fill);
    }
    texels_->clear_part(size);
    return *texels_;
}

void Backdrop::draw_fill(Frame& frame, const Fill& fill, std::span<const gl::TriangleRange> seen) {
    if (fill.mode == FillMode::none) return forget_fill();
    if (!fill_pass_) fill_pass_.emplace();
    if (!layer_) layer_.emplace();
    frame.clock.gl("fill", [&] {
        for (const PictureTile& part :
             make_tiles(frame.tile.size, most_fill_texels / frame.depth_scale())) {
            if (part.size == frame.camera.size) return draw_part(frame, fill, part, seen);
            const PictureTile tile{frame.tile.low + part.low, part.size};
            const glm::mat4 clip_of_part =
                tile_projection(frame.camera.clip_from_world(), tile, frame.camera.size);
            draw_part(frame, fill, part, pieces_in_view(frame.scene, clip_of_part));
        }
    });
}

void Backdrop::draw_part(Frame& frame, const Fill& fill, const PictureTile& part,
                         std::span<const gl::TriangleRange> seen) {
    const bool is_lit = fill.mode == FillMode::lambert || fill.mode == FillMode::toon;
    const int scale = frame.depth_scale();
    const PictureTile tile{frame.tile.low + part.low, part.size};
    gl::Canvas& canvas = texels(part.size * scale, frame.framebuffer);
    fill_pass_->draw(frame.scene.gl_triangles(), frame.scene.gl_colors(),
                     is_lit ? frame.scene.gl_smooth_triangles() : std::nullopt, seen,
                     {.clip_from_world = frame.camera.clip_from_world(),
                      .eye_from_world = frame.camera.view,
                      .viewport = part.size * scale,
                      .tile = tile_transform(tile, frame.camera.size)},
                     fill, canvas.framebuffer());
    layer_->draw_mean(canvas, scale, part.size, frame.framebuffer, frame.camera.origin + part.low);
}

void Backdrop::draw_fill(Frame& frame, const Fill& fill) {
    const gl::TriangleRange all{0, frame.scene.triangle_count()};
    draw_fill(frame, fill, {&all, 1});
}

void Backdrop::draw_paper(Frame& frame, const Paper& paper) {
    if (paper.grain == 0) return;
    if (!paper_pass_) paper_pass_.emplace(make_paper());
    frame.clock.gl("paper", [&] {
        paper_pass_->draw(frame.tile, paper.grain, frame.framebuffer, frame.camera.origin);
    });
}

} // namespace lineatlas
