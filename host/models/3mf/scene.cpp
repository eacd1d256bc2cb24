#include "scene.hpp"

#include <array>
#include <map>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "models/part_names.hpp"
#include "object_mesh.hpp"
#include "refusal.hpp"

namespace lineatlas::threemf {

namespace {

glm::dmat4 matrix_of(const NMR::MODELTRANSFORM& transform) {
    glm::dmat4 matrix{1};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = double{transform.m_fFields[row][column]};
    return matrix;
}

/// The length of a unit in millimetres.
double length_of(DWORD unit) {
    constexpr std::array<double, 6> lengths{0.001, 1, 10, 25.4, 304.8, 1000};
    return lengths.at(unit);
}

class Scene {
  public:
    explicit Scene(const Handle& model) : model_(model) {}

    Soup read() {
        const Handle items = get(model_, NMR::lib3mf_model_getbuilditems);
        while (value<BOOL>(items, NMR::lib3mf_builditemiterator_movenext) != 0) {
            const Handle item = get(items, NMR::lib3mf_builditemiterator_getcurrent);
            add_tree({.object = get(item, NMR::lib3mf_builditem_getobjectresource),
                      .matrix = matrix_of(value<NMR::MODELTRANSFORM>(
                          item, NMR::lib3mf_builditem_getobjecttransform))});
        }
        if (soup_.parts.empty()) refuse("its list of what is to be built is empty");
        if (sliced_ > 0)
            soup_.notes.push_back("slices of " + std::to_string(sliced_) +
                                  (sliced_ == 1 ? " object" : " objects") +
                                  " are not read; what is drawn is its mesh, which may be coarser");
        soup_.format = "3MF";
        soup_.up = glm::vec3{0, 0, 1}; // away from the plate that it is printed on
        soup_.unit = length_of(value<DWORD>(model_, NMR::lib3mf_model_getunit));
        return std::move(soup_);
    }

  private:
    struct Step {
        Handle object;
        glm::dmat4 matrix{1}; ///< to the world
        std::uint32_t parent = ModelPart::none;
        std::string path{}; ///< path of the part that contains it, with a slash
        int level = 0;
    };

    /// Adds a tree, depth first, in the order of the file. lib3mf lets components refer only to
    /// earlier objects, so no object contains itself. But a few objects can contain each other
    /// thousands of times.
    void add_tree(Step root) {
        constexpr int most_levels = 100;
        constexpr std::size_t most_parts = 1U << 18U;
        std::vector<Step> left;
        left.push_back(std::move(root));
        while (!left.empty()) {
            const Step step = std::move(left.back());
            left.pop_back();
            if (step.level > most_levels) refuse("its components are nested more than 100 deep");
            if (soup_.parts.size() >= most_parts)
                refuse("with all its components it has more than 262144 parts");
            const auto id = value<DWORD>(step.object, NMR::lib3mf_resource_getresourceid);
            const std::string name = models::part_name(
                text(step.object, NMR::lib3mf_object_getnameutf8), "object " + std::to_string(id));
            const auto part = static_cast<std::uint32_t>(soup_.parts.size());
            soup_.parts.push_back({.name = name, .parent = step.parent});
            if (value<BOOL>(step.object, NMR::lib3mf_object_ismeshobject) != 0)
                place(mesh_of(id, step.object), step.matrix, part, step.path + name);
            else
                add_components(step, part, step.path + name + '/', left);
        }
    }

    static void add_components(const Step& of, std::uint32_t part, const std::string& path,
                               std::vector<Step>& left) {
        const auto count = value<DWORD>(of.object, NMR::lib3mf_componentsobject_getcomponentcount);
        for (DWORD i = count; i-- > 0;) {
            const Handle component = get(of.object, NMR::lib3mf_componentsobject_getcomponent, i);
            left.push_back(
                {.object = get(component, NMR::lib3mf_component_getobjectresource),
                 .matrix = of.matrix * matrix_of(value<NMR::MODELTRANSFORM>(
                                           component, NMR::lib3mf_component_gettransform)),
                 .parent = part,
                 .path = path,
                 .level = of.level + 1});
        }
    }

    struct Shape {
        std::uint32_t number;
        ObjectMesh mesh;
    };

    const Shape& mesh_of(DWORD id, const Handle& object) {
        auto known = shapes_.find(id);
        if (known == shapes_.end()) {
            const auto number = static_cast<std::uint32_t>(shapes_.size());
            if (value<DWORD>(object, NMR::lib3mf_meshobject_getslicestackid) != 0) ++sliced_;
            known = shapes_.emplace(id, Shape{number, read_mesh(model_, object)}).first;
        }
        return known->second;
    }

    void place(const Shape& shape, const glm::dmat4& matrix, std::uint32_t part,
               const std::string& path) {
        const ObjectMesh& mesh = shape.mesh;
        const std::uint32_t object = objects_++;
        soup_.parts[part].object = object;
        soup_.parts[part].shape = shape.number;
        constexpr std::size_t most = 0xFFFFFFF0U;
        if (soup_.positions.size() + mesh.positions.size() > most)
            refuse("with all its components it has more than 4294967280 vertices");
        const auto first = static_cast<std::uint32_t>(soup_.positions.size());
        for (const glm::dvec3& position : mesh.positions)
            soup_.positions.emplace_back(matrix * glm::dvec4{position, 1});
        std::vector<std::uint32_t> groups;
        for (const Material& material : mesh.materials) groups.push_back(add_group(path, material));
        // A mirror turns triangles inside out.
        const bool mirrored = glm::determinant(glm::dmat3{matrix}) < 0;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const auto& corners = mesh.triangles[i];
            const std::array face{first + corners[0], first + corners[mirrored ? 2 : 1],
                                  first + corners[mirrored ? 1 : 2]};
            soup_.add_face(face);
            soup_.face_group.push_back(groups[mesh.triangle_material[i]]);
            soup_.face_object.push_back(object);
        }
    }

    std::uint32_t add_group(const std::string& path, const Material& material) {
        soup_.groups.push_back(
            {.object = path, .material = material.name, .color = material.color});
        return static_cast<std::uint32_t>(soup_.groups.size() - 1);
    }

    const Handle& model_;
    std::map<DWORD, Shape> shapes_; ///< by the object's number
    std::uint32_t objects_ = 0;
    std::size_t sliced_ = 0; ///< objects that have slices too
    Soup soup_;
};

} // namespace

Soup read_scene(const Handle& model) {
    return Scene{model}.read();
}

} // namespace lineatlas::threemf
