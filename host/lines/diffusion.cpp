#include "diffusion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"

namespace lineatlas {
namespace {

using Values = std::vector<glm::vec4>;

constexpr float most_cotangent =
    10; ///< limit for a triangle's angles, because slivers would dominate the flow
constexpr int most_iterations = 200;
constexpr double precision = 0.05; ///< of a step, as a share of what it changes

float cotangent(glm::vec3 u, glm::vec3 v) {
    const glm::vec3 across = glm::cross(u, v);
    return glm::dot(u, v) / std::sqrt(glm::dot(across, across));
}

/// A sum that is the same on any number of threads.
template <class Each>
double sum_over(std::size_t count, const Each& each) {
    double sum = 0;
    for (const double part :
         made_of_pieces<double>(count, usual_piece, [&](std::size_t first, std::size_t end) {
             double own = 0;
             for (std::size_t v = first; v < end; ++v) own += double{each(v)};
             return own;
         }))
        sum += part;
    return sum;
}

} // namespace

Diffusion::Diffusion(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                     std::span<const std::uint32_t> faces)
    : outflows_(mesh.vertices.size(), 0), areas_(mesh.vertices.size(), 0) {
    find_neighbours(mesh, edges);
    double length = 0;
    for (const std::uint32_t face : faces) {
        const glm::uvec3 t = mesh.triangles[face];
        add_face(mesh, t);
        for (int k = 0; k < 3; ++k)
            length += double{glm::distance(mesh.vertices[t[k]], mesh.vertices[t[(k + 1) % 3]])};
    }
    mean_edge_ = static_cast<float>(length / (3.0 * static_cast<double>(faces.size())));
}

/// Lists neighbours in ascending order, as edges are.
void Diffusion::find_neighbours(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges) {
    offsets_.assign(mesh.vertices.size() + 1, 0);
    for (const MeshEdge& edge : edges) {
        ++offsets_[edge.p + 1];
        ++offsets_[edge.q + 1];
    }
    for (std::size_t v = 1; v < offsets_.size(); ++v) offsets_[v] += offsets_[v - 1];
    neighbours_.resize(offsets_.back());
    flows_.assign(neighbours_.size(), 0);
    std::vector<std::uint32_t> next(offsets_.begin(), offsets_.end() - 1);
    for (const MeshEdge& edge : edges) {
        neighbours_[next[edge.p]++] = edge.q;
        neighbours_[next[edge.q]++] = edge.p;
    }
}

void Diffusion::add_face(const WeldedMesh& mesh, glm::uvec3 face) {
    const glm::vec3 a = mesh.vertices[face.x], b = mesh.vertices[face.y], c = mesh.vertices[face.z];
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const float twice_area = std::sqrt(glm::dot(normal, normal));
    if (!(twice_area > 0)) return;
    const glm::vec3 cotangents{cotangent(b - a, c - a), cotangent(c - b, a - b),
                               cotangent(a - c, b - c)};
    const float most = std::max({cotangents.x, cotangents.y, cotangents.z});
    const float half = 0.5F * std::min(1.0F, most_cotangent / most);
    for (int k = 0; k < 3; ++k) {
        areas_[face[k]] += twice_area / 6;
        add_flow(face[(k + 1) % 3], face[(k + 2) % 3], half * cotangents[k]);
    }
}

void Diffusion::add_flow(std::uint32_t a, std::uint32_t b, float flow) {
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
        std::uint32_t i = offsets_[from];
        while (i < offsets_[from + 1] && neighbours_[i] != to) ++i;
        if (i == offsets_[from + 1]) return;
        flows_[i] += flow;
        outflows_[from] += flow;
    }
}

/// Solves by conjugate gradients, preconditioned by the diagonal, starting from the values
/// themselves.
void Diffusion::smooth(Values& values, float variance) const {
    const float half = 0.5F * variance;
    const std::size_t count = values.size();
    std::vector<float> inverse(count, 0); // of the diagonal
    Values residual(count), direction(count), applied(count);
    double error = sum_over(count, [&](std::size_t v) {
        const float diagonal = areas_[v] + half * outflows_[v];
        if (diagonal > 0) inverse[v] = 1 / diagonal;
        residual[v] = half * gain(values, v);
        direction[v] = inverse[v] * residual[v];
        return glm::dot(residual[v], direction[v]);
    });
    const double wanted = precision * precision * error;
    for (int i = 0; i < most_iterations && error > wanted; ++i) {
        const double curvature = sum_over(count, [&](std::size_t v) {
            applied[v] = areas_[v] * direction[v] - half * gain(direction, v);
            return glm::dot(direction[v], applied[v]);
        });
        if (!(curvature > 0)) return;
        const auto step = static_cast<float>(error / curvature);
        const double before = error;
        error = sum_over(count, [&](std::size_t v) {
            values[v] += step * direction[v];
            residual[v] -= step * applied[v];
            return inverse[v] * glm::dot(residual[v], residual[v]);
        });
        const auto factor = static_cast<float>(error / before);
        for_each_index(count, [&](std::size_t v) {
            direction[v] = inverse[v] * residual[v] + factor * direction[v];
        });
    }
}

/// The flow to a vertex.
glm::vec4 Diffusion::gain(const Values& values, std::size_t v) const {
    glm::vec4 sum{0};
    for (std::uint32_t i = offsets_[v]; i < offsets_[v + 1]; ++i)
        sum += flows_[i] * values[neighbours_[i]];
    return sum - outflows_[v] * values[v];
}

} // namespace lineatlas
