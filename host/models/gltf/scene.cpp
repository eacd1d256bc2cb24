#include "scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include "models/part_names.hpp"
#include "primitives.hpp"

namespace lineatlas::gltf {

namespace {

constexpr std::uint32_t no_part = ModelPart::none;

/// Linear light as sRGB.
float coded(double linear) {
    linear = std::isfinite(linear) ? std::clamp(linear, 0.0, 1.0) : 0.0;
    const double value =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    return static_cast<float>(value);
}

/// The placement of a node or an instance.
struct Placement {
    std::array<double, 3> translation{}, scale{1, 1, 1};
    std::array<double, 4> rotation{0, 0, 0, 1};

    glm::dmat4 matrix() const {
        glm::dmat4 matrix =
            glm::mat4_cast(glm::dquat{rotation[3], rotation[0], rotation[1], rotation[2]});
        for (int axis = 0; axis < 3; ++axis) {
            matrix[axis] *= scale[static_cast<std::size_t>(axis)];
            matrix[3][axis] = translation[static_cast<std::size_t>(axis)];
        }
        return matrix;
    }
};

glm::dmat4 local_matrix(const Json& node, const std::string& of) {
    std::array<double, 16> columns{};
    glm::dmat4 matrix{1};
    if (read_numbers(node, "matrix", of, columns)) {
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = columns[static_cast<std::size_t>(i)];
        return matrix;
    }
    Placement placement;
    read_numbers(node, "translation", of, placement.translation);
    read_numbers(node, "rotation", of, placement.rotation);
    read_numbers(node, "scale", of, placement.scale);
    return placement.matrix();
}

struct Node {
    bool visited = false;
    bool hidden = false;  ///< by KHR_node_visibility of the node or of a node above it
    glm::dmat4 matrix{1}; ///< to the world
    std::uint32_t part = no_part;
    std::string path; ///< its name behind the names of nodes above it
};

class Scene {
  public:
    Scene(const Document& document, Buffers& buffers)
        : document_(document), buffers_(buffers), nodes_(count(document, "nodes")) {}

    Soup read() {
        // Joints may lie anywhere in the tree, so the whole tree is made before a mesh is placed.
        for (const std::uint64_t root : roots()) add_tree(root);
        for (const std::uint64_t node : order_) place_mesh(node);
        if (points_ > 0)
            soup_.notes.push_back(std::to_string(points_) + (points_ == 1 ? " set" : " sets") +
                                  " of points left out");
        if (hidden_meshes_ > 0)
            soup_.notes.push_back(std::to_string(hidden_meshes_) +
                                  (hidden_meshes_ == 1 ? " mesh" : " meshes") +
                                  " left out, which the file itself hides");
        soup_.format = "glTF 2.0";
        soup_.up = glm::vec3{0, 1, 0};
        soup_.unit = 1000;
        return std::move(soup_);
    }

  private:
    std::vector<std::uint64_t> list_of(const Json& object, const char* key,
                                       const std::string& of) const {
        std::vector<std::uint64_t> indices;
        const Json* list = find(object, key);
        if (list == nullptr) return indices;
        if (!list->is_array()) refuse(std::string{"\""} + key + "\" of " + of + " is no list");
        for (const Json& index : *list) indices.push_back(whole(index, of));
        return indices;
    }

    std::vector<std::uint64_t> roots() const {
        if (count(document_, "scenes") > 0) {
            const std::uint64_t scene = whole(document_.json, "scene", "the file", 0);
            return list_of(element(document_, "scenes", scene), "nodes", numbered("scene", scene));
        }
        // A file without scenes is a library of parts, and all parts are shown.
        std::vector<bool> child(nodes_.size());
        for (std::uint64_t i = 0; i < nodes_.size(); ++i)
            for (const std::uint64_t index :
                 list_of(element(document_, "nodes", i), "children", numbered("node", i)))
                if (index < child.size()) child[index] = true;
        std::vector<std::uint64_t> found;
        for (std::uint64_t i = 0; i < nodes_.size(); ++i)
            if (!child[i]) found.push_back(i);
        return found;
    }

