#include "placement.hpp"

#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <NCollection_DataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <gp_Trsf.hxx>

#include "shape_mesh.hpp"

namespace lineatlas::brep {

namespace {

double diagonal(const Assembly& assembly) {
    Bnd_Box all;
    for (const Instance& instance : assembly.instances) {
        Bnd_Box box;
        BRepBndLib::Add(instance.shape, box, false);
        if (!box.IsVoid()) all.Add(box.Transformed(instance.location.Transformation()));
    }
    if (all.IsVoid()) throw std::runtime_error("it holds no shape with any extent");
    if (all.IsOpen()) throw std::runtime_error("a shape in it has no end");
    return std::sqrt(all.SquareExtent());
}

/// A normal of a shape in its place.
glm::vec3 turned(const glm::dvec3& normal, const gp_Trsf& transform) {
    if (normal == glm::dvec3{0}) return glm::vec3{0};
    const gp_Vec moved = gp_Vec(normal.x, normal.y, normal.z).Transformed(transform).Normalized();
    return {moved.X(), moved.Y(), moved.Z()};
}

std::optional<EdgeCurve> placed(const std::optional<EdgeCurve>& curve, const gp_Trsf& transform) {
    if (!curve) return std::nullopt;
    const auto vector = [&](const glm::dvec3& v) {
        const gp_Vec moved = gp_Vec(v.x, v.y, v.z).Transformed(transform);
        return glm::dvec3{moved.X(), moved.Y(), moved.Z()};
    };
    const gp_Pnt center =
        gp_Pnt(curve->center.x, curve->center.y, curve->center.z).Transformed(transform);
    return EdgeCurve{.center = {center.X(), center.Y(), center.Z()},
                     .u = vector(curve->u),
                     .v = vector(curve->v)};
}

glm::dmat4x3 matrix_of(const gp_Trsf& transform) {
    glm::dmat4x3 result;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            result[column][row] = transform.Value(row + 1, column + 1);
    return result;
}

class Placement {
  public:
    Placement(Assembly&& assembly, const Drawn& drawn) : assembly_(std::move(assembly)) {
        constexpr double most_off = 0.25, chords = 24; // pixels; per circle
        fineness_ = {.deflection = drawn.deflection > 0
                                       ? drawn.deflection
                                       : most_off * diagonal(assembly_) / drawn.pixels,
                     .angle = 2 * std::numbers::pi / chords};
    }

    Soup place() {
        soup_.parts = std::move(assembly_.parts);
        soup_.notes = std::move(assembly_.notes);
        soup_.format = std::move(assembly_.format);
        soup_.unit = assembly_.unit;
        soup_.deflection = fineness_.deflection;
        // If two curved faces touch, chords of one lie off those of the other by this.
        soup_.precision = fineness_.deflection;
        for (const Instance& instance : assembly_.instances) add(instance);
        for (const auto& [part, count] : failed_)
            soup_.notes.push_back(std::to_string(count) + (count == 1 ? " face" : " faces") +
                                  " of \"" + part + "\" could not be meshed");
        return std::move(soup_);
    }

  private:
    const std::pair<std::uint32_t, ShapeMesh>& mesh_of(const TopoDS_Shape& shape) {
        if (!meshes_.IsBound(shape)) {
            const auto number = static_cast<std::uint32_t>(meshes_.Extent());
            meshes_.Bind(shape, {number, mesh_shape(shape, fineness_)});
        }
        return meshes_.Find(shape);
    }

    std::string path_of(std::uint32_t part) const {
        std::string path = soup_.parts[part].name;
        for (std::uint32_t above = soup_.parts[part].parent; above != ModelPart::none;
             above = soup_.parts[above].parent)
            path = soup_.parts[above].name + '/' + path;
        return path;
    }

    std::uint32_t group_of(const std::string& path, std::uint32_t part,
                           const std::optional<glm::vec3>& color) {
        const glm::vec3 shade = color.value_or(glm::vec3{-1});
        const auto [entry, fresh] = groups_.try_emplace(
            {part, shade.x, shade.y, shade.z}, static_cast<std::uint32_t>(soup_.groups.size()));
        if (fresh) soup_.groups.push_back({.object = path, .material = {}, .color = color});
        return entry->second;
    }

    /// The colours of a shape's faces. Open CASCADE searches the document for each of them, so this
    /// is done once for all instances.
    const std::vector<std::optional<glm::vec3>>& colors_of(std::uint32_t shape,
                                                           const ShapeMesh& mesh) {
        const auto [known, fresh] = colors_.try_emplace(shape, mesh.faces.size());
        for (std::size_t face = 0; fresh && assembly_.colors && face < mesh.faces.size(); ++face)
            known->second[face] = assembly_.colors->color(mesh.faces[face]);
        return known->second;
    }

    std::uint32_t entity_of(const TopoDS_Shape& shape) const {
        const std::uint32_t* const found =
            assembly_.entities.Seek(shape.Located(TopLoc_Location()));
        return found != nullptr ? *found : 0;
    }

