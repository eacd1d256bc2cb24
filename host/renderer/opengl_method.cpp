#include "opengl_method.hpp"

#include "backdrop.hpp"

namespace lineatlas {

FrameStats OpenGlMethod::draw(Frame& frame) {
    const glm::mat4 clip_from_world = frame.camera.clip_from_world();
    const Pen& pen = frame.options.style.pen;
    const glm::vec4 color{pen.color, pen.opacity};
    frame.backdrop.draw_fill(frame, frame.options.style.fill);
    const gl::LineBuffers lines = frame.scene.gl_lines(frame.kinds());
    frame.clock.gl("depth", [&] {
        line_pass_.draw_depth(frame.scene.gl_triangles(), clip_from_world, frame.camera.origin,
                              frame.camera.size, frame.framebuffer);
    });
    frame.clock.gl("lines", [&] {
        line_pass_.draw_lines(lines, clip_from_world, frame.options.style.pen.width, color);
    });
    return {.triangles_drawn = frame.scene.triangle_count(), .stages = {}};
}

} // namespace lineatlas