    void add_tree(std::uint64_t root) {
        struct Step {
            std::uint64_t node, parent;
            int level;
        };
        constexpr std::uint64_t nobody = ~std::uint64_t{0};
        constexpr int most_levels = 1000;
        std::vector<Step> left{{root, nobody, 0}};
        while (!left.empty()) {
            const auto [index, parent, level] = left.back();
            left.pop_back();
            const Json& json = element(document_, "nodes", index);
            const std::string of = numbered("node", index);
            Node& node = nodes_[index];
            if (std::exchange(node.visited, true))
                refuse(of + " has two places in the tree, or is part of itself");
            if (level > most_levels) refuse("its nodes are nested more than 1000 deep");
            const Node* above = parent != nobody ? &nodes_[parent] : nullptr;
            node.matrix = local_matrix(json, of);
            if (above != nullptr) node.matrix = above->matrix * node.matrix;
            node.hidden = (above != nullptr && above->hidden) || hides_itself(json, of);
            const std::string name = models::part_name(text(json, "name", ""), of);
            node.path = above != nullptr ? above->path + '/' + name : name;
            node.part = static_cast<std::uint32_t>(soup_.parts.size());
            soup_.parts.push_back({.name = name, .parent = above ? above->part : no_part});
            order_.push_back(index);
            const std::vector<std::uint64_t> children = list_of(json, "children", of);
            for (auto child = children.rbegin(); child != children.rend(); ++child)
                left.push_back({*child, index, level + 1});
        }
    }

    static bool hides_itself(const Json& json, const std::string& of) {
        const Json* extension = extension_of(json, "KHR_node_visibility", of);
        if (extension == nullptr) return false;
        const Json* visible = find(*extension, "visible");
        return visible != nullptr && visible->is_boolean() && !visible->get<bool>();
    }

    static const Json* extension_of(const Json& object, const char* name, const std::string& of) {
        const Json* extensions = find_object(object, "extensions", of);
        return extensions != nullptr ? find_object(*extensions, name, of) : nullptr;
    }

    const std::vector<Primitive>& mesh_of(const Json& node, const std::string& of) {
        const Json* weights = find(node, "weights");
        const std::uint64_t mesh = whole(node, "mesh", of);
        if (weights != nullptr) {
            posed_ = read_mesh(document_, buffers_, mesh, weights);
            return posed_;
        }
        auto known = meshes_.find(mesh);
        if (known == meshes_.end())
            known = meshes_.emplace(mesh, read_mesh(document_, buffers_, mesh, nullptr)).first;
        return known->second;
    }

    void place_mesh(std::uint64_t index) {
        const Json& json = element(document_, "nodes", index);
        const std::string of = numbered("node", index);
        if (find(json, "mesh") == nullptr) return;
        const Node& node = nodes_[index];
        if (node.hidden) {
            ++hidden_meshes_;
            return;
        }
        const Json* instancing = extension_of(json, "EXT_mesh_gpu_instancing", of);
        if (instancing == nullptr) return place(node, json, of);
        const std::string name = soup_.parts[node.part].name;
        std::size_t number = 0;
        for (const glm::dmat4& matrix : instance_matrices(*instancing, of)) {
            if (soup_.parts.size() >= most_parts) refuse_many_parts();
            const std::string own_name = name + ' ' + std::to_string(++number);
            const Node instance{.matrix = node.matrix * matrix,
                                .part = static_cast<std::uint32_t>(soup_.parts.size()),
                                .path = node.path + '/' + own_name};
            soup_.parts.push_back({.name = own_name, .parent = node.part});
            place(instance, json, of);
        }
    }

    static constexpr std::size_t most_parts = 1U << 18U;
    [[noreturn]] static void refuse_many_parts() {
        refuse("with all its instances it has more than 262144 parts");
    }

