#include "primitives.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "borders.hpp"
#include "draco.hpp"

namespace lineatlas::gltf {

namespace {

constexpr const char* draco = "KHR_draco_mesh_compression";

enum class Mode : std::uint64_t { points, lines, loop, line_strip, triangles, strip, fan };

/// Adds corners of triangles and points of lines, in the order of the primitive's mode.
void connect(Primitive& primitive, const std::vector<std::uint32_t>& indices, Mode mode,
             const std::string& of) {
    const std::size_t count = indices.size();
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
        primitive.triangles.push_back({indices[a], indices[b], indices[c]});
    };
    switch (mode) {
    case Mode::points:
        primitive.points = true;
        return;
    case Mode::lines:
        if (count % 2 != 0) refuse(of + " has half a line");
        for (std::size_t i = 0; i + 1 < count; i += 2)
            primitive.lines.push_back({indices[i], indices[i + 1]});
        return;
    case Mode::loop:
    case Mode::line_strip:
        if (count < 2) refuse(of + " has a line of fewer than two points");
        primitive.lines.push_back(indices);
        if (mode == Mode::loop) primitive.lines.back().push_back(indices.front());
        return;
    case Mode::triangles:
        if (count % 3 != 0) refuse(of + " has a number of corners that makes no triangles");
        for (std::size_t i = 0; i + 2 < count; i += 3) triangle(i, i + 1, i + 2);
        return;
    case Mode::strip:
        // Every other triangle is turned, so that all face the same way.
        for (std::size_t i = 0; i + 2 < count; ++i) triangle(i, i + 1 + i % 2, i + 2 - i % 2);
        return;
    case Mode::fan:
        for (std::size_t i = 0; i + 2 < count; ++i) triangle(i + 1, i + 2, 0);
        return;
    }
    refuse(of + " has an unknown mode");
}

void check_indices(const Primitive& primitive, const std::string& of) {
    const auto beyond = [&](std::uint32_t index) { return index >= primitive.positions.size(); };
    const bool bad = std::ranges::any_of(primitive.triangles,
                                         [&](const auto& corners) {
                                             return std::ranges::any_of(corners, beyond);
                                         }) ||
                     std::ranges::any_of(primitive.lines, [&](const auto& line) {
                         return std::ranges::any_of(line, beyond);
                     });
    if (bad) refuse(of + " refers to vertices that it does not have");
}

/// Moves positions towards morph targets.
void morph(const Document& document, Buffers& buffers, const Json& json, const Json& weights,
           std::vector<glm::dvec3>& positions, const std::string& of) {
    const Json* targets = find(json, "targets");
    if (targets == nullptr || !weights.is_array()) return;
    if (!targets->is_array()) refuse("\"targets\" of " + of + " is no list");
    for (std::size_t i = 0; i < std::min(targets->size(), weights.size()); ++i) {
        const double weight = number(weights[i], of);
        if (weight == 0 || !(*targets)[i].is_object() || find((*targets)[i], "POSITION") == nullptr)
            continue;
        const std::vector<glm::dvec3> offsets =
            read_points(document, buffers, whole((*targets)[i], "POSITION", of)).places;
        if (offsets.size() != positions.size())
            refuse("a morph target of " + of + " has another number of positions");
        for (std::size_t k = 0; k < positions.size(); ++k) positions[k] += weight * offsets[k];
    }
}

Primitive read_primitive(const Document& document, Buffers& buffers, const Json& json,
                         const Json* weights, const std::string& of) {
    if (!json.is_object()) refuse(of + " is no object");
    const Json* attributes = find_object(json, "attributes", of);
    if (attributes == nullptr) refuse(of + " has no attributes");
    Primitive primitive;
    if (find(json, "material") != nullptr) primitive.material = whole(json, "material", of);
    const Json* extensions = find_object(json, "extensions", of);
    const Json* packed = extensions != nullptr ? find_object(*extensions, draco, of) : nullptr;
    if (packed != nullptr) {
        const Json* ids = find_object(*packed, "attributes", of);
        if (ids == nullptr) refuse(of + " has no attributes in its Draco data");
        DracoMesh mesh = decode_draco(buffers.view(whole(*packed, "bufferView", of)).bytes,
                                      whole(*ids, "POSITION", of), of);
        primitive.positions = std::move(mesh.positions);
        primitive.triangles = std::move(mesh.triangles);
        primitive.step = mesh.step;
    } else {
        // Without positions there is nothing to draw (the standard allows it).
        if (find(*attributes, "POSITION") == nullptr) return primitive;
        Points points = read_points(document, buffers, whole(*attributes, "POSITION", of));
        primitive.positions = std::move(points.places);
        primitive.step = points.step;
        std::vector<std::uint32_t> indices;
        if (find(json, "indices") != nullptr) {
            indices = read_indices(document, buffers, whole(json, "indices", of));
        } else {
            indices.resize(primitive.positions.size());
            std::iota(indices.begin(), indices.end(), 0U);
        }
        connect(primitive, indices,
                Mode{whole(json, "mode", of, static_cast<std::uint64_t>(Mode::triangles))}, of);
        for (int set = 0;; ++set) {
            const std::string joints = "JOINTS_" + std::to_string(set);
            const std::string shares = "WEIGHTS_" + std::to_string(set);
            if (find(*attributes, joints.c_str()) == nullptr ||
                find(*attributes, shares.c_str()) == nullptr)
                break;
            primitive.joints.push_back(
                read_values(document, buffers, whole(*attributes, joints.c_str(), of), "VEC4", 4));
            primitive.weights.push_back(
                read_values(document, buffers, whole(*attributes, shares.c_str(), of), "VEC4", 4));
            if (primitive.joints.back().size() != primitive.positions.size() ||
                primitive.weights.back().size() != primitive.positions.size())
                refuse(of + " has joints for another number of positions");
        }
    }
    check_indices(primitive, of);
    if (weights != nullptr) morph(document, buffers, json, *weights, primitive.positions, of);
    return primitive;
}

} // namespace

std::vector<Primitive> read_mesh(const Document& document, Buffers& buffers, std::uint64_t mesh,
                                 const Json* node_weights) {
    const Json& json = element(document, "meshes", mesh);
    const std::string name = numbered("mesh", mesh);
    const Json* list = find(json, "primitives");
    if (list == nullptr || !list->is_array()) refuse(name + " has no list of primitives");
    std::vector<Primitive> primitives;
    for (std::size_t i = 0; i < list->size(); ++i) {
        primitives.push_back(
            read_primitive(document, buffers, (*list)[i],
                           node_weights != nullptr ? node_weights : find(json, "weights"),
                           numbered("primitive", i) + " of " + name));
    }
    join_borders(primitives);
    return primitives;
}

} // namespace lineatlas::gltf
