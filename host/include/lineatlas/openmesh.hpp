#pragma once

/// @file
/// For programs that use OpenMesh. This header includes nothing of OpenMesh, and makes no library
/// of lineatlas depend on it. Include the kernel of your meshes, too.
/// @code{.cpp}
/// OpenMeshModel model{part};
/// model.set_groups(material_of_face);
/// const LineSet found = extract_lines(model.mesh());
/// const auto edge = model.edge(found.sources.front()); // the way back
/// @endcode

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "lineatlas/exact_arrays.hpp"
#include "lineatlas/lines.hpp"
#include "lineatlas/mesh.hpp"

namespace lineatlas {

/// Which normals of an OpenMesh mesh are taken for those of its surface (Mesh::corner_normals), if
/// the mesh has them.
enum class OpenMeshNormals : std::uint32_t {
    none,
    halfedges, ///< one per face and corner: they may differ on the two sides of a crease
    vertices,  ///< one for all faces around a vertex: for meshes without creases
};

/// What is taken from an OpenMesh mesh in addition to its positions and faces.
struct OpenMeshOptions {
    /// Edges with the status bit FEATURE are creases, however small their angle
    /// (KnownEdge::Kind::marked); the number of such a KnownEdge is that of its edge handle.
    bool features = true;
    OpenMeshNormals normals = OpenMeshNormals::halfedges; ///< scaled to unit length
};

/// A Mesh made of an OpenMesh mesh of any kernel (`HalfedgeMesh`, such as
/// OpenMesh::PolyMesh_ArrayKernelT<>), with the way back from its lines to edges and from its
/// triangles to faces.
///
/// mesh() is a copy. Edges and faces are looked up in the OpenMesh mesh, which must outlive this
/// object and keep its vertices, edges and faces. Its positions and properties may change.
template <class HalfedgeMesh>
class OpenMeshModel {
  public:
    /// OpenMesh's handle of an edge.
    using EdgeHandle = typename HalfedgeMesh::EdgeHandle;
    /// OpenMesh's handle of a face.
    using FaceHandle = typename HalfedgeMesh::FaceHandle;

    /// Takes faces that are neither deleted nor hidden; garbage need not be collected. Polygons
    /// become triangles, concave ones included. extract_lines() refuses a position that is no
    /// finite float after the origin was subtracted, as in any mesh.
    explicit OpenMeshModel(const HalfedgeMesh& source, const OpenMeshOptions& options = {})
        : source_(&source) {
        place_vertices();
        const bool by_halfedges =
            options.normals == OpenMeshNormals::halfedges && source.has_halfedge_normals();
        const bool by_vertices =
            options.normals == OpenMeshNormals::vertices && source.has_vertex_normals();
        for_each_face([&](FaceHandle face) {
            add_face(face);
            if (by_halfedges)
                add_normals([&](auto halfedge) { return source.normal(halfedge); });
            else if (by_vertices)
                add_normals([&](auto halfedge) {
                    return source.normal(source.to_vertex_handle(halfedge));
                });
        });
        if (options.features && source.has_edge_status()) mark_features();
    }

    /// The mesh in the units of the OpenMesh mesh, relative to origin(). Position i is that of the
    /// vertex with the index i, even if no face has this vertex.
    const Mesh& mesh() const { return mesh_; }

    /// The origin that was subtracted from every position (ExactMesh::origin).
    glm::dvec3 origin() const { return origin_; }

    /// The face that a triangle of mesh() is, or that it is a part of.
    FaceHandle face(std::uint32_t triangle) const { return faces_.at(triangle); }

    /// The edge that a line runs along; for an Interval, `line` is
    /// `LineSet::sources[interval.segment]`. Invalid if there is no edge: for a smooth silhouette,
    /// an intersection, a line of the program's own, and between triangles of one polygon. If
    /// several edges lie at one place, one of them.
    EdgeHandle edge(const LineSource& line) const {
        const std::size_t count = source_->n_vertices();
        if (line.triangle == LineSource::none || line.from >= count || line.to >= count)
            return EdgeHandle{};
        const auto halfedge = source_->find_halfedge(vertex(line.from), vertex(line.to));
        return halfedge.is_valid() ? source_->edge_handle(halfedge) : EdgeHandle{};
    }

