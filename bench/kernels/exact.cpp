// surfaces, tile_lists, visible, spans: the method exact on n segments and n triangles of a
// terrain. Bytes: an estimate for a segment and a triangle in the tables of the stage.

#include <algorithm>
#include <iterator>
#include <memory>

#include <glm/matrix.hpp>

#include "compute/stages/exact_visibility.hpp"
#include "lineatlas/mesh.hpp"
#include "terrain.hpp"

namespace lineatlas::bench {
namespace {

constexpr glm::ivec2 size{1024, 768};

/// A terrain after every stage has run once.
struct Found {
    Found(compute::Stages& stages, std::uint32_t n)
        : terrain(make_terrain(n, n)), count(n),
          triangle_count(static_cast<std::uint32_t>(terrain.triangles.size() / 3)),
          vertices(to_device(stages.device(), terrain.vertices)),
          triangles(to_device(stages.device(), terrain.triangles)),
          segments(to_device(stages.device(), terrain.segments)),
          front(to_device(stages.device(), std::vector<std::uint8_t>(triangle_count))),
          clipped_table(stages.device().allocate(n * sizeof(ClippedSegment))),
          no_offsets(to_device(stages.device(), std::vector<std::uint32_t>(n + 1))),
          arcs(stages.device().allocate((n + std::size_t{1}) * sizeof(std::uint32_t))),
          visibility(stages) {
        const Camera camera{
            .view = glm::mat4{1}, .projection = terrain.clip_from_world, .size = size};
        visibility.begin(table(), camera, {{-1, 0, -1}, {1, 1, 1}}, 6e-6F);
        stages.project_clip({.table = table(),
                             .front = *front,
                             .clip_from_world = terrain.clip_from_world,
                             .viewport = glm::vec2{size},
                             .step = 2,
                             .kind_mask = (1U << LA_KIND_COUNT) - 1,
                             .occlusion = nullptr,
                             .out = {*clipped_table, visibility.counts(), *arcs}});
        stages.scan(*arcs, n, compute::ScanKind::wrap);
        visibility.surfaces();
        do {
            visibility.tile_lists();
            visibility.visible(clipped());
            visibility.read_sizes();
        } while (visibility.grow(clipped()));
        runs = stages.device().allocate(2 * n * sizeof(Run));
        record = stages.device().allocate(sizeof(FrameRecord));
        intervals = stages.device().allocate(2 * n * sizeof(Interval));
        total = stages.device().allocate(sizeof(std::uint32_t));
        make_spans(stages);
    }

    compute::SegmentTable table() const {
        return {*vertices, *triangles, *segments, triangle_count, count};
    }
    compute::ClippedTable clipped() const { return {*clipped_table, *no_offsets, *arcs}; }
    void make_spans(compute::Stages& stages) const {
        stages.span_runs({.table = table(),
                          .clipped = clipped(),
                          .spans = visibility.spans(),
                          .viewport = glm::vec2{size},
                          .half_width = 1,
                          .hidden = false,
                          .runs = {*runs, *record, 2 * count}});
        stages.span_intervals({.table = table(),
                               .clipped = clipped(),
                               .spans = visibility.spans(),
                               .viewport = glm::vec2{size},
                               .hidden_too = false,
                               .into = {*intervals, 2 * count, *total}});
    }

    Terrain terrain;
    std::uint32_t count, triangle_count;
    SharedBuffer vertices, triangles, segments, front, clipped_table, no_offsets, arcs;
    compute::ExactVisibility visibility;
    SharedBuffer runs, record, intervals, total;
};

/// A job that repeats one stage.
template <class Stage>
Job job(compute::Stages& stages, std::uint32_t n, double bytes, Stage stage) {
    const auto found = std::make_shared<Found>(stages, n);
    const auto run = [&stages, found, stage] {
        stage(stages, *found);
        stages.device().finish();
    };
    run();
    return {.run = run, .bytes = bytes * n, .result = [&stages, found] {
                return members(
                    read_back<Run>(
                        stages.device(), *found->runs,
                        read_back<FrameRecord>(stages.device(), *found->record, 1)[0].points[0]),
                    &Run::segment);
            }};
}

Job prepare_surfaces(compute::Stages& stages, std::uint32_t n) {
    return job(stages, n, 100, [](compute::Stages&, Found& found) { found.visibility.surfaces(); });
}
Job prepare_tile_lists(compute::Stages& stages, std::uint32_t n) {
    return job(stages, n, 120,
               [](compute::Stages&, Found& found) { found.visibility.tile_lists(); });
}
Job prepare_visible(compute::Stages& stages, std::uint32_t n) {
    return job(stages, n, 200,
               [](compute::Stages&, Found& found) { found.visibility.visible(found.clipped()); });
}
Job prepare_spans(compute::Stages& stages, std::uint32_t n) {
    return job(stages, n, 250, [](compute::Stages& on, Found& found) { found.make_spans(on); });
}

} // namespace

Rows exact_rows(const Devices& devices) {
    Rows result;
    for (Rows rows : {own_rows(devices, "surfaces", prepare_surfaces),
                      own_rows(devices, "tile_lists", prepare_tile_lists),
                      own_rows(devices, "visible", prepare_visible),
                      own_rows(devices, "spans", prepare_spans)}) {
        std::ranges::move(rows, std::back_inserter(result));
    }
    return result;
}

} // namespace lineatlas::bench
