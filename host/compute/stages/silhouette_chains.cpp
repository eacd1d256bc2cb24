#include "silhouette_chains.hpp"
#include "compute/transfer.hpp"

namespace lineatlas::compute {

void SilhouetteChains::release() {
    tables_ = {&device_};
    crossings_.release();
    first_ = count_ = 0;
    has_order_ = false;
    fixed_of_ = nullptr;
    vertices_of_ = {};
}

SegmentTable SilhouetteChains::without(const SegmentTable& table) {
    first_ = table.segment_count - table.candidates.count;
    count_ = 0;
    has_order_ = false;
    SegmentTable result = table;
    result.segment_count = first_;
    return result;
}

void SilhouetteChains::contour(const SegmentTable& table, const glm::vec4& eye) {
    stages_.contour(table, eye, tables_);
    const std::uint32_t first = table.candidates.kept_edges();
    for (const FaceRange range : traced_.instead_of) {
        const std::vector<la_uint> none(range.count, 0);
        device_.upload(*tables_.numbers, std::as_bytes(std::span{none}),
                       (std::size_t{first} + range.first) * sizeof(la_uint));
    }
}

void SilhouetteChains::list(const SegmentTable& table, Buffer& front) {
    tables_.positions.make_room(table.candidates.count * sizeof(la_uint));
    first_ = table.candidates.first;
    stages_.silhouette(table, front, tables_);
    count_ = read_one<la_uint>(device_, *tables_.numbers, table.candidates.drawable());
    has_order_ = true;
    if (count_ == 0) return;
    tables_.chosen.make_room(std::uint64_t{count_} * sizeof(la_uint));
    stages_.silhouette_list(table.candidates, tables_);
}

void SilhouetteChains::place_contours(const SegmentTable& table, Buffer& front,
                                      const SilhouetteView& view, std::uint32_t found) {
    constexpr std::uint64_t vertex = 3 * sizeof(float);
    const std::uint64_t own_vertices = table.candidates.contours->vertex_count * vertex;
    const std::uint64_t found_vertices = 4 * std::uint64_t{found} * vertex;
    const auto traced = std::as_bytes(std::span{traced_.vertices});
    const bool is_new = tables_.vertices.make_room(own_vertices + found_vertices + traced.size());
    const std::pair<const Buffer*, std::uint64_t> own{&table.vertices, table.version};
    if (is_new || vertices_of_ != own)
        device_.copy(table.vertices, *tables_.vertices, own_vertices);
    vertices_of_ = own;
    if (!traced.empty()) device_.upload(*tables_.vertices, traced, own_vertices + found_vertices);
    if (found == 0) return;
    crossings_.make_room(std::uint64_t{found} * sizeof(ContourCrossing));
    stages_.contour_places(args(with_contours(table), view, found), front);
}

SegmentTable SilhouetteChains::with_contours(const SegmentTable& table) const {
    return {.vertices = *tables_.vertices,
            .triangles = table.triangles,
            .segments = table.segments,
            .triangle_count = table.triangle_count,
            .segment_count = table.segment_count,
            .candidates = table.candidates,
            .version = table.version};
}

void SilhouetteChains::add_traced(const SegmentTable& table, std::uint32_t found) {
    if (traced_.segments.empty()) return;
    const std::uint32_t first_vertex = table.candidates.contours->vertex_count + 4 * found;
    const std::uint32_t first_face = table.candidates.edges();
    std::vector<la_uint> origins;
    origins.reserve(traced_.segments.size());
    for (std::size_t i = 0; i < traced_.segments.size(); ++i) {
        traced_.segments[i].p += first_vertex;
        traced_.segments[i].q += first_vertex;
        origins.push_back(((first_face + traced_.faces[i]) << 1U) + 1);
    }
    device_.upload(*tables_.ordered, std::as_bytes(std::span{traced_.segments}),
                   (std::size_t{first_} + found) * sizeof(Segment));
    device_.upload(*tables_.origins, std::as_bytes(std::span{origins}), found * sizeof(la_uint));
}

void SilhouetteChains::clear_positions(const SegmentTable& table) {
    device_.clear(*tables_.positions, std::size_t{table.candidates.count} * sizeof(la_uint));
}

SegmentTable SilhouetteChains::with_none(const SegmentTable& table) {
    clear_positions(table);
    tables_.origins.make_room(sizeof(la_uint));
    SegmentTable result = table;
    result.segment_count = first_;
    return result;
}

void SilhouetteChains::copy_fixed(const SegmentTable& table) {
    const std::uint64_t bytes = (std::uint64_t{first_} + count_) * sizeof(Segment);
    if (!tables_.ordered.make_room(bytes) && fixed_of_ == &table.segments) return;
    if (first_ > 0) device_.copy(table.segments, *tables_.ordered, first_ * sizeof(Segment));
    fixed_of_ = &table.segments;
}

void SilhouetteChains::chain(const SegmentTable& table, const SilhouetteView& view,
                             std::uint32_t found) {
    copy_fixed(table);
    tables_.origins.make_room(std::uint64_t{count_} * sizeof(la_uint));
    add_traced(table, found);
    if (found == 0) return clear_positions(table);
    const std::uint64_t n = found;
    tables_.ways.make_room(2 * n * sizeof(ChainWay));
    tables_.longer.make_room(2 * n * sizeof(ChainWay));
    tables_.going.make_room(most_chain_steps * sizeof(la_uint));
    tables_.places.make_room(n * sizeof(ChainPlace));
    tables_.starts.make_room((n + 1) * sizeof(la_uint));
    stages_.chain(args(table, view, found));
}

SegmentTable SilhouetteChains::with_chains(const SegmentTable& table) const {
    return {.vertices = table.vertices,
            .triangles = table.triangles,
            .segments = *tables_.ordered,
            .triangle_count = table.triangle_count,
            .segment_count = first_ + count_,
            .candidates = table.candidates,
            .origins = tables_.origins.get(),
            .version = table.version};
}

std::vector<std::uint32_t> SilhouetteChains::read_origins() const {
    std::vector<std::uint32_t> origins(count_);
    if (count_ > 0) device_.download(*tables_.origins, std::as_writable_bytes(std::span{origins}));
    return origins;
}

ChainOrder SilhouetteChains::order(const SegmentTable& table, Buffer& positions_before) const {
    return {.first = first_,
            .origins = *tables_.origins,
            .positions = *tables_.positions,
            .candidates = table.candidates.count,
            .positions_before = positions_before};
}

} // namespace lineatlas::compute
