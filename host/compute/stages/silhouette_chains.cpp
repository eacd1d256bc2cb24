#include "silhouette_chains.hpp"

namespace lineatlas::compute {

void SilhouetteChains::release() {
    for (std::unique_ptr<Buffer>* buffer : tables(*this)) buffer->reset();
    first_ = count_ = 0;
    has_order_ = false;
    fixed_of_ = vertices_of_ = nullptr;
}

bool SilhouetteChains::make_room(std::unique_ptr<Buffer>& buffer, std::uint64_t bytes) {
    if (buffer && buffer->size() >= bytes) return false;
    const bool grows = buffer != nullptr;
    buffer.reset(); // it may not fit beside another
    buffer = allocate(device_, grows ? room_to_grow(device_, bytes) : bytes, purpose::segments);
    return true;
}

SegmentTable SilhouetteChains::without(const SegmentTable& table) {
    first_ = table.segment_count - table.candidates.count;
    count_ = 0;
    has_order_ = false;
    SegmentTable result = table;
    result.segment_count = first_;
    return result;
}

void SilhouetteChains::contour(const SegmentTable& table, Buffer& front, const glm::vec4& eye) {
    const ContourTables& contours = *table.candidates.contours;
    constexpr std::uint64_t vertex = 3 * sizeof(float);
    const std::uint64_t edges = contours.edge_count;
    const bool is_new = make_room(vertices_, (contours.vertex_count + 2 * edges) * vertex);
    if (is_new || vertices_of_ != &table.vertices)
        device_.copy(table.vertices, *vertices_, contours.vertex_count * vertex);
    vertices_of_ = &table.vertices;
    make_room(crossed_, edges);
    make_room(contour_ends_, std::uint64_t{contours.face_count} * 2 * sizeof(la_uint));
    stages_.contour({.contours = contours,
                     .eye = eye,
                     .front = front,
                     .vertices = *vertices_,
                     .crossed = *crossed_,
                     .ends = *contour_ends_});
}

SegmentTable SilhouetteChains::with_contours(const SegmentTable& table) const {
    if (!table.candidates.contours) return table;
    return {.vertices = *vertices_,
            .triangles = table.triangles,
            .segments = table.segments,
            .triangle_count = table.triangle_count,
            .segment_count = table.segment_count,
            .candidates = table.candidates,
            .version = table.version};
}

void SilhouetteChains::count(const SegmentTable& table, Buffer& front) {
    const std::uint64_t candidates = table.candidates.count;
    make_room(numbers_, (candidates + 1) * sizeof(la_uint));
    make_room(positions_, candidates * sizeof(la_uint));
    first_ = table.candidates.first;
    stages_.silhouette({.table = table,
                        .contour_ends = contour_ends(table),
                        .front = front,
                        .numbers = *numbers_});
    device_.download(*numbers_, std::as_writable_bytes(std::span{&count_, 1}),
                     candidates * sizeof(la_uint));
    has_order_ = true;
}

SegmentTable SilhouetteChains::with_none(const SegmentTable& table) {
    device_.clear(*positions_, std::size_t{table.candidates.count} * sizeof(la_uint));
    make_room(origins_, sizeof(la_uint));
    SegmentTable result = table;
    result.segment_count = first_;
    return result;
}

void SilhouetteChains::copy_fixed(const SegmentTable& table) {
    const std::uint64_t bytes = (std::uint64_t{first_} + count_) * sizeof(Segment);
    if (!make_room(ordered_, bytes) && fixed_of_ == &table.segments) return;
    if (first_ > 0) device_.copy(table.segments, *ordered_, first_ * sizeof(Segment));
    fixed_of_ = &table.segments;
}

void SilhouetteChains::chain(const SegmentTable& table, const glm::vec4& eye) {
    copy_fixed(table);
    const std::uint64_t n = count_;
    make_room(chosen_, n * sizeof(la_uint));
    make_room(ways_, 2 * n * sizeof(ChainWay));
    make_room(longer_, 2 * n * sizeof(ChainWay));
    make_room(going_, most_chain_steps * sizeof(la_uint));
    make_room(places_, n * sizeof(ChainPlace));
    make_room(starts_, (n + 1) * sizeof(la_uint));
    make_room(origins_, n * sizeof(la_uint));
    stages_.chain({.table = table,
                   .contour_ends = contour_ends(table),
                   .lifted = drawn_ == Contours::lifted,
                   .eye = eye,
                   .numbers = *numbers_,
                   .count = count_,
                   .chosen = *chosen_,
                   .ways = *ways_,
                   .longer = *longer_,
                   .going = *going_,
                   .places = *places_,
                   .starts = *starts_,
                   .ordered = *ordered_,
                   .origins = *origins_,
                   .positions = *positions_,
                   .positions_before = positions_before_});
}

SegmentTable SilhouetteChains::with_chains(const SegmentTable& table) const {
    return {.vertices = table.vertices,
            .triangles = table.triangles,
            .segments = *ordered_,
            .triangle_count = table.triangle_count,
            .segment_count = first_ + count_,
            .candidates = table.candidates,
            .origins = origins_.get(),
            .version = table.version};
}

std::vector<std::uint32_t> SilhouetteChains::read_origins() const {
    std::vector<std::uint32_t> origins(count_);
    if (count_ > 0) device_.download(*origins_, std::as_writable_bytes(std::span{origins}));
    return origins;
}

ChainOrder SilhouetteChains::order(const SegmentTable& table, Buffer& positions_before) const {
    return {.first = first_,
            .origins = *origins_,
            .positions = *positions_,
            .candidates = table.candidates.count,
            .positions_before = positions_before};
}

std::uint64_t SilhouetteChains::bytes() const {
    std::uint64_t sum = 0;
    for (const std::unique_ptr<Buffer>* buffer : tables(*this)) {
        if (*buffer) sum += (*buffer)->size();
    }
    return sum;
}

} // namespace lineatlas::compute
