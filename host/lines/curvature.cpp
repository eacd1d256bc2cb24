#include "curvature.hpp"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"

namespace lineatlas {
namespace {

/// Variance that means over the triangles about a vertex add: means of normals, of their
/// derivatives, and of gradients.
constexpr float variance_of_means = 0.7F; ///< in squared edges
/// Share of the variance by which gradients are smoothed.
constexpr float gradient_share = 1.0F / 3;

/// A symmetric matrix.
struct Tensor {
    float xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

    /// Adds the symmetric part of an outer product.
    void add(glm::vec3 a, glm::vec3 b) {
        xx += a.x * b.x;
        yy += a.y * b.y;
        zz += a.z * b.z;
        xy += 0.5F * (a.x * b.y + a.y * b.x);
        xz += 0.5F * (a.x * b.z + a.z * b.x);
        yz += 0.5F * (a.y * b.z + a.z * b.y);
    }
    glm::vec3 times(glm::vec3 v) const {
        return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z,
                xz * v.x + yz * v.y + zz * v.z};
    }
};

void add_scaled(Tensor& sum, const Tensor& one, float scale) {
    sum.xx += scale * one.xx;
    sum.yy += scale * one.yy;
    sum.zz += scale * one.zz;
    sum.xy += scale * one.xy;
    sum.xz += scale * one.xz;
    sum.yz += scale * one.yz;
}

/// The vector with length 1; zero stays zero.
glm::vec3 unit(glm::vec3 v) {
    const float length = std::sqrt(glm::dot(v, v));
    return length > 0 ? v / length : glm::vec3{0};
}

/// Some vector at a right angle to a unit vector.
glm::vec3 any_across(glm::vec3 n) {
    const bool along_x = std::abs(n.x) > 0.8F;
    return unit(glm::cross(n, along_x ? glm::vec3{0, 1, 0} : glm::vec3{1, 0, 0}));
}

/// The eigenvector of the greater eigenvalue of a symmetric 2 x 2 matrix; any vector for a multiple
/// of the identity.
glm::vec2 greater_eigenvector(float a, float b, float c, float greater) {
    const glm::vec2 one{b, greater - a}, other{greater - c, b};
    const glm::vec2 longer = glm::dot(one, one) > glm::dot(other, other) ? one : other;
    const float length = std::sqrt(glm::dot(longer, longer));
    return length > 0 ? longer / length : glm::vec2{1, 0};
}

} // namespace

SmoothedSurface::SmoothedSurface(const WeldedMesh& mesh, const std::vector<MeshEdge>& edges,
                                 std::span<const std::uint32_t> faces)
    : mesh_(mesh), faces_(faces), diffusion_(mesh, edges, faces) {
    find_normals();
}

void SmoothedSurface::find_normals() {
    normals_.assign(mesh_.vertices.size(), glm::vec4{0});
    for (const std::uint32_t face : faces_) {
        const glm::uvec3 t = mesh_.triangles[face];
        const glm::vec3 a = mesh_.vertices[t.x];
        const glm::vec3 normal = glm::cross(mesh_.vertices[t.y] - a, mesh_.vertices[t.z] - a);
        for (int k = 0; k < 3; ++k) normals_[t[k]] += glm::vec4{normal, 0};
    }
    for (glm::vec4& normal : normals_) normal = glm::vec4{unit(glm::vec3{normal}), 0};
}

/// Smoothing takes two steps, because the kernel of one step has a peak.
void SmoothedSurface::smooth_to(float edges) {
    const float deviation = edges * diffusion_.mean_edge();
    const float half = 0.5F * (deviation * deviation - variance_);
    for (int step = 0; step < 2; ++step) diffusion_.smooth(normals_, half);
    variance_ = deviation * deviation;
}

float SmoothedSurface::deviation() const {
    const float edge = diffusion_.mean_edge();
    return std::sqrt(variance_ * (1 + gradient_share) + variance_of_means * edge * edge);
}

glm::vec3 SmoothedSurface::gradient(std::uint32_t face, glm::vec3 values) const {
    const glm::uvec3 t = mesh_.triangles[face];
    const glm::vec3 a = mesh_.vertices[t.x], b = mesh_.vertices[t.y], c = mesh_.vertices[t.z];
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const float squared = glm::dot(normal, normal);
    if (!(squared > 0)) return glm::vec3{0};
    return glm::cross(normal, values.x * (c - b) + values.y * (a - c) + values.z * (b - a)) /
           squared;
}

