#include "trial_frames.hpp"

#include <string>

#include "compute/opencl/device_trial.hpp"
#include "glpasses/objects.hpp"
#include "lineatlas/renderer.hpp"
#include "visibility/trial_lines.hpp"

namespace lineatlas {
namespace {

void draw(const DeviceOptions& options) {
    const LineSet lines = trial_lines();
    const Camera camera = trial_camera(lines);
    Renderer renderer{options};
    renderer.set_lines(lines);
    const auto pixels = gl::Renderbuffer::create();
    const auto framebuffer = gl::Framebuffer::create();
    glNamedRenderbufferStorage(pixels.id(), GL_RGBA8, camera.size.x, camera.size.y);
    glNamedFramebufferRenderbuffer(framebuffer.id(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                   pixels.id());
    FrameOptions frame;
    frame.forms = {
        .atlas = StageForm::compute, .depth = StageForm::compute, .strokes = StageForm::compute};
    for (const Method method : {Method::exact, Method::atlas}) {
        frame.method = method;
        renderer.draw(camera, frame, framebuffer.id());
    }
}

} // namespace

bool try_frames(const compute::Device& device, interop::SharingMode mode) {
    if (interop::is_for_one_device(mode)) mode = interop::SharingMode::copy;
    const std::string sharing{interop::name_of(mode)};
    return compute::try_device(device, "frames by " + sharing, [&](DeviceOptions options) {
        options.interop = sharing;
        draw(options);
    });
}

} // namespace lineatlas
