#pragma once

#include <cstdint>
#include <vector>

#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/Mesh/BaseKernel.hh>

#include "soup.hpp"

namespace lineatlas {

/// Takes the contents of a file from OpenMesh's reader as a soup. A halfedge mesh would drop or
/// split faces at non-manifold edges. Attributes other than positions are ignored, faces are taken
/// as they are. OM files describe halfedges. Faces are found by walking them once all halfedges are
/// there.
class SoupImporter final : public OpenMesh::IO::BaseImporter {
    using VertexHandle = OpenMesh::VertexHandle;
    using HalfedgeHandle = OpenMesh::HalfedgeHandle;
    using EdgeHandle = OpenMesh::EdgeHandle;
    using FaceHandle = OpenMesh::FaceHandle;
    using Status = OpenMesh::Attributes::StatusInfo;

  public:
    using BaseImporter::add_vertex;

    /// Adds the faces of an OM file. Returns false if halfedges do not close to faces.
    bool add_halfedge_faces();

    Soup take() { return std::move(soup_); }

    VertexHandle add_vertex(const OpenMesh::Vec3f& point) override;
    VertexHandle add_vertex() override { return add_vertex(OpenMesh::Vec3f(0.0F)); }
    void set_point(VertexHandle vertex, const OpenMesh::Vec3f& point) override;
    FaceHandle add_face(const VHandles& corners) override;
    FaceHandle add_face(HalfedgeHandle halfedge) override;
    HalfedgeHandle add_edge(VertexHandle from, VertexHandle to) override;
    void set_next(HalfedgeHandle halfedge, HalfedgeHandle next) override;

    std::size_t n_vertices() const override { return soup_.positions.size(); }
    std::size_t n_faces() const override { return soup_.face_ends.size() + face_halfedge_.size(); }
    std::size_t n_edges() const override { return target_.size() / 2; }

    // The OM reader refuses importers without a kernel, although it needs the kernel only for
    // custom properties.
    OpenMesh::BaseKernel* kernel() override { return &kernel_; }

    void set_face(HalfedgeHandle, FaceHandle) override {}
    void set_halfedge(VertexHandle, HalfedgeHandle) override {}
    void add_face_texcoords(FaceHandle, VertexHandle,
                            const std::vector<OpenMesh::Vec2f>&) override {}
    void add_face_texcoords(FaceHandle, VertexHandle,
                            const std::vector<OpenMesh::Vec3f>&) override {}
    void set_face_texindex(FaceHandle, int) override {}
    void set_normal(VertexHandle, const OpenMesh::Vec3f&) override {}
    void set_normal(VertexHandle, const OpenMesh::Vec3d&) override {}
    void set_normal(FaceHandle, const OpenMesh::Vec3f&) override {}
    void set_normal(FaceHandle, const OpenMesh::Vec3d&) override {}
    void set_color(VertexHandle, const OpenMesh::Vec3uc&) override {}
    void set_color(VertexHandle, const OpenMesh::Vec4uc&) override {}
    void set_color(VertexHandle, const OpenMesh::Vec3f&) override {}
    void set_color(VertexHandle, const OpenMesh::Vec4f&) override {}
    void set_color(EdgeHandle, const OpenMesh::Vec3uc&) override {}
    void set_color(EdgeHandle, const OpenMesh::Vec4uc&) override {}
    void set_color(EdgeHandle, const OpenMesh::Vec3f&) override {}
    void set_color(EdgeHandle, const OpenMesh::Vec4f&) override {}
    void set_color(FaceHandle, const OpenMesh::Vec3uc&) override {}
    void set_color(FaceHandle, const OpenMesh::Vec4uc&) override {}
    void set_color(FaceHandle, const OpenMesh::Vec3f&) override {}
    void set_color(FaceHandle, const OpenMesh::Vec4f&) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(VertexHandle, const OpenMesh::Vec2f&) override {}
    void set_texcoord(VertexHandle, const OpenMesh::Vec3f&) override {}
    void set_texcoord(HalfedgeHandle, const OpenMesh::Vec2f&) override {}
    void set_texcoord(HalfedgeHandle, const OpenMesh::Vec3f&) override {}
    void set_status(VertexHandle, const Status&) override {}
    void set_status(HalfedgeHandle, const Status&) override {}
    void set_status(EdgeHandle, const Status&) override {}
    void set_status(FaceHandle, const Status&) override {}
    void add_texture_information(int, std::string) override {}

  private:
    Soup soup_;
    std::vector<std::uint32_t> corners_; // of the face being added
    std::vector<int> face_halfedge_;     // per face of an OM file
    std::vector<int> next_;              // per halfedge
    std::vector<std::uint32_t> target_;  // per halfedge
    OpenMesh::BaseKernel kernel_;
};

} // namespace lineatlas
