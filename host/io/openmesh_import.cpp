#include "openmesh_import.hpp"

#include <mutex>
#include <sstream>

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/reader/OFFReader.hh>
#include <OpenMesh/Core/IO/reader/OMReader.hh>
#include <OpenMesh/Core/IO/reader/PLYReader.hh>
#include <OpenMesh/Core/IO/reader/STLReader.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include "soup_importer.hpp"

namespace lineatlas {

OpenMesh::VertexHandle SoupImporter::add_vertex(const OpenMesh::Vec3f& point) {
    soup_.positions.emplace_back(point[0], point[1], point[2]);
    return VertexHandle(static_cast<int>(soup_.positions.size() - 1));
}

void SoupImporter::set_point(VertexHandle vertex, const OpenMesh::Vec3f& point) {
    soup_.positions.at(static_cast<std::size_t>(vertex.idx())) = {point[0], point[1], point[2]};
}

OpenMesh::FaceHandle SoupImporter::add_face(const VHandles& corners) {
    corners_.clear();
    for (const VertexHandle corner : corners)
        corners_.push_back(static_cast<std::uint32_t>(corner.idx()));
    soup_.add_face(corners_);
    return FaceHandle(static_cast<int>(n_faces() - 1));
}

OpenMesh::FaceHandle SoupImporter::add_face(HalfedgeHandle halfedge) {
    face_halfedge_.push_back(halfedge.idx());
    return FaceHandle(static_cast<int>(n_faces() - 1));
}

OpenMesh::HalfedgeHandle SoupImporter::add_edge(VertexHandle from, VertexHandle to) {
    target_.push_back(static_cast<std::uint32_t>(to.idx()));
    target_.push_back(static_cast<std::uint32_t>(from.idx()));
    next_.resize(target_.size(), -1);
    return HalfedgeHandle(static_cast<int>(target_.size() - 2));
}

void SoupImporter::set_next(HalfedgeHandle halfedge, HalfedgeHandle next) {
    next_.at(static_cast<std::size_t>(halfedge.idx())) = next.idx();
}

bool SoupImporter::add_halfedge_faces() {
    // Each halfedge bounds one face, so all walks together are no longer than all halfedges.
    std::size_t steps_left = next_.size();
    const auto valid = [&](int halfedge) {
        return halfedge >= 0 && static_cast<std::size_t>(halfedge) < next_.size();
    };
    for (const int first : face_halfedge_) {
        corners_.clear();
        int halfedge = first;
        do {
            if (!valid(halfedge) || steps_left-- == 0) return false;
            corners_.push_back(target_[static_cast<std::size_t>(halfedge)]);
            halfedge = next_[static_cast<std::size_t>(halfedge)];
        } while (halfedge != first);
        soup_.add_face(corners_);
    }
    face_halfedge_.clear();
    return true;
}

namespace {

/// The readers keep their state in singletons and talk to global streams.
class ReaderLock {
  public:
    ReaderLock() : lock_(mutex()), errors_(omerr().is_enabled()), log_(omlog().is_enabled()) {
        omerr().disable();
        omlog().disable();
    }
    ~ReaderLock() {
        if (errors_) omerr().enable();
        if (log_) omlog().enable();
    }
    ReaderLock(const ReaderLock&) = delete;
    ReaderLock& operator=(const ReaderLock&) = delete;

  private:
    static std::mutex& mutex() {
        static std::mutex mutex;
        return mutex;
    }

    std::lock_guard<std::mutex> lock_;
    bool errors_;
    bool log_;
};

OpenMesh::IO::BaseReader& reader_for(std::string_view extension) {
    if (extension == ".ply") return OpenMesh::IO::PLYReader();
    if (extension == ".stl") return OpenMesh::IO::STLReader();
    if (extension == ".off") return OpenMesh::IO::OFFReader();
    return OpenMesh::IO::OMReader();
}

} // namespace

Soup import_by_openmesh(CheckedMesh checked, std::string_view extension,
                        const std::filesystem::path& path) {
    SoupImporter importer;
    {
        const ReaderLock lock;
        OpenMesh::IO::Options options;
        if (extension == ".stl") options += OpenMesh::IO::Options::Binary;
        std::istringstream stream(std::move(checked.bytes));
        stream.unsetf(extension == ".om" ? std::ios::skipws : std::ios::fmtflags());
        if (!reader_for(extension).read(stream, importer, options))
            throw read_error(path, "OpenMesh refuses it");
    }
    // The STL reader welds equal positions and leaves out facets that lose their area by that.
    const std::size_t found = importer.n_faces();
    const bool welds = extension == ".stl";
    if ((!welds && (importer.n_vertices() != checked.vertices || found != checked.faces)) ||
        found > checked.faces || !importer.add_halfedge_faces())
        throw read_error(path,
                         "OpenMesh finds other numbers of vertices and faces than its header");

    Soup soup = importer.take();
    if (!checked.exact.empty()) soup.positions = std::move(checked.exact);
    soup.origin = checked.origin;
    soup.not_finite_faces = checked.not_finite_faces;
    soup.notes = std::move(checked.notes);
    if (welds && found < checked.faces)
        soup.notes.push_back(counted(checked.faces - found, "face", "faces") +
                             " with equal corners dropped");
    return soup;
}

} // namespace lineatlas
