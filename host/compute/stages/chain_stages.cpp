// Silhouettes of a frame, and the chains that they make.
#include <bit>

#include "stages.hpp"

namespace lineatlas::compute {

void Stages::contour(const ContourArgs& args) {
    const ContourTables& contours = args.contours;
    const auto corner_count =
        static_cast<std::uint32_t>(contours.corners->size() / sizeof(ContourCorner));
    Buffer& facing = scratch(Scratch::corner_facing, corner_count);
    ContourParameters parameters{.count = corner_count,
                                 .first_vertex = contours.vertex_count,
                                 .first_number = args.first_number,
                                 .contours = 0,
                                 .first = 0,
                                 .on_surface = 0,
                                 .eye = args.eye};
    launch<kernels::contour_facing>(
        corner_count, parameters,
        {.corners = *contours.corners, .vertices = args.vertices, .facing = facing});
    parameters.count = contours.face_count;
    launch<kernels::contour_cross>(
        contours.face_count, parameters,
        {.face_corners = *contours.face_corners, .facing = facing, .numbers = args.numbers});
}

void Stages::contour_places(const ContourPlacesArgs& args) {
    const SilhouetteCandidates& candidates = args.table.candidates;
    const ContourTables& contours = *candidates.contours;
    launch<kernels::contour_places>(args.count,
                                    {.count = args.count,
                                     .first_vertex = contours.vertex_count,
                                     .first_number = candidates.kept_edges(),
                                     .contours = candidates.edges(),
                                     .first = candidates.first,
                                     .on_surface = args.on_surface ? 1U : 0U,
                                     .eye = args.eye},
                                    {.chosen = args.chosen,
                                     .numbers = args.numbers,
                                     .face_corners = *contours.face_corners,
                                     .facing = scratch_[Scratch::corner_facing],
                                     .faces = *contours.faces,
                                     .corners = *contours.corners,
                                     .edges = *contours.edges,
                                     .triangles = args.table.triangles,
                                     .segments = args.table.segments,
                                     .front = args.front,
                                     .vertices = args.table.vertices,
                                     .crossings = args.crossings});
}

void Stages::silhouette(const SilhouetteArgs& args) {
    const SilhouetteCandidates& candidates = args.table.candidates;
    const std::uint32_t count = candidates.kept_edges();
    launch<kernels::silhouette>(
        count, {.count = count, .first = candidates.first, .replaced = count, .contours = 0},
        args.table, args);
    scan(args.numbers, candidates.drawable(), ScanKind::saturate);
}

void Stages::silhouette_list(const SilhouetteListArgs& args) {
    const SilhouetteCandidates& candidates = args.candidates;
    const std::uint32_t count = candidates.drawable();
    launch<kernels::silhouette_list>(count,
                                     {.count = count,
                                      .first = candidates.first,
                                      .replaced = candidates.kept_edges(),
                                      .contours = candidates.edges()},
                                     args);
}

namespace {

/// Tables that may be missing. Then other tables, which are not read, stand for them.
struct ChainTables {
    Buffer &crossings, &end_offsets, &ends, &positions_before;
};
ChainTables may_be_absent(const ChainArgs& args) {
    return {.crossings = args.crossings != nullptr ? *args.crossings : args.table.segments,
            .end_offsets = *args.table.candidates.end_offsets,
            .ends = *args.table.candidates.ends,
            .positions_before =
                args.positions_before != nullptr ? *args.positions_before : args.numbers};
}

} // namespace

void Stages::chain(const ChainArgs& args) {
    const SilhouetteCandidates& candidates = args.table.candidates;
    const ChainTables absent = may_be_absent(args);
    ChainParameters parameters{.count = args.count,
                               .first = candidates.first,
                               .step = 0,
                               .eye = args.view.eye,
                               .contours = candidates.edges(),
                               .lifted = args.lifted ? 1U : 0U,
                               .follows = args.positions_before != nullptr ? 1U : 0U,
                               .outside = args.view.from_outside ? 1U : 0U};
    launch<kernels::chain_link>(args.count, parameters, args.table, args, absent);
    // A stretch is twice as long after each step. A loop is recognised when its stretch has gone
    // round.
    const auto steps = static_cast<std::uint32_t>(std::bit_width(args.count)) + 2;
    device_.clear(args.going, steps * sizeof(la_uint));
    parameters.count = 2 * args.count;
    Buffer* from = &args.ways;
    Buffer* to = &args.longer;
    for (parameters.step = 0; parameters.step < steps; ++parameters.step) {
        launch<kernels::chain_jump>(parameters.count, parameters,
                                    {.ways = *from, .longer = *to, .going = args.going});
        std::swap(from, to);
    }
    parameters.count = args.count;
    launch<kernels::chain_place>(args.count, parameters,
                                 {.ways = *from, .places = args.places, .lengths = args.starts});
    scan(args.starts, args.count, ScanKind::saturate);
    launch<kernels::chain_write>(args.count, parameters, args.table, args, absent);
}

} // namespace lineatlas::compute