    /// Makes groups of a property of faces (OpenMesh::FPropHandleT), of numbers or strings: faces
    /// with equal values are a group, whose material is the value as text (Mesh::groups). The
    /// borders of groups are material lines. The mesh must have the property.
    template <class FaceProperty>
    void set_groups(const FaceProperty& property) {
        using Value = std::decay_t<decltype(source_->property(property, FaceHandle{}))>;
        std::map<Value, std::uint32_t> numbers;
        mesh_.groups.clear();
        mesh_.triangle_group.clear();
        for (const FaceHandle face : faces_) {
            const Value& value = source_->property(property, face);
            const auto fresh = static_cast<std::uint32_t>(mesh_.groups.size());
            const auto [entry, added] = numbers.try_emplace(value, fresh);
            if (added) mesh_.groups.push_back({.object = {}, .material = text_of(value)});
            mesh_.triangle_group.push_back(entry->second);
        }
    }

  private:
    using VertexHandle = typename HalfedgeMesh::VertexHandle;
    using HalfedgeHandle = typename HalfedgeMesh::HalfedgeHandle;

    static VertexHandle vertex(std::uint32_t index) {
        return VertexHandle{static_cast<int>(index)};
    }
    static const std::string& text_of(const std::string& value) { return value; }
    template <class Number>
    static std::string text_of(Number value) {
        return std::to_string(value);
    }

    template <class Visit>
    void for_each_face(const Visit& visit) const {
        for (auto face = source_->faces_sbegin(); face != source_->faces_end(); ++face)
            visit(FaceHandle{*face});
    }

    /// The halfedges of a face and the vertices that they lead to.
    void walk(FaceHandle face) {
        halfedges_.clear();
        corners_.clear();
        for (auto halfedge = source_->cfh_iter(face); halfedge.is_valid(); ++halfedge) {
            halfedges_.push_back(*halfedge);
            corners_.push_back(
                static_cast<std::uint32_t>(source_->to_vertex_handle(*halfedge).idx()));
        }
    }

    /// Triangles in place of the faces only say which vertices count for the origin.
    void place_vertices() {
        std::vector<double> positions;
        positions.reserve(3 * source_->n_vertices());
        for (std::uint32_t i = 0; i < source_->n_vertices(); ++i)
            for (std::size_t axis = 0; axis < 3; ++axis)
                positions.push_back(static_cast<double>(source_->point(vertex(i))[axis]));
        std::vector<std::uint32_t> used;
        for_each_face([&](FaceHandle face) {
            walk(face);
            for (const std::uint32_t corner : corners_) used.insert(used.end(), 3, corner);
        });
        // Of no index at all, vertices would be corners of triangles as they come.
        if (used.empty()) used.assign(positions.size(), 0);
        ExactMesh placed = make_mesh(ExactArrays{.positions = positions, .indices = used});
        mesh_.positions = std::move(placed.mesh.positions);
        origin_ = placed.origin;
    }

    void add_face(FaceHandle face) {
        walk(face);
        add_polygon(mesh_, corners_);
        faces_.resize(mesh_.triangles.size(), face);
    }

    /// To the triangles of the face that was added last.
    template <class NormalAt>
    void add_normals(const NormalAt& normal_at) {
        for (std::size_t i = mesh_.corner_normals.size() / 3; i < mesh_.triangles.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const auto place = std::ranges::find(corners_, mesh_.triangles[i][k]);
                const auto corner = static_cast<std::size_t>(place - corners_.begin());
                mesh_.corner_normals.push_back(unit(normal_at(halfedges_[corner])));
            }
    }

    /// Zero where it has no length or is no vector of finite numbers.
    template <class Vector>
    static glm::vec3 unit(const Vector& given) {
        const glm::dvec3 normal{given[0], given[1], given[2]};
        const double length = std::hypot(normal.x, normal.y, normal.z);
        return std::isnormal(length) ? glm::vec3{normal / length} : glm::vec3{0};
    }

    void mark_features() {
        for (auto edge = source_->edges_sbegin(); edge != source_->edges_end(); ++edge) {
            if (!source_->status(*edge).feature()) continue;
            const HalfedgeHandle halfedge = source_->halfedge_handle(EdgeHandle{*edge}, 0);
            mesh_.known_edges.push_back(
                {.from = static_cast<std::uint32_t>(source_->from_vertex_handle(halfedge).idx()),
                 .to = static_cast<std::uint32_t>(source_->to_vertex_handle(halfedge).idx()),
                 .kind = KnownEdge::Kind::marked,
                 .edge = static_cast<std::uint32_t>(edge->idx())});
        }
    }

    const HalfedgeMesh* source_;
    Mesh mesh_;
    glm::dvec3 origin_{0};
    std::vector<FaceHandle> faces_;         // per triangle
    std::vector<HalfedgeHandle> halfedges_; // of the face at hand
    std::vector<std::uint32_t> corners_;    // of the face at hand
};

} // namespace lineatlas
