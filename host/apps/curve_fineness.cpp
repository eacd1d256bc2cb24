#include "curve_fineness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace lineatlas::apps {
namespace {

/// How large a camera draws things at their places.
class DrawnSize {
  public:
    explicit DrawnSize(const Camera& camera)
        : clip_(camera.clip_from_world()),
          focal_(0.5 * camera.size.y * std::abs(double{camera.projection[1][1]})),
          parallel_(camera.projection[3][3] != 0), wide_(1 / std::abs(camera.projection[0][0])),
          high_(1 / std::abs(camera.projection[1][1])),
          near_(parallel_ ? 1 : camera.projection[3][2] / (camera.projection[2][2] - 1)) {}

    /// Adds an edge or triangle by its corners, unless it lies beside the picture.
    template <class... Corners>
    void add(const Corners&... corners) {
        const std::array<glm::vec4, sizeof...(corners)> clip{clip_ * glm::vec4{corners, 1}...};
        const auto all = [&](const auto& is_out) { return std::ranges::all_of(clip, is_out); };
        if (all([](const glm::vec4& p) { return p.x > p.w; }) ||
            all([](const glm::vec4& p) { return p.x < -p.w; }) ||
            all([](const glm::vec4& p) { return p.y > p.w; }) ||
            all([](const glm::vec4& p) { return p.y < -p.w; }) ||
            all([&](const glm::vec4& p) { return p.w < near_; }))
            return;
        for (const glm::vec4& p : clip) most_ = std::max(most_, size_at(p));
    }

    double most() const { return most_; } ///< pixels for a unit

  private:
    double size_at(const glm::vec4& p) const {
        if (parallel_) return focal_;
        const double w = std::max(double{p.w}, near_);
        // A perspective picture is stretched away from its middle.
        const double x = std::min(1.0, std::abs(p.x / w)) * wide_;
        const double y = std::min(1.0, std::abs(p.y / w)) * high_;
        return focal_ / w * std::sqrt(1 + x * x + y * y);
    }

    glm::mat4 clip_;
    double focal_;
    bool parallel_;
    double wide_, high_; ///< half of the width and height seen at distance 1
    double near_;
    double most_ = 0;
};

bool is_curved(const glm::vec3* normals) {
    constexpr float flat = 1 - 1e-6F;
    return glm::dot(normals[0], normals[1]) < flat || glm::dot(normals[1], normals[2]) < flat;
}

double diagonal(const Mesh& mesh) {
    const Bounds box = bounds_of(mesh);
    return glm::distance(glm::dvec3{box.min}, glm::dvec3{box.max});
}

} // namespace

double pixels_per_unit(const Mesh& mesh, const Camera& camera) {
    DrawnSize size{camera};
    const auto at = [&](std::uint32_t position) { return mesh.positions[position]; };
    if (!mesh.corner_normals.empty()) {
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3 t = mesh.triangles[i];
            if (is_curved(&mesh.corner_normals[3 * i])) size.add(at(t.x), at(t.y), at(t.z));
        }
    }
    std::unordered_map<std::uint32_t, int> pieces;
    for (const KnownEdge& edge : mesh.known_edges) ++pieces[edge.edge];
    for (const KnownEdge& edge : mesh.known_edges)
        if (pieces[edge.edge] > 1) size.add(at(edge.from), at(edge.to));
    return size.most();
}

std::optional<double> finer_deflection(const Mesh& mesh, std::span<const Camera> cameras,
                                       double used, std::string& note) {
    double scale = 0;
    for (const Camera& camera : cameras) scale = std::max(scale, pixels_per_unit(mesh, camera));
    if (scale * used <= most_pixels_off) return std::nullopt;
    constexpr double least_share = 1e-5;
    const double least = least_share * diagonal(mesh);
    if (least * scale > most_pixels_off)
        note = fmt::format("curved faces are up to {:.2g} pixels off in this picture; --deflection "
                           "sets by how much they may be",
                           least * scale);
    const double wanted = std::max(most_pixels_off / scale, least);
    return wanted < used ? std::optional{wanted} : std::nullopt;
}

} // namespace lineatlas::apps
