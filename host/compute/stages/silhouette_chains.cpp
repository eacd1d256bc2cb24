#include "silhouette_chains.hpp"
#include "compute/transfer.hpp"

namespace lineatlas::compute {

void SilhouetteChains::release() {
    tables_.release();
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

void SilhouetteChains::contour(const SegmentTable& table, const SilhouetteView& view) {
    const std::uint32_t first = table.candidates.kept_edges();
    stages_.contour({.contours = *table.candidates.contours,
                     .vertices = table.vertices,
                     .eye = view.eye,
                     .first_number = first,
                     .numbers = tables_[Table::numbers]});
    for (const FaceRange range : traced_.instead_of) {
        const std::vector<la_uint> none(range.count, 0);
        device_.upload(tables_[Table::numbers], std::as_bytes(std::span{none}),
                       (std::size_t{first} + range.first) * sizeof(la_uint));
    }
}

void SilhouetteChains::list(const SegmentTable& table, Buffer& front) {
    tables_.make_room(Table::positions, table.candidates.count * sizeof(la_uint));
    first_ = table.candidates.first;
    stages_.silhouette({.table = table, .front = front, .numbers = tables_[Table::numbers]});
    count_ = read_one<la_uint>(device_, tables_[Table::numbers], table.candidates.drawable());
    has_order_ = true;
    if (count_ == 0) return;
    tables_.make_room(Table::chosen, std::uint64_t{count_} * sizeof(la_uint));
    stages_.silhouette_list({.candidates = table.candidates,
                             .numbers = tables_[Table::numbers],
                             .chosen = tables_[Table::chosen],
                             .positions = tables_[Table::positions]});
}

void SilhouetteChains::place_contours(const SegmentTable& table, Buffer& front,
                                      const SilhouetteView& view, std::uint32_t found) {
    constexpr std::uint64_t vertex = 3 * sizeof(float);
    const std::uint64_t own_vertices = table.candidates.contours->vertex_count * vertex;
    const std::uint64_t found_vertices = 4 * std::uint64_t{found} * vertex;
    const auto traced = std::as_bytes(std::span{traced_.vertices});
    const bool is_new =
        tables_.make_room(Table::vertices, own_vertices + found_vertices + traced.size());
    const std::pair<const Buffer*, std::uint64_t> own{&table.vertices, table.version};
    if (is_new || vertices_of_ != own)
        device_.copy(table.vertices, tables_[Table::vertices], own_vertices);
    vertices_of_ = own;
    if (!traced.empty())
        device_.upload(tables_[Table::vertices], traced, own_vertices + found_vertices);
    if (found == 0) return;
    tables_.make_room(Table::crossings, std::uint64_t{found} * sizeof(ContourCrossing));
    stages_.contour_places({.table = with_contours(table),
                            .eye = view.eye,
                            .front = front,
                            .numbers = tables_[Table::numbers],
                            .chosen = tables_[Table::chosen],
                            .count = found,
                            .on_surface = drawn_ == Contours::on_surface,
                            .crossings = tables_[Table::crossings]});
}

SegmentTable SilhouetteChains::with_contours(const SegmentTable& table) const {
    return {.vertices = tables_[Table::vertices],
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
    device_.upload(tables_[Table::ordered], std::as_bytes(std::span{traced_.segments}),
                   (std::size_t{first_} + found) * sizeof(Segment));
    device_.upload(tables_[Table::origins], std::as_bytes(std::span{origins}),
                   found * sizeof(la_uint));
}

void SilhouetteChains::clear_positions(const SegmentTable& table) {
    device_.clear(tables_[Table::positions], std::size_t{table.candidates.count} * sizeof(la_uint));
}

SegmentTable SilhouetteChains::with_none(const SegmentTable& table) {
    clear_positions(table);
    tables_.make_room(Table::origins, sizeof(la_uint));
    SegmentTable result = table;
    result.segment_count = first_;
    return result;
}

void SilhouetteChains::copy_fixed(const SegmentTable& table) {
    const std::uint64_t bytes = (std::uint64_t{first_} + count_) * sizeof(Segment);
    if (!tables_.make_room(Table::ordered, bytes) && fixed_of_ == &table.segments) return;
    if (first_ > 0) device_.copy(table.segments, tables_[Table::ordered], first_ * sizeof(Segment));
    fixed_of_ = &table.segments;
}

void SilhouetteChains::chain(const SegmentTable& table, const SilhouetteView& view,
                             std::uint32_t found) {
    copy_fixed(table);
    tables_.make_room(Table::origins, std::uint64_t{count_} * sizeof(la_uint));
    add_traced(table, found);
    if (found == 0) return clear_positions(table);
    const std::uint64_t n = found;
    tables_.make_room(Table::ways, 2 * n * sizeof(ChainWay));
    tables_.make_room(Table::longer, 2 * n * sizeof(ChainWay));
    tables_.make_room(Table::going, most_chain_steps * sizeof(la_uint));
    tables_.make_room(Table::places, n * sizeof(ChainPlace));
    tables_.make_room(Table::starts, (n + 1) * sizeof(la_uint));
    stages_.chain({.table = table,
                   .crossings = table.candidates.contours ? &tables_[Table::crossings] : nullptr,
                   .lifted = drawn_ == Contours::lifted,
                   .view = view,
                   .numbers = tables_[Table::numbers],
                   .count = found,
                   .chosen = tables_[Table::chosen],
                   .ways = tables_[Table::ways],
                   .longer = tables_[Table::longer],
                   .going = tables_[Table::going],
                   .places = tables_[Table::places],
                   .starts = tables_[Table::starts],
                   .ordered = tables_[Table::ordered],
                   .origins = tables_[Table::origins],
                   .positions = tables_[Table::positions],
                   .positions_before = positions_before_});
}

SegmentTable SilhouetteChains::with_chains(const SegmentTable& table) const {
    return {.vertices = table.vertices,
            .triangles = table.triangles,
            .segments = tables_[Table::ordered],
            .triangle_count = table.triangle_count,
            .segment_count = first_ + count_,
            .candidates = table.candidates,
            .origins = &tables_[Table::origins],
            .version = table.version};
}

std::vector<std::uint32_t> SilhouetteChains::read_origins() const {
    std::vector<std::uint32_t> origins(count_);
    if (count_ > 0)
        device_.download(tables_[Table::origins], std::as_writable_bytes(std::span{origins}));
    return origins;
}

ChainOrder SilhouetteChains::order(const SegmentTable& table, Buffer& positions_before) const {
    return {.first = first_,
            .origins = tables_[Table::origins],
            .positions = tables_[Table::positions],
            .candidates = table.candidates.count,
            .positions_before = positions_before};
}

} // namespace lineatlas::compute