void SmoothedSurface::find_directions(Curvatures& found) const {
    const std::size_t count = mesh_.vertices.size();
    // Means of unit normals are not made unit vectors again. Where normals point all ways, as in a
    // thin limb, their means turn fast and say little.
    std::vector<Tensor> tensors(count);
    for (const std::uint32_t face : faces_) {
        const glm::uvec3 t = mesh_.triangles[face];
        const glm::vec3 a = mesh_.vertices[t.x], b = mesh_.vertices[t.y], c = mesh_.vertices[t.z];
        const glm::vec3 normal = glm::cross(b - a, c - a);
        const float squared = glm::dot(normal, normal);
        if (!(squared > 0)) continue;
        // The gradient of a function that is 1 at one corner, times the share of the triangle's
        // area there.
        const float share = 1 / (6 * std::sqrt(squared));
        Tensor tensor;
        tensor.add(glm::vec3{normals_[t.x]}, share * glm::cross(normal, c - b));
        tensor.add(glm::vec3{normals_[t.y]}, share * glm::cross(normal, a - c));
        tensor.add(glm::vec3{normals_[t.z]}, share * glm::cross(normal, b - a));
        for (int k = 0; k < 3; ++k) add_scaled(tensors[t[k]], tensor, 1);
    }
    for (PrincipalCurvature* one : {&found.most, &found.least}) {
        one->k.assign(count, 0);
        one->way.assign(count, glm::vec3{0});
    }
    for_each_index(count, [&](std::size_t v) {
        const float area = diffusion_.areas()[v];
        if (!(area > 0)) return;
        const glm::vec3 normal = unit(glm::vec3{normals_[v]});
        const glm::vec3 x = any_across(normal), y = glm::cross(normal, x);
        const glm::vec3 of_x = tensors[v].times(x), of_y = tensors[v].times(y);
        const float scale = 1 / area;
        const float a = scale * glm::dot(of_x, x), b = scale * glm::dot(of_x, y),
                    c = scale * glm::dot(of_y, y);
        const float mean = 0.5F * (a + c), half = 0.5F * (a - c);
        const float apart = std::sqrt(half * half + b * b);
        const glm::vec2 way = greater_eigenvector(a, b, c, mean + apart);
        found.most.k[v] = mean + apart;
        found.least.k[v] = mean - apart;
        found.most.way[v] = way.x * x + way.y * y;
        found.least.way[v] = way.x * y - way.y * x;
    });
}

/// The derivative of a principal curvature along its own direction is the derivative of the field
/// of these curvatures, because the direction itself turns at a right angle to it.
void SmoothedSurface::find_gradients(PrincipalCurvature& found) const {
    std::vector<glm::vec4> gradients(mesh_.vertices.size(), glm::vec4{0});
    for (const std::uint32_t face : faces_) {
        const glm::uvec3 t = mesh_.triangles[face];
        const glm::vec3 a = mesh_.vertices[t.x], b = mesh_.vertices[t.y], c = mesh_.vertices[t.z];
        const glm::vec3 normal = glm::cross(b - a, c - a);
        const float length = std::sqrt(glm::dot(normal, normal));
        if (!(length > 0)) continue;
        const glm::vec3 way =
            found.k[t.x] * (c - b) + found.k[t.y] * (a - c) + found.k[t.z] * (b - a);
        const glm::vec4 share{glm::cross(normal, way) / (6 * length), 0};
        for (int corner = 0; corner < 3; ++corner) gradients[t[corner]] += share;
    }
    const std::vector<float>& areas = diffusion_.areas();
    for (std::size_t v = 0; v < gradients.size(); ++v)
        if (areas[v] > 0) gradients[v] /= areas[v];
    diffusion_.smooth(gradients, gradient_share * variance_);
    found.gradient.reserve(gradients.size());
    found.slope.reserve(gradients.size());
    for (const glm::vec4& gradient : gradients) {
        found.slope.push_back(glm::dot(glm::vec3{gradient}, found.way[found.slope.size()]));
        found.gradient.emplace_back(gradient);
    }
}

Curvatures SmoothedSurface::curvatures() const {
    Curvatures found;
    find_directions(found);
    do_both([&] { find_gradients(found.most); }, [&] { find_gradients(found.least); });
    return found;
}

} // namespace lineatlas
