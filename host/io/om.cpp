#include <mutex>
#include <sstream>
#include <utility>

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/reader/OMReader.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include "checked_om.hpp"
#include "mesh_readers.hpp"
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

/// The reader keeps its state in a singleton and talks to global streams.
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

} // namespace

Soup read_om(const SourceFile& source) {
    CheckedOm checked = check_om(source);
    SoupImporter importer;
    {
        const ReaderLock lock;
        OpenMesh::IO::Options options;
        std::istringstream stream(std::move(checked.bytes));
        stream.unsetf(std::ios::skipws);
        if (!OpenMesh::IO::OMReader().read(stream, importer, options))
            throw read_error(source.path, "OpenMesh refuses it");
    }
    if (importer.n_vertices() != checked.vertices || importer.n_faces() != checked.faces ||
        !importer.add_halfedge_faces())
        throw read_error(source.path,
                         "its header promises other numbers of vertices and faces than it holds");
    return importer.take();
}

} // namespace lineatlas
