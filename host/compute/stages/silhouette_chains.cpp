#include "silhouette_chains.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "compute/transfer.hpp"

namespace lineatlas::compute {

namespace {

ContourParameters parameters_of(const SilhouetteCandidates& candidates, const glm::vec4& eye) {
    return {.count = 0,
            .first_vertex = candidates.contours->vertex_count,
            .first_number = candidates.kept_edges(),
            .contours = candidates.edges(),
            .first = candidates.first,
            .on_surface = 0,
            .eye = eye};
}

// What tables of all stages hold, as docs/architecture.md says.
constexpr std::uint64_t bytes_of_segment = sizeof(Segment) + sizeof(ClippedSegment) + 24;
constexpr std::uint64_t bytes_of_silhouette = 92 + sizeof(ContourCrossing) + 56;
constexpr std::uint64_t bytes_of_places = 4 * 3 * sizeof(float);

/// Room for the silhouettes of a frame after one that had `last`, of `most`.
std::uint32_t guess_after(std::uint32_t last, std::uint32_t most) {
    constexpr std::uint32_t some = 256;
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>(std::uint64_t{last} + last / 4 + some, most));
}

} // namespace

void Stages::contour(const SegmentTable& table, const glm::vec4& eye, const ChainTables& tables) {
    const ContourTables& contours = *table.candidates.contours;
    ContourParameters parameters = parameters_of(table.candidates, eye);
    parameters.count = static_cast<std::uint32_t>(contours.corners->size() / sizeof(ContourCorner));
    Buffer& facing = corner_facing_.with_room(parameters.count);
    launch<kernels::contour_facing>(parameters.count, parameters, {.facing = &facing}, contours,
                                    table);
    parameters.count = contours.face_count;
    launch<kernels::contour_cross>(parameters.count, parameters, {.facing = &facing}, contours,
                                   tables);
}

void Stages::contour_places(const ChainArgs& args, Buffer& front) {
    ContourParameters parameters = parameters_of(args.table.candidates, args.view.eye);
    parameters.count = args.count;
    parameters.on_surface = args.lifted ? 0 : 1;
    launch<kernels::contour_places>(args.count, parameters,
                                    {.facing = corner_facing_.get(), .front = &front},
                                    *args.table.candidates.contours, args.table, args.tables, args);
}

void Stages::silhouette(const SegmentTable& table, Buffer& front, const ChainTables& tables) {
    const std::uint32_t count = table.candidates.kept_edges();
    launch<kernels::silhouette>(count,
                                {.count = count,
                                 .first = table.candidates.first,
                                 .replaced = count,
                                 .contours = 0,
                                 .capacity = 0},
                                {.front = &front}, table, tables);
    scan(*tables.numbers, table.candidates.drawable(), ScanKind::saturate);
}

void Stages::silhouette_list(const SilhouetteCandidates& candidates, std::uint32_t capacity,
                             const ChainTables& tables) {
    const std::uint32_t count = candidates.drawable();
    launch<kernels::silhouette_list>(count,
                                     {.count = count,
                                      .first = candidates.first,
                                      .replaced = candidates.kept_edges(),
                                      .contours = candidates.edges(),
                                      .capacity = capacity},
                                     tables);
}

void Stages::chain(const ChainArgs& args) {
    const SilhouetteCandidates& candidates = args.table.candidates;
    const ChainTables& tables = args.tables;
    ChainParameters parameters{.count = args.count,
                               .first = candidates.first,
                               .step = 0,
                               .eye = args.view.eye,
                               .contours = candidates.edges(),
                               .lifted = args.lifted ? 1U : 0U,
                               .follows = args.positions_before != nullptr ? 1U : 0U,
                               .outside = args.view.from_outside ? 1U : 0U};
    launch<kernels::chain_link>(args.count, parameters, args.table, candidates, tables, args);
    // A loop is recognised when its stretch has gone round.
    constexpr std::uint32_t doublings = std::bit_width(LA_WAY_GROWTH) - 1; // in each step
    const std::uint32_t steps =
        divide_up(static_cast<std::uint32_t>(std::bit_width(args.count)) + 2, doublings);
    device_.clear(*tables.going, steps * sizeof(la_uint));
    parameters.count = 2 * args.count;
    Buffer* from = tables.ways.get();
    Buffer* to = tables.longer.get();
    for (parameters.step = 0; parameters.step < steps; ++parameters.step) {
        launch<kernels::chain_jump>(parameters.count, parameters,
                                    {.ways = *from, .longer = *to, .going = *tables.going});
        std::swap(from, to);
    }
    parameters.count = args.count;
    launch<kernels::chain_place>(
        args.count, parameters,
        {.ways = *from, .places = *tables.places, .lengths = *tables.starts});
    scan(*tables.starts, args.count, ScanKind::saturate);
    launch<kernels::chain_write>(args.count, parameters, tables, args.table, args);
}

void SilhouetteChains::release() {
    tables_ = {&device_};
    crossings_.release();
    last_total_.reset();
    first_ = count_ = 0;
    has_order_ = false;
    fixed_of_ = nullptr;
    vertices_of_ = {};
}

SegmentTable SilhouetteChains::without(const SegmentTable& table) {
    first_ = table.segment_count - table.candidates.count;
    count_ = 0;
    is_guessed_ = has_order_ = has_many_more_ = false;
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
    count_silhouettes(table);
    has_order_ = true;
    if (count_ == 0) return;
    tables_.chosen.make_room(std::uint64_t{count_} * sizeof(la_uint));
    tables_.total.fit(sizeof(la_uint));
    stages_.silhouette_list(table.candidates, count_, tables_);
    if (is_guessed_)
        device_.begin_download(*tables_.total, std::as_writable_bytes(std::span{&total_, 1}));
}

void SilhouetteChains::count_silhouettes(const SegmentTable& table) {
    const std::uint32_t most = table.candidates.drawable();
    const std::uint32_t guess = last_total_ ? guess_after(*last_total_, most) : most;
    has_many_more_ = false;
    is_guessed_ = guesses_ && last_total_ && most > 0 && traced_.segments.empty() &&
                  has_memory_for(guess, table);
    if (is_guessed_) {
        count_ = guess;
        return;
    }
    count_ = read_one<la_uint>(device_, *tables_.numbers, most);
    last_total_ = count_;
    has_many_more_ = count_ > guess;
    if (has_many_more_) positions_before_ = nullptr;
}

bool SilhouetteChains::has_memory_for(std::uint64_t silhouettes, const SegmentTable& table) const {
    // As if no table were there yet. A table that grows takes a quarter more.
    const std::uint64_t grown = silhouettes + silhouettes / 4;
    const std::uint64_t segments = table.candidates.first + grown;
    const std::uint64_t vertices = table.vertices.size() + grown * bytes_of_places;
    const std::uint64_t all = segments * bytes_of_segment + grown * bytes_of_silhouette +
                              (table.candidates.contours ? vertices : 0);
    const std::uint64_t largest =
        std::max({segments * sizeof(ClippedSegment), 2 * grown * sizeof(ChainWay), vertices});
    return largest <= device_.largest_buffer() && all <= device_.free_memory();
}

bool SilhouetteChains::settle() {
    if (!is_guessed_) return true;
    is_guessed_ = false;
    last_total_ = total_;
    const bool fits = total_ <= count_;
    count_ = std::min(count_, total_);
    return fits;
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
