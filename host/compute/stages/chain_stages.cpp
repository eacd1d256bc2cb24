// Silhouettes of a frame, and the chains that they make.
#include <bit>

#include "stages.hpp"

namespace lineatlas::compute {

namespace {

/// A table that is not read where there are no contours.
Buffer& contour_ends(const SegmentTable& table, Buffer* ends) {
    return ends != nullptr ? *ends : table.segments;
}

} // namespace

void Stages::contour_normals(const ContourNormalsArgs& args) {
    launch<kernels::contour_normals>(args.count, tuning_.local_size, {args.count},
                                     {.vertices = args.vertices,
                                      .triangles = args.triangles,
                                      .offsets = args.offsets,
                                      .places = args.places,
                                      .corners = args.corners});
}

void Stages::contour_turn(const ContourTurnArgs& args) {
    launch<kernels::contour_turn>(
        args.count, tuning_.local_size, {args.count},
        {.rest = args.rest, .objects = args.objects, .turns = args.turns, .corners = args.corners});
}

void Stages::contour(const ContourArgs& args) {
    const ContourTables& contours = args.contours;
    const auto corner_count =
        static_cast<std::uint32_t>(contours.corners->size() / sizeof(ContourCorner));
    Buffer& facing = scratch(corner_facing_, corner_count);
    ContourParameters parameters{
        .count = corner_count, .first_vertex = contours.vertex_count, .eye = args.eye};
    launch<kernels::contour_facing>(
        corner_count, tuning_.local_size, parameters,
        {.corners = *contours.corners, .vertices = args.vertices, .facing = facing});
    parameters.count = contours.edge_count;
    launch<kernels::contour_points>(contours.edge_count, tuning_.local_size, parameters,
                                    {.facing = facing,
                                     .corners = *contours.corners,
                                     .edges = *contours.edges,
                                     .triangles = args.triangles,
                                     .front = args.front,
                                     .vertices = args.vertices,
                                     .crossed = args.crossed});
    parameters.count = contours.face_count;
    launch<kernels::contour_ends>(contours.face_count, tuning_.local_size, parameters,
                                  {.faces = *contours.faces,
                                   .crossed = args.crossed,
                                   .edges = *contours.edges,
                                   .corners = *contours.corners,
                                   .vertices = args.vertices,
                                   .facing = facing,
                                   .contour_ends = args.ends});
}

void Stages::silhouette(const SilhouetteArgs& args) {
    const SilhouetteCandidates& candidates = args.table.candidates;
    launch<kernels::silhouette>(candidates.drawable(), tuning_.local_size,
                                {.count = candidates.drawable(),
                                 .first = candidates.first,
                                 .replaced = candidates.kept_edges()},
                                {.segments = args.table.segments,
                                 .front = args.front,
                                 .contour_ends = contour_ends(args.table, args.contour_ends),
                                 .numbers = args.numbers});
    scan(args.numbers, candidates.drawable(), ScanKind::saturate);
}

void Stages::chain(const ChainArgs& args) {
    const SilhouetteCandidates& candidates = args.table.candidates;
    const bool lifted = args.lifted && candidates.contours;
    Buffer& contours = contour_ends(args.table, args.contour_ends);
    ChainParameters parameters{.count = candidates.drawable(),
                               .first = candidates.first,
                               .step = 0,
                               .eye = args.view.eye,
                               .replaced = candidates.kept_edges(),
                               .contours = candidates.edges(),
                               .lift = lifted ? candidates.contours->edge_count : 0,
                               .follows = args.positions_before != nullptr ? 1U : 0U,
                               .outside = args.view.from_outside ? 1U : 0U};
    launch<kernels::chain_link>(candidates.drawable(), tuning_.local_size, parameters,
                                {.segments = args.table.segments,
                                 .contour_ends = contours,
                                 .vertices = args.table.vertices,
                                 .end_offsets = *candidates.end_offsets,
                                 .ends = *candidates.ends,
                                 .numbers = args.numbers,
                                 // Any table will do where there is no frame before.
                                 .positions_before = args.positions_before != nullptr
                                                         ? *args.positions_before
                                                         : args.numbers,
                                 .chosen = args.chosen,
                                 .ways = args.ways,
                                 .positions = args.positions});
    // A stretch is twice as long after each step; that a loop is one shows when it has gone round.
    const auto steps = static_cast<std::uint32_t>(std::bit_width(args.count)) + 2;
    device_.clear(args.going, steps * sizeof(la_uint));
    parameters.count = 2 * args.count;
    Buffer* from = &args.ways;
    Buffer* to = &args.longer;
    for (parameters.step = 0; parameters.step < steps; ++parameters.step) {
        launch<kernels::chain_jump>(parameters.count, tuning_.local_size, parameters,
                                    {.ways = *from, .longer = *to, .going = args.going});
        std::swap(from, to);
    }
    parameters.count = args.count;
    launch<kernels::chain_place>(args.count, tuning_.local_size, parameters,
                                 {.ways = *from, .places = args.places, .lengths = args.starts});
    scan(args.starts, args.count, ScanKind::saturate);
    launch<kernels::chain_write>(args.count, tuning_.local_size, parameters,
                                 {.segments = args.table.segments,
                                  .contour_ends = contours,
                                  .chosen = args.chosen,
                                  .places = args.places,
                                  .starts = args.starts,
                                  .ordered = args.ordered,
                                  .origins = args.origins,
                                  .positions = args.positions});
}

} // namespace lineatlas::compute
