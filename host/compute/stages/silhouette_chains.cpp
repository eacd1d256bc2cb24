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
    stages_.contour({.contours = *table.candidates.contours,
                     .vertices = table.vertices,
                     .eye = view.eye,
                     .first_number = table.candidates.kept_edges(),
                     .numbers = tables_[Table::numbers]});
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
                                      const SilhouetteView& view) {
    constexpr std::uint64_t vertex = 3 * sizeof(float);
    const std::uint64_t own_vertices = table.candidates.contours->vertex_count * vertex;
    const bool is_new =
        tables_.make_room(Table::vertices, own_vertices + 4 * std::uint64_t{count_} * vertex);
    const std::pair<const Buffer*, std::uint64_t> own{&table.vertices, table.version};
    if (is_new || vertices_of_ != own)
        device_.copy(table.vertices, tables_[Table::vertices], own_vertices);
    vertices_of_ = own;
    tables_.make_room(Table::crossings, std::uint64_t{count_} * sizeof(ContourCrossing));
    stages_.contour_places({.table = with_contours(table),
                            .eye = view.eye,
                            .front = front,
                            .numbers = tables_[Table::numbers],
                            .chosen = tables_[Table::chosen],
                            .count = count_,
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

SegmentTable SilhouetteChains::with_none(const SegmentTable& table) {
    device_.clear(tables_[Table::positions], std::size_t{table.candidates.count} * sizeof(la_uint));
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

void SilhouetteChains::chain(const SegmentTable& table, const SilhouetteView& view) {
    copy_fixed(table);
    const std::uint64_t n = count_;
    tables_.make_room(Table::ways, 2 * n * sizeof(ChainWay));
    tables_.make_room(Table::longer, 2 * n * sizeof(ChainWay));
    tables_.make_room(Table::going, most_chain_steps * sizeof(la_uint));
    tables_.make_room(Table::places, n * sizeof(ChainPlace));
    tables_.make_room(Table::starts, (n + 1) * sizeof(la_uint));
    tables_.make_room(Table::origins, n * sizeof(la_uint));
    stages_.chain({.table = table,
                   .crossings = table.candidates.contours ? &tables_[Table::crossings] : nullptr,
                   .lifted = drawn_ == Contours::lifted,
                   .view = view,
                   .numbers = tables_[Table::numbers],
                   .count = count_,
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
