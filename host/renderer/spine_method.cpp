#include "spine_method.hpp"

#include <glm/gtc/matrix_inverse.hpp>

namespace lineatlas {
FrameStats SpineMethod::draw(Frame& frame) {
    check_depth_size(frame.camera.size * frame.depth_scale());
    const glm::mat4 clip_from_world = frame.camera.clip_from_world();
    gl::SegmentBuffers segments = frame.scene.gl_segments();
    if (frame.knows_surfaces()) segments.numbers = frame.scene.gl_surfaces().numbers;
    const bool cull_hidden = frame.culls_hidden();
    if (cull_hidden) {
        depth_.draw_for_compute(frame);
        depth_.fill_texture(frame);
    } else {
        depth_.draw_texture(frame);
    }
    fill_.draw(frame, depth_);
    frame.clock.gl("spine", [&] {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.framebuffer);
        spine_pass_.draw(segments,
                         {.clip_from_world = clip_from_world,
                          .world_from_clip = glm::mat4{glm::inverse(glm::dmat4{clip_from_world})},
                          .eye = frame.camera.eye(),
                          .kind_mask = frame.kinds(),
                          .step = frame.options.step,
                          .tiles = cull_hidden ? depth_.tiles().gl() : 0,
                          .tile_count = compute::tiles_for(depth_.size())},
                         depth_.probed_by_gl(frame), frame.stroke_params(frame.options.style.pen));
    });
    return {.triangles_drawn = depth_.triangles_drawn(), .stages = {}};
}

} // namespace lineatlas
