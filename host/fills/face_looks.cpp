#include "face_looks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "base/parallel.hpp"

namespace lineatlas {
namespace {

/// Light adds up linearly, colours are coded for the screen.
double coded(double light) {
    return std::pow(light, 1 / 2.2);
}

double in_tones(double lambert, int tones) {
    const double last = tones - 1;
    return std::min(std::floor(lambert * tones), last) / last;
}

/// How bright faces are, whichever way their corners go round: the eye sees their near side.
class Shades {
  public:
    Shades(const LineSet& lines, const Camera& camera, const Fill& fill)
        : lines_(lines), fill_(fill), eye_(camera.eye()),
          eye_from_normal_(glm::transpose(glm::inverse(glm::dmat3{glm::dmat4{camera.view}}))),
          light_(glm::normalize(glm::dvec3{fill.light})) {}

    double of(std::size_t triangle) const {
        if (fill_.mode == FillMode::flat) return 1;
        const double ambient = static_cast<double>(fill_.ambient);
        double lambert = lambert_of(triangle);
        if (fill_.mode == FillMode::toon) lambert = in_tones(lambert, fill_.toon_steps);
        return coded(std::min(ambient + lambert * (1 - ambient), 1.0));
    }

  private:
    double lambert_of(std::size_t triangle) const {
        const glm::uvec3 t = lines_.triangles[triangle];
        const glm::dvec3 a{lines_.vertices[t.x]}, b{lines_.vertices[t.y]}, c{lines_.vertices[t.z]};
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const glm::dvec3 seen = eye_from_normal_ * normal;
        constexpr double least = 1e-30;
        const double along = glm::dot(seen, light_) / std::max(glm::length(seen), least);
        const bool from_behind = glm::dot(normal, glm::dvec3{eye_} - a * eye_.w) < 0;
        return std::max(from_behind ? -along : along, 0.0);
    }

    const LineSet& lines_;
    const Fill& fill_;
    glm::dvec4 eye_;
    glm::dmat3 eye_from_normal_;
    glm::dvec3 light_;
};

glm::vec3 plain_color(const LineSet& lines, const Fill& fill, std::size_t triangle) {
    if (lines.triangle_color.empty()) return fill.color;
    const std::uint16_t color = lines.triangle_color[triangle];
    return color == LineSet::no_color ? fill.color : lines.colors[color];
}

/// Per group the first one of the same object.
std::vector<std::uint32_t> objects_of_groups(const std::vector<MeshGroup>& groups) {
    std::unordered_map<std::string, std::uint32_t> first;
    std::vector<std::uint32_t> objects;
    for (std::uint32_t i = 0; i < groups.size(); ++i)
        objects.push_back(first.try_emplace(groups[i].object, i).first->second);
    return objects;
}

} // namespace

FaceLooks face_looks(const LineSet& lines, const Camera& camera, const Fill& fill) {
    const Shades shades{lines, camera, fill};
    std::vector<glm::uvec3> colors(lines.triangles.size());
    for_each_index(colors.size(), [&](std::size_t i) {
        const glm::dvec3 bytes = 255.0 * glm::dvec3{plain_color(lines, fill, i)} * shades.of(i);
        colors[i] = glm::uvec3{glm::clamp(bytes, 0.0, 255.0) + 0.5};
    });
    const std::vector<std::uint32_t> objects = objects_of_groups(lines.groups);
    FaceLooks result;
    result.of_triangle.resize(colors.size());
    std::map<std::tuple<std::uint32_t, unsigned, unsigned, unsigned>, std::uint32_t> known;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        if (i % usual_piece == 0) ask_between_pieces();
        const bool grouped = !lines.triangle_group.empty();
        const std::uint32_t object = grouped ? objects[lines.triangle_group[i]] : 0;
        const glm::uvec3 color = colors[i];
        const auto number = static_cast<std::uint32_t>(result.looks.size());
        const auto [look, is_new] = known.try_emplace({object, color.x, color.y, color.z}, number);
        if (is_new) result.looks.push_back({grouped ? lines.groups[object].object : "", color});
        result.of_triangle[i] = look->second;
    }
    return result;
}

} // namespace lineatlas
