#include "spine_method.hpp"

#include <glm/gtc/matrix_inverse.hpp>

namespace lineatlas {

FrameStats SpineMethod::draw(Frame& frame) {
    check_depth_size(frame);
    const glm::mat4 clip_from_world = frame.camera.clip_from_world();
    const gl::SegmentBuffers segments = frame.scene.gl_segments();
    frame.clock("depth", [&] {
        depth_pass_.begin(frame.camera.size, frame.options.depth_scale);
        depth_pass_.draw(frame.scene.gl_triangles(), clip_from_world);
    });
    frame.clock("spine", [&] {
        glBindFramebuffer(GL_FRAMEBUFFER, frame.framebuffer);
        spine_pass_.draw(segments,
                         {.clip_from_world = clip_from_world,
                          .world_from_clip = glm::mat4{glm::inverse(glm::dmat4{clip_from_world})},
                          .eye = frame.camera.eye(),
                          .kind_mask = frame.options.lines,
                          .step = frame.options.step},
                         frame.probe_params(depth_pass_.texture()), frame.stroke_params());
    });
    return {.triangles = frame.scene.triangle_count(),
            .triangles_drawn = frame.scene.triangle_count(),
            .segments = frame.scene.segment_count(),
            .segment_bytes = frame.scene.device_bytes(),
            .stages = frame.clock.take()};
}

} // namespace lineatlas
