// compact_runs: n segments in paths of 64. As in a frame most have no samples: two paths of three
// are hidden whole. Those of the third have 1 to 7 samples each, visible in stretches of 1 to 39.
// Bytes: per segment its offset (4); per sample 1; per run the run (64), its segment (32), its
// clipped segment (48) and an arc length (4).

#include <algorithm>
#include <cmath>

#include "common.hpp"

namespace lineatlas::bench {
namespace {

constexpr glm::vec2 viewport{1024, 768};
constexpr std::uint32_t path_length = 64;
constexpr float step = 2;

struct Input {
    std::vector<Segment> segments;
    std::vector<ClippedSegment> clipped;
    std::vector<std::uint32_t> offsets, arcs;
    std::vector<std::uint8_t> alpha;
    std::vector<std::uint32_t> runs; ///< the segment of each run that is to be found
};

/// Samples that are visible or hidden in turns.
class Stretches {
  public:
    bool next(Random& random) {
        if (left_ == 0) {
            visible_ = !visible_;
            left_ = 1 + random.below(39);
        }
        --left_;
        return visible_;
    }

  private:
    bool visible_ = false;
    std::uint32_t left_ = 0;
};

Input make_input(std::uint32_t n) {
    Random random{8};
    Stretches stretches;
    Input input;
    input.segments.reserve(n);
    input.clipped.reserve(n);
    input.offsets.assign(n + std::size_t{1}, 0);
    input.arcs.assign(n + std::size_t{1}, 0);
    glm::vec2 at{0};
    float angle = 0;
    bool hidden_whole = false;
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t in_path = i % path_length;
        if (in_path == 0) {
            at = {random.between(-0.7F, 0.7F), random.between(-0.7F, 0.7F)};
            angle = random.between(0, 6.2831853F);
            hidden_whole = random.below(3) != 0;
        }
        angle += random.between(-0.5F, 0.5F);
        const std::uint32_t samples = 1 + random.below(7);
        const float length = step * static_cast<float>(samples);
        const glm::vec2 to =
            at + length * glm::vec2{std::cos(angle), std::sin(angle)} / viewport * 2.0F;
        input.segments.push_back({.p = 0,
                                  .q = 0,
                                  .face_a = LA_NO_FACE,
                                  .face_b = LA_NO_FACE,
                                  .from_start = in_path,
                                  .to_end = std::min(path_length - 1 - in_path, n - 1 - i),
                                  .path = i / path_length,
                                  .tag = LA_KIND_CREASE});
        input.clipped.push_back({.p = {at.x, at.y, 0, 1},
                                 .q = {to.x, to.y, 0, 1},
                                 .t0 = 0,
                                 .t1 = 1,
                                 .own_a = 0,
                                 .own_b = 0});
        input.arcs[i + 1] =
            input.arcs[i] + static_cast<std::uint32_t>(length * LA_ARC_UNITS_PER_PIXEL);
        bool in_run = false;
        for (std::uint32_t a = 0; a < samples && !hidden_whole; ++a) {
            const bool visible = stretches.next(random);
            input.alpha.push_back(visible ? 255 : 0);
            if (visible && !in_run) input.runs.push_back(i);
            in_run = visible;
        }
        input.offsets[i + 1] = static_cast<std::uint32_t>(input.alpha.size());
        at = to;
    }
    return input;
}

double bytes_of(const Input& input) {
    return 4.0 * static_cast<double>(input.offsets.size()) +
           static_cast<double>(input.alpha.size()) + 148.0 * static_cast<double>(input.runs.size());
}

void check(compute::Backend& backend, const Input& input, compute::Buffer& runs,
           compute::Buffer& record) {
    require(read_back<FrameRecord>(backend, record, 1)[0].run_total == input.runs.size(),
            "compact_runs");
    const auto found = read_back<Run>(backend, runs, input.runs.size());
    require(std::ranges::equal(found, input.runs, {}, &Run::segment), "compact_runs");
}

Job prepare(compute::Backend& backend, std::uint32_t n) {
    const Input input = make_input(n);
    const SharedBuffer none = backend.allocate(sizeof(glm::vec4)); // it reads no mesh
    const SharedBuffer segments = to_device(backend, input.segments);
    const SharedBuffer clipped = to_device(backend, input.clipped);
    const SharedBuffer offsets = to_device(backend, input.offsets);
    const SharedBuffer arcs = to_device(backend, input.arcs);
    const SharedBuffer alpha = to_device(backend, input.alpha);
    const auto run_count = static_cast<std::uint32_t>(input.runs.size());
    const auto samples = static_cast<std::uint32_t>(input.alpha.size());
    const SharedBuffer runs = backend.allocate(run_count * sizeof(Run));
    const SharedBuffer record = backend.allocate(sizeof(FrameRecord));
    const AtlasLayout layout = make_atlas_layout(AtlasLayoutKind::wrap, 7, 16384);
    const auto run = [=, &backend] {
        backend.compact_runs({.table = {*none, *none, *segments, 0, n},
                              .clipped = {*clipped, *offsets, *arcs},
                              .alpha = *alpha,
                              .layout = layout,
                              .capacity = samples,
                              .viewport = viewport,
                              .half_width = 1,
                              .runs = *runs,
                              .run_capacity = run_count,
                              .record = *record});
        backend.finish();
    };
    run();
    check(backend, input, *runs, *record);
    return {.run = run, .bytes = bytes_of(input)};
}

} // namespace

Rows compact_runs_rows(const Backends& backends) {
    Rows rows = own_rows(backends, "compact_runs", prepare);
    rows.push_back(copy_row(backends, "compact_runs",
                            [](std::uint32_t n) { return bytes_of(make_input(n)); }));
    return rows;
}

} // namespace lineatlas::bench
