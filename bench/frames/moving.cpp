#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/ext/matrix_transform.hpp>

#include "lineatlas/assembly.hpp"
#include "lineatlas/scenes.hpp"
#include "subjects.hpp"

namespace lineatlas::bench {
namespace {

constexpr std::size_t moving_objects = 500;
constexpr float frames_per_second = 60;
constexpr std::uint32_t cloth_quads = 150; ///< a side

/// The mean of the vertices of every object.
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

/// Sways all objects but object 0, which is the building.
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

std::uint32_t on_cloth(std::uint32_t i, std::uint32_t j) {
    return i * (cloth_quads + 1) + j;
}

/// The positions of a square cloth at `time`, in seconds.
void wave(float time, std::vector<glm::vec3>& positions) {
    positions.resize(std::size_t{cloth_quads + 1} * (cloth_quads + 1));
    for (std::uint32_t i = 0; i <= cloth_quads; ++i) {
        for (std::uint32_t j = 0; j <= cloth_quads; ++j) {
            const float x = 2 * static_cast<float>(i) / cloth_quads - 1;
            const float z = 2 * static_cast<float>(j) / cloth_quads - 1;
            const float y = 0.15F * std::sin(7 * x + 3 * time) * std::cos(5 * z - 2 * time);
            positions[on_cloth(i, j)] = {x, y, z};
        }
    }
}

Mesh cloth() {
    Mesh mesh;
    wave(0, mesh.positions);
    for (std::uint32_t i = 0; i < cloth_quads; ++i) {
        for (std::uint32_t j = 0; j < cloth_quads; ++j) {
            const std::uint32_t a = on_cloth(i, j), b = on_cloth(i + 1, j),
                                c = on_cloth(i + 1, j + 1), d = on_cloth(i, j + 1);
            mesh.triangles.push_back({a, c, b});
            mesh.triangles.push_back({a, d, c});
        }
    }
    return mesh;
}

} // namespace

std::vector<Subject> moving_subjects(glm::ivec2 size, std::size_t frames) {
    Subject still = scene_subject("office", size, frames);
    Subject moving{
        "office moving",
        extract_lines(make_scene("office").mesh, {.lines = still.kinds, .separate_objects = true}),
        still.kinds, still.viewpoints};
    moving.animate = [middles = middles_of(moving.lines),
                      transforms =
                          std::vector<glm::mat4>(moving.lines.objects.size(), glm::mat4{1})](
                         Renderer& renderer, std::size_t frame) mutable {
        sway(middles, frame, transforms);
        renderer.set_transforms(transforms);
    };
    still.name = "office still";

    Subject blinking{"office hiding", moving.lines, still.kinds, still.viewpoints};
    std::vector<std::uint32_t> half;
    for (std::uint32_t i = 0; i < moving.lines.objects.size(); i += 2) half.push_back(i);
    blinking.animate = [half](Renderer& renderer, std::size_t frame) {
        renderer.set_hidden(frame % 2 == 0 ? std::span<const std::uint32_t>{half}
                                           : std::span<const std::uint32_t>{});
    };

    // A clevis is added and removed by turns. The first warm-up frame adds the office itself.
    Subject changing{"office adding", moving.lines, still.kinds, still.viewpoints};
    changing.animate = [scene = std::shared_ptr<Assembly>{}, number = 0U, is_there = false,
                        office = moving.lines,
                        clevis = extract_lines(make_scene("clevis").mesh, {.lines = still.kinds})](
                           Renderer& renderer, std::size_t) mutable {
        if (!scene) {
            scene = std::make_shared<Assembly>();
            scene->add(office);
        }
        if (is_there)
            scene->remove(number);
        else
            number = scene->add(clevis).front();
        is_there = !is_there;
        renderer.set_lines(*scene);
    };

    Subject flat = orbit_subject("cloth still", cloth(), all_line_kinds, {0, 1, 0}, size, frames);
    Subject waving = flat;
    waving.name = "cloth waving";
    waving.animate = [lines = flat.lines, positions = std::vector<glm::vec3>{}](
                         Renderer& renderer, std::size_t frame) mutable {
        wave(static_cast<float>(frame) / frames_per_second, positions);
        move_vertices(lines, positions);
        renderer.set_positions(0, lines.vertices);
    };
    return {std::move(still),    std::move(moving), std::move(blinking),
            std::move(changing), std::move(flat),   std::move(waving)};
}

} // namespace lineatlas::bench
