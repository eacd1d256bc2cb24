// Density control of StrokeStage.
#include <algorithm>
#include <cmath>

#include "compute/transfer.hpp"
#include "glpasses/storage.hpp"
#include "stroke_stage.hpp"

namespace lineatlas {
namespace {

/// The focus in pixels, also if it is a point of the model, because density knows no depth.
glm::vec4 focus_on_screen(const Frame& frame) {
    const Focus& focus = frame.options.style.focus;
    const glm::vec2 size = frame.viewport();
    if (!focus.on) return glm::vec4{0};
    if (!focus.in_scene) {
        return {glm::vec2{focus.point} * size, focus.radius * size.y, focus.falloff * size.y};
    }
    const glm::vec4 clip = frame.camera.clip_from_world() * glm::vec4{glm::vec3{focus.point}, 1};
    const float w = std::max(clip.w, 1e-6F);
    const glm::vec2 centre = (glm::vec2{clip} / w + 1.0F) * 0.5F * size;
    const float unit_height = std::abs(frame.camera.projection[1][1]) / w * 0.5F * size.y;
    const float scale = frame.scene.diagonal() * unit_height;
    return {centre, focus.radius * scale, focus.falloff * scale};
}

} // namespace

void StrokeStage::make_room(Thinning& thinning) {
    const std::size_t values = density_values();
    thinning.grid.fit(values * sizeof(std::uint32_t));
    gl::check_buffer_texture(values, purpose::density);
    thinning.weights.fit(values * sizeof(float));
}

void StrokeStage::density(Frame& frame, const compute::SegmentAtlas& input, bool hidden) {
    frame.clock("density", [&] {
        const Style& style = frame.options.style;
        Density limit = style.density;
        if (hidden) limit.limit = style.hidden_density;
        Thinning& own = thinning(hidden);
        stages_.density({.table = frame.scene.table(),
                         .atlas = input,
                         .runs = made(hidden).compute(),
                         .viewport = frame.viewport(),
                         .density = limit,
                         .focus = focus_on_screen(frame),
                         .far_limit = style.focus.on ? style.focus.density : 1,
                         .hidden = hidden,
                         .drawn_before = own.drawn_before,
                         .grid = *own.grid,
                         .weights = own.weights.compute()});
    });
}

std::vector<float> StrokeStage::read_density() {
    if (!thinning(false).on) return {};
    return compute::read_back<float>(device_, thinning(false).weights.compute(), density_values());
}

} // namespace lineatlas
