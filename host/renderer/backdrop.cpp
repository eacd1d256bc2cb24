#include "backdrop.hpp"

#include "core/paper.hpp"
#include "lineatlas/error.hpp"

namespace lineatlas {

void Backdrop::check_fill(const Frame& frame, const Fill& fill) {
    if (!(fill.ambient >= 0 && fill.ambient <= 1)) {
        throw UsageError("fill: ambient must lie between 0 and 1");
    }
    if (fill.toon_steps < 2 || fill.toon_steps > 8) {
        throw UsageError("fill: toon_steps must be 2 to 8, not " + std::to_string(fill.toon_steps));
    }
    if (!has_depth_attachment(frame.framebuffer)) {
        throw UsageError("fill: the framebuffer has no depth attachment; add one or draw without "
                         "a fill");
    }
}

void Backdrop::draw_fill(Frame& frame, const Fill& fill, std::span<const gl::TriangleRange> seen) {
    if (fill.mode == FillMode::none) return;
    check_fill(frame, fill);
    if (!fill_pass_) fill_pass_.emplace();
    frame.clock.gl("fill", [&] {
        fill_pass_->draw(frame.scene.gl_triangles(), frame.scene.gl_colors(), seen,
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
    if (!(paper.grain >= 0 && paper.grain <= 1)) {
        throw UsageError("paper: grain must lie between 0 and 1");
    }
    if (paper.grain == 0) return;
    if (!paper_pass_) paper_pass_.emplace(make_paper());
    frame.clock.gl("paper", [&] {
        paper_pass_->draw(frame.tile, paper.grain, frame.framebuffer, frame.camera.origin);
    });
}

} // namespace lineatlas
