#include <string_view>
#include <utility>

#include <OpenMesh/Core/IO/OMFormat.hh>

#include "checked_om.hpp"
#include "little_endian.hpp"

namespace lineatlas {

namespace {

namespace om = OpenMesh::IO::OMFormat;

constexpr std::size_t header_size = 16;
constexpr std::size_t status_size = 4; // although its chunk header says 1

/// The 16 bits in front of each chunk, in the order that OMFormat.hh gives.
struct ChunkHeader {
    explicit ChunkHeader(std::uint32_t bits)
        : named(take(bits, om::Chunk::OFF_NAME, om::Chunk::SIZE_NAME) != 0),
          entity(take(bits, om::Chunk::OFF_ENTITY, om::Chunk::SIZE_ENTITY)),
          type(take(bits, om::Chunk::OFF_TYPE, om::Chunk::SIZE_TYPE)),
          floating(take(bits, om::Chunk::OFF_FLOAT, om::Chunk::SIZE_FLOAT) != 0),
          dimension(take(bits, om::Chunk::OFF_DIM, om::Chunk::SIZE_DIM) + 1),
          integer_size(1U << take(bits, om::Chunk::OFF_BITS, om::Chunk::SIZE_BITS)),
          scalar_size(floating ? 4 * integer_size : integer_size) {}

    static unsigned take(std::uint32_t bits, int offset, int size) {
        return bits >> offset & ((1U << size) - 1U);
    }

    bool named;
    unsigned entity;
    unsigned type;
    bool floating;
    std::size_t dimension;
    std::size_t integer_size; ///< size of topology's numbers; OpenMesh leaves the mark for floats
                              ///< undefined there
    std::size_t scalar_size;
};

/// OpenMesh trusts counts, reads on behind the end of the file, and asserts on dimensions it does
/// not expect. So it gets only the chunks of positions and topology.
class OmFile {
  public:
    explicit OmFile(const SourceFile& source) : source_(source), bytes_(source.bytes) {}

    CheckedOm check() {
        header();
        while (at_ + 2 <= bytes_.size() && !done_) chunk();
        if (!has_positions_ || (checked_.faces > 0 && !has_faces_) ||
            (version_ >= om::mk_version(2, 0) && checked_.faces > 0 && !has_halfedges_))
            throw truncated();
        return std::move(checked_);
    }

  private:
    FileError truncated() const {
        return read_error(source_.path, "it is truncated: its header promises " +
                                            counted(checked_.vertices, "vertex", "vertices") +
                                            " and " + counted(checked_.faces, "face", "faces") +
                                            ", the file has no room for them");
    }
    FileError damaged() const {
        return read_error(source_.path, "it is damaged at byte " + std::to_string(at_));
    }

    void header() {
        if (!bytes_.starts_with("OM") || bytes_.size() < header_size)
            throw read_error(source_.path, "it does not start with an OM header");
        kind_ = bytes_[2];
        version_ = static_cast<unsigned char>(bytes_[3]);
        if (kind_ != 'T' && kind_ != 'Q' && kind_ != 'P')
            throw read_error(source_.path, "it does not start with an OM header");
        checked_.vertices = read_u32(bytes_, 4);
        checked_.faces = read_u32(bytes_, 8);
        edges_ = read_u32(bytes_, 12);
        constexpr std::size_t position_size = 12;
        if (checked_.vertices > bytes_.size() / position_size || checked_.faces > bytes_.size() ||
            edges_ > bytes_.size())
            throw truncated();
        checked_.bytes = bytes_.substr(0, header_size);
        at_ = header_size;
    }

    void chunk() {
        const std::size_t begin = at_;
        const ChunkHeader header(static_cast<std::uint32_t>(read_bytes(bytes_, at_, 2)));
        at_ += 2;
        if (header.entity == om::Chunk::Entity_Sentinel) {
            done_ = true;
            return;
        }
        if (header.named) skip_name();
        if (header.type == om::Chunk::Type_Custom) {
            // This is the name of the type.
            if (header.named && version_ > om::mk_version(2, 1)) skip_name();
            skip(at_ + 4 <= bytes_.size() ? 4 + read_u32(bytes_, at_) : 4);
            return;
        }
        if (header.type == om::Chunk::Type_Topology)
            topology(header);
        else if (header.type == om::Chunk::Type_Status)
            skip(entity_count(header) * status_size);
        else
            skip(entity_count(header) * header.dimension * header.scalar_size);

        const bool positions = header.entity == om::Chunk::Entity_Vertex &&
                               header.type == om::Chunk::Type_Pos && !header.named;
        if (positions) {
            if (has_positions_ || !header.floating || header.dimension != 3 ||
                header.scalar_size > 8)
                throw read_error(source_.path, "its positions are not three floats a vertex");
            has_positions_ = true;
        }
        if (positions || header.type == om::Chunk::Type_Topology)
            checked_.bytes += bytes_.substr(begin, at_ - begin);
    }

    std::size_t entity_count(const ChunkHeader& header) const {
        switch (header.entity) {
        case om::Chunk::Entity_Vertex:
            return checked_.vertices;
        case om::Chunk::Entity_Face:
            return checked_.faces;
        case om::Chunk::Entity_Edge:
            return edges_;
        case om::Chunk::Entity_Halfedge:
            return 2 * edges_;
        case om::Chunk::Entity_Mesh:
            return 1;
        default:
            throw damaged();
        }
    }

    void topology(const ChunkHeader& header) {
        constexpr std::size_t numbers_per_halfedge = 3; // next, target vertex, face
        switch (header.entity) {
        case om::Chunk::Entity_Vertex:
            skip(checked_.vertices * header.integer_size);
            return;
        case om::Chunk::Entity_Halfedge:
            skip(2 * edges_ * numbers_per_halfedge * header.integer_size);
            has_halfedges_ = true;
            return;
        case om::Chunk::Entity_Face:
            faces(header);
            return;
        default:
            throw damaged();
        }
    }

    void faces(const ChunkHeader& header) {
        if (has_faces_) throw damaged();
        has_faces_ = true;
        if (version_ >= om::mk_version(2, 0)) {
            skip(checked_.faces * header.integer_size);
            return;
        }
        if (kind_ != 'P') {
            skip(checked_.faces * (kind_ == 'T' ? 3 : 4) * header.integer_size);
            return;
        }
        for (std::size_t i = 0; i < checked_.faces; ++i) {
            if (at_ + 2 > bytes_.size()) throw truncated();
            skip(2 + read_bytes(bytes_, at_, 2) * header.integer_size);
        }
    }

    void skip_name() {
        if (at_ >= bytes_.size()) throw truncated();
        skip(1U + static_cast<unsigned char>(bytes_[at_]));
    }

    void skip(std::size_t count) {
        if (count > bytes_.size() - at_) throw truncated();
        at_ += count;
    }

    const SourceFile& source_;
    std::string_view bytes_;
    std::size_t at_ = 0;
    std::size_t edges_ = 0;
    char kind_ = 'T';
    unsigned version_ = 0;
    bool done_ = false;
    bool has_positions_ = false;
    bool has_halfedges_ = false;
    bool has_faces_ = false;
    CheckedOm checked_;
};

} // namespace

CheckedOm check_om(const SourceFile& source) {
    return OmFile(source).check();
}

} // namespace lineatlas