    /// The surfaces of an instance's faces, by their numbers.
    std::vector<std::uint32_t> add_surfaces(const ShapeMesh& mesh, std::uint32_t number,
                                            const gp_Trsf& transform) {
        KnownSurfaces& known = soup_.surfaces;
        const auto [first, fresh] =
            first_shapes_.try_emplace(number, static_cast<std::uint32_t>(known.shapes.size()));
        std::uint32_t shape = first->second;
        std::vector<std::uint32_t> result(mesh.surfaces.size(), KnownSurfaces::none);
        for (std::size_t face = 0; face < mesh.surfaces.size(); ++face) {
            if (!mesh.surfaces[face]) continue;
            if (fresh) known.shapes.push_back(*mesh.surfaces[face]);
            result[face] = static_cast<std::uint32_t>(known.surfaces.size());
            known.surfaces.push_back({.shape = shape++,
                                      .entity = entity_of(mesh.faces[face]),
                                      .turned = mesh.turned[face],
                                      .model_from_shape = matrix_of(transform)});
        }
        return result;
    }

    void add(const Instance& instance) {
        const auto& [shape, mesh] = mesh_of(instance.shape);
        ModelPart& part = soup_.parts[instance.part];
        part.object = objects_++;
        part.shape = shape;
        if (mesh.failed_faces > 0) failed_[part.name] += mesh.failed_faces;

        constexpr std::size_t most = 0xFFFFFFF0U;
        if (soup_.positions.size() + mesh.positions.size() > most)
            throw std::runtime_error("with all its instances it has more than 4294967280 vertices");
        const auto first = static_cast<std::uint32_t>(soup_.positions.size());
        const gp_Trsf transform = instance.location.Transformation();
        for (const glm::dvec3& position : mesh.positions) {
            const gp_Pnt moved = gp_Pnt(position.x, position.y, position.z).Transformed(transform);
            soup_.positions.emplace_back(moved.X(), moved.Y(), moved.Z());
        }
        const std::string path = path_of(instance.part);
        std::vector<std::uint32_t> group_of_face;
        for (const std::optional<glm::vec3>& color : colors_of(shape, mesh))
            group_of_face.push_back(group_of(path, instance.part, color ? color : instance.color));
        const std::vector<std::uint32_t> surface_of_face = add_surfaces(mesh, shape, transform);
        const bool mirrored = transform.IsNegative();
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const auto& corners = mesh.triangles[i];
            const std::array face{first + corners[0], first + corners[mirrored ? 2 : 1],
                                  first + corners[mirrored ? 1 : 2]};
            soup_.add_face(face);
            soup_.face_group.push_back(group_of_face[mesh.triangle_face[i]]);
            soup_.face_object.push_back(part.object);
            const auto& normals = mesh.normals[i];
            soup_.surfaces.of_triangle.push_back(surface_of_face[mesh.triangle_face[i]]);
            soup_.surfaces.parameters.push_back(mesh.parameters[i]);
            if (mirrored)
                std::swap(soup_.surfaces.parameters.back()[1], soup_.surfaces.parameters.back()[2]);
            for (const std::size_t corner : mirrored ? std::array<std::size_t, 3>{0, 2, 1}
                                                     : std::array<std::size_t, 3>{0, 1, 2})
                soup_.corner_normals.push_back(turned(normals[corner], transform));
        }
        for (const KnownEdge& edge : mesh.edges)
            soup_.known_edges.push_back(
                {first + edge.from, first + edge.to, edge.kind, edges_ + edge.edge});
        edges_ += mesh.edge_count;
        for (const TopoDS_Shape& edge : mesh.edge_shapes)
            soup_.edge_entities.push_back(entity_of(edge));
        for (const std::optional<EdgeCurve>& curve : mesh.edge_curves)
            soup_.edge_curves.push_back(placed(curve, transform));
        for (const std::vector<std::uint32_t>& line : mesh.lines) {
            soup_.polylines.push_back(line);
            for (std::uint32_t& point : soup_.polylines.back()) point += first;
            soup_.polyline_object.push_back(part.object);
        }
    }

    Assembly assembly_;
    Fineness fineness_;
    Soup soup_;
    NCollection_DataMap<TopoDS_Shape, std::pair<std::uint32_t, ShapeMesh>, TopTools_ShapeMapHasher>
        meshes_;
    std::map<std::tuple<std::uint32_t, float, float, float>, std::uint32_t> groups_;
    std::map<std::string, std::size_t> failed_;
    std::map<std::uint32_t, std::vector<std::optional<glm::vec3>>> colors_; ///< by mesh_of()
    /// First shapes of meshes, by their numbers.
    std::map<std::uint32_t, std::uint32_t> first_shapes_;
    std::uint32_t objects_ = 0, edges_ = 0;
};

} // namespace

Soup place(Assembly&& assembly, const Drawn& drawn) {
    return Placement{std::move(assembly), drawn}.place();
}

} // namespace lineatlas::brep
