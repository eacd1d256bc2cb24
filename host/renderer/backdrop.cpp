#include "backdrop.hpp"

#include "core/paper.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {

void Backdrop::check_fill(GLuint framebuffer) {
    if (!has_depth_attachment(framebuffer)) {
        throw UsageError("fill: the framebuffer has no depth attachment; add one or draw without "
                         "a fill");
    }
}

void Backdrop::draw_fill(Frame& frame, const Fill& fill, std::span<const gl::TriangleRange> seen) {
    if (fill.mode == FillMode::none) return;
    check_fill(frame.framebuffer);
    if (!fill_pass_) fill_pass_.emplace();
    const bool is_lit = fill.mode == FillMode::lambert || fill.mode == FillMode::toon;
    frame.clock.gl("fill", [&] {
        fill_pass_->draw(frame.scene.gl_triangles(), frame.scene.gl_colors(),
                         is_lit ? frame.scene.gl_smooth_triangles() : std::nullopt, seen,
                         {.clip_from_world = frame.camera.clip_from_world(),
                          .eye_from_world = frame.camera.view,
                          .viewport = frame.tile.size,
                          .origin = frame.camera.origin,
                          .tile = tile_transform(frame.tile, frame.camera.size)},
                         fill, frame.framebuffer);
    });
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