    /// The matrices of EXT_mesh_gpu_instancing for a node's mesh, relative to the node.
    std::vector<glm::dmat4> instance_matrices(const Json& extension, const std::string& node) {
        const std::string of = "the instances of " + node;
        const Json* attributes = find_object(extension, "attributes", of);
        if (attributes == nullptr) refuse(of + " have no \"attributes\"");
        std::optional<std::size_t> count;
        const auto read = [&](const char* key, const char* type, std::uint64_t width) {
            if (find(*attributes, key) == nullptr) return Values{.width = width, .numbers = {}};
            Values values =
                read_values(document_, buffers_, whole(*attributes, key, of), type, width);
            if (count && *count != values.size()) refuse(of + " differ in number by attribute");
            count = values.size();
            if (*count > most_parts) refuse_many_parts();
            return values;
        };
        const Values translations = read("TRANSLATION", "VEC3", 3);
        const Values rotations = read("ROTATION", "VEC4", 4);
        const Values scales = read("SCALE", "VEC3", 3);
        if (!count) refuse(of + " have no place");
        std::vector<glm::dmat4> matrices;
        for (std::size_t i = 0; i < *count; ++i) {
            Placement placement;
            if (translations.size() > 0)
                std::copy_n(translations[i], 3, placement.translation.begin());
            if (rotations.size() > 0) std::copy_n(rotations[i], 4, placement.rotation.begin());
            if (scales.size() > 0) std::copy_n(scales[i], 3, placement.scale.begin());
            matrices.push_back(placement.matrix());
        }
        return matrices;
    }

    void place(const Node& node, const Json& json, const std::string& of) {
        const std::uint32_t object = objects_++;
        soup_.parts[node.part].object = object;
        soup_.parts[node.part].shape = static_cast<std::uint32_t>(whole(json, "mesh", of));
        const std::optional<std::vector<glm::dmat4>> joints = joint_matrices(json, of);
        for (const Primitive& primitive : mesh_of(json, of)) {
            if (primitive.points) ++points_;
            add(primitive, node, object, joints);
        }
    }

    /// The matrices of joints; nothing if the node has no skin.
    std::optional<std::vector<glm::dmat4>> joint_matrices(const Json& node, const std::string& of) {
        if (find(node, "skin") == nullptr) return std::nullopt;
        const std::uint64_t index = whole(node, "skin", of);
        const std::string skin_name = numbered("skin", index);
        const Json& skin = element(document_, "skins", index);
        const std::vector<std::uint64_t> joints = list_of(skin, "joints", skin_name);
        std::vector<glm::dmat4> matrices;
        for (const std::uint64_t joint : joints) {
            if (joint >= nodes_.size() || !nodes_[joint].visited)
                refuse(skin_name + " has a joint that is not in the scene");
            matrices.push_back(nodes_[joint].matrix);
        }
        if (find(skin, "inverseBindMatrices") == nullptr) return matrices;
        const Values inverse = read_values(
            document_, buffers_, whole(skin, "inverseBindMatrices", skin_name), "MAT4", 16);
        if (inverse.size() < matrices.size()) refuse(skin_name + " has fewer matrices than joints");
        for (std::size_t i = 0; i < matrices.size(); ++i) {
            glm::dmat4 bind{1};
            for (int k = 0; k < 16; ++k) bind[k / 4][k % 4] = inverse[i][k];
            matrices[i] = matrices[i] * bind;
        }
        return matrices;
    }

    /// The position that a skin gives a point: the mean of the positions by its joints. The node
    /// itself moves nothing.
    static glm::dvec3 skinned(const Primitive& primitive, std::size_t i,
                              const std::vector<glm::dmat4>& joints, const std::string& of) {
        glm::dvec3 sum{0};
        double whole_weight = 0;
        for (std::size_t set = 0; set < primitive.joints.size(); ++set) {
            for (int k = 0; k < 4; ++k) {
                const double weight = primitive.weights[set][i][k];
                const double joint = primitive.joints[set][i][k];
                if (weight == 0) continue;
                if (!(joint >= 0 && joint < static_cast<double>(joints.size())))
                    refuse("the mesh of " + of + " has joints that its skin does not have");
                sum += weight * glm::dvec3{joints[static_cast<std::size_t>(joint)] *
                                           glm::dvec4{primitive.positions[i], 1}};
                whole_weight += weight;
            }
        }
        return whole_weight != 0 ? sum / whole_weight : primitive.positions[i];
    }

