// Silhouettes of a frame, and the chains that they make.
#include <bit>
#include <utility>

#include "stages.hpp"

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

} // namespace

void Stages::contour(const SegmentTable& table, const glm::vec4& eye, const ChainTables& tables) {
    const ContourTables& contours = *table.candidates.contours;
    ContourParameters parameters = parameters_of(table.candidates, eye);
    parameters.count = static_cast<std::uint32_t>(contours.corners->size() / sizeof(ContourCorner));
    Buffer& facing = scratch(Scratch::corner_facing, parameters.count);
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
                                    {.facing = &scratch(Scratch::corner_facing), .front = &front},
                                    *args.table.candidates.contours, args.table, args.tables, args);
}

void Stages::silhouette(const SegmentTable& table, Buffer& front, const ChainTables& tables) {
    const std::uint32_t count = table.candidates.kept_edges();
    launch<kernels::silhouette>(
        count, {.count = count, .first = table.candidates.first, .replaced = count, .contours = 0},
        {.front = &front}, table, tables);
    scan(*tables.numbers, table.candidates.drawable(), ScanKind::saturate);
}

void Stages::silhouette_list(const SilhouetteCandidates& candidates, const ChainTables& tables) {
    const std::uint32_t count = candidates.drawable();
    launch<kernels::silhouette_list>(count,
                                     {.count = count,
                                      .first = candidates.first,
                                      .replaced = candidates.kept_edges(),
                                      .contours = candidates.edges()},
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
    // A stretch is twice as long after each step. A loop is recognised when its stretch has gone
    // round.
    const auto steps = static_cast<std::uint32_t>(std::bit_width(args.count)) + 2;
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

} // namespace lineatlas::compute
