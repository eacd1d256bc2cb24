#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_transform.hpp>

#include "lineatlas/scenes.hpp"
#include "subjects.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::size_t moving_objects = 500;
constexpr float frames_per_second = 60;

/// The middle of every object.
std::vector<glm::vec3> middles_of(const LineSet& lines) {
    std::vector<glm::vec3> result;
    for (const LineObject& object : lines.objects) {
        glm::vec3 sum{0};
        for (std::uint32_t i = 0; i < object.vertex_count; ++i) {
            sum += lines.vertices[object.first_vertex + i];
        }
        result.push_back(sum / static_cast<float>(std::max(object.vertex_count, 1U)));
    }
    return result;
}

/// Object 0 is the building.
void sway(std::span<const glm::vec3> middles, std::size_t frame,
          std::vector<glm::mat4>& transforms) {
    const float time = static_cast<float>(frame) / frames_per_second;
    for (std::size_t i = 1; i <= std::min(moving_objects, middles.size() - 1); ++i) {
        const float phase = time * 2 + static_cast<float>(i);
        const glm::vec3 aside{0.15F * std::sin(phase), 0, 0.15F * std::cos(phase)};
        transforms[i] = glm::translate(glm::rotate(glm::translate(glm::mat4{1}, middles[i] + aside),
                                                   0.3F * std::sin(phase), {0, 1, 0}),
                                       -middles[i]);
    }
}

} // namespace

std::vector<Subject> moving_subjects(glm::ivec2 size, std::size_t frames) {
    Subject still = scene_subject("office", size, frames);
    Subject moving{
        "office moving",
        extract_lines(make_scene("office").mesh, {.kinds = still.kinds, .separate_objects = true}),
        still.kinds, still.viewpoints};
    moving.animate = [middles = middles_of(moving.lines),
                      transforms =
                          std::vector<glm::mat4>(moving.lines.objects.size(), glm::mat4{1})](
                         Renderer& renderer, std::size_t frame) mutable {
        sway(middles, frame, transforms);
        renderer.set_transforms(transforms);
    };
    still.name = "office still";
    return {std::move(still), std::move(moving)};
}

} // namespace lineatlas::bench