    void add(const Primitive& primitive, const Node& node, std::uint32_t object,
             const std::optional<std::vector<glm::dmat4>>& joints) {
        if (primitive.triangles.empty() && primitive.lines.empty()) return;
        constexpr std::size_t most = 0xFFFFFFF0U;
        if (soup_.positions.size() + primitive.positions.size() > most)
            refuse("with all its instances it has more than 4294967280 vertices");
        const auto first = static_cast<std::uint32_t>(soup_.positions.size());
        const bool moved_by_joints = joints && !primitive.joints.empty();
        for (std::size_t i = 0; i < primitive.positions.size(); ++i) {
            soup_.positions.push_back(
                moved_by_joints ? skinned(primitive, i, *joints, node.path)
                                : glm::dvec3{node.matrix * glm::dvec4{primitive.positions[i], 1}});
        }
        // A mirror turns triangles inside out.
        const bool mirrored = !moved_by_joints && glm::determinant(glm::dmat3{node.matrix}) < 0;
        // Half a step in each of three directions, scaled by the node.
        const glm::dmat3 turn{node.matrix};
        const double scale =
            std::max({glm::length(turn[0]), glm::length(turn[1]), glm::length(turn[2])});
        soup_.precision =
            std::max(soup_.precision, 0.5 * std::numbers::sqrt3 * primitive.step * scale);
        const std::uint32_t group = group_of(node, primitive.material);
        for (const auto& corners : primitive.triangles) {
            const std::array face{first + corners[0], first + corners[mirrored ? 2 : 1],
                                  first + corners[mirrored ? 1 : 2]};
            soup_.add_face(face);
            soup_.face_group.push_back(group);
            soup_.face_object.push_back(object);
        }
        for (const std::vector<std::uint32_t>& line : primitive.lines) {
            soup_.polylines.push_back(line);
            for (std::uint32_t& point : soup_.polylines.back()) point += first;
            soup_.polyline_object.push_back(object);
        }
    }

    std::uint32_t group_of(const Node& node, std::optional<std::uint64_t> material) {
        const auto [entry, fresh] =
            groups_.try_emplace({node.part, material.value_or(~std::uint64_t{0})},
                                static_cast<std::uint32_t>(soup_.groups.size()));
        if (!fresh) return entry->second;
        MeshGroup group{.object = node.path, .material = {}};
        if (material) {
            const Json& json = element(document_, "materials", *material);
            const std::string of = numbered("material", *material);
            group.material = models::part_name(text(json, "name", ""), of);
            group.color = color_of(json, of);
        }
        soup_.groups.push_back(std::move(group));
        return entry->second;
    }

    /// The colour of a material; nothing if a picture has it.
    static std::optional<glm::vec3> color_of(const Json& material, const std::string& of) {
        const Json* older = extension_of(material, "KHR_materials_pbrSpecularGlossiness", of);
        const Json* surface =
            older != nullptr ? older : find_object(material, "pbrMetallicRoughness", of);
        if (surface == nullptr) return glm::vec3{1};
        if (find(*surface, older ? "diffuseTexture" : "baseColorTexture") != nullptr)
            return std::nullopt;
        std::array<double, 4> factor{1, 1, 1, 1};
        read_numbers(*surface, older ? "diffuseFactor" : "baseColorFactor", of, factor);
        return glm::vec3{coded(factor[0]), coded(factor[1]), coded(factor[2])};
    }

    const Document& document_;
    Buffers& buffers_;
    std::vector<Node> nodes_;
    std::vector<std::uint64_t> order_; ///< order of the nodes in the scene
    std::map<std::uint64_t, std::vector<Primitive>> meshes_;
    std::vector<Primitive> posed_; ///< primitives posed by a node's own weights
    std::map<std::pair<std::uint32_t, std::uint64_t>, std::uint32_t> groups_;
    std::uint32_t objects_ = 0;
    std::size_t points_ = 0;
    std::size_t hidden_meshes_ = 0;
    Soup soup_;
};

} // namespace

Soup read_scene(const Document& document, Buffers& buffers) {
    return Scene{document, buffers}.read();
}

} // namespace lineatlas::gltf
