#include "paths.hpp"

#include <algorithm>
#include <cmath>

namespace lineatlas::bench {
namespace {

constexpr std::uint32_t path_length = 64;
constexpr float step = 2;

/// The visibility of sample after sample: 1 to 39 visible ones, then 1 to 39 hidden ones.
class Visible {
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

} // namespace

Paths make_paths(std::uint32_t n) {
    Random random{8};
    Visible visible_runs;
    Paths paths;
    paths.segments.reserve(n);
    paths.clipped.reserve(n);
    paths.offsets.assign(n + std::size_t{1}, 0);
    paths.arcs.assign(n + std::size_t{1}, 0);
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
            at + length * glm::vec2{std::cos(angle), std::sin(angle)} / Paths::viewport * 2.0F;
        paths.segments.push_back({.p = 0,
                                  .q = 0,
                                  .face_a = LA_NO_FACE,
                                  .face_b = LA_NO_FACE,
                                  .from_start = in_path,
                                  .to_end = std::min(path_length - 1 - in_path, n - 1 - i),
                                  .path = i / path_length,
                                  .tag = LA_KIND_CREASE});
        paths.clipped.push_back({.p = {at.x, at.y, 0, 1},
                                 .q = {to.x, to.y, 0, 1},
                                 .t0 = 0,
                                 .t1 = 1,
                                 .own_a = 0,
                                 .own_b = 0});
        paths.arcs[i + 1] =
            paths.arcs[i] + static_cast<std::uint32_t>(length * LA_ARC_UNITS_PER_PIXEL);
        bool in_run = false;
        for (std::uint32_t a = 0; a < samples && !hidden_whole; ++a) {
            const bool visible = visible_runs.next(random);
            paths.alpha.push_back(visible ? 255 : 0);
            if (visible && !in_run) paths.runs.push_back(i);
            in_run = visible;
        }
        paths.offsets[i + 1] = static_cast<std::uint32_t>(paths.alpha.size());
        at = to;
    }
    return paths;
}

PathTables::PathTables(compute::Device& device, const Paths& paths)
    : count(static_cast<std::uint32_t>(paths.segments.size())),
      samples(static_cast<std::uint32_t>(paths.alpha.size())),
      runs(static_cast<std::uint32_t>(paths.runs.size())),
      vertices(to_device(device, std::vector<glm::vec3>(2))),
      segments(to_device(device, paths.segments)), clipped(to_device(device, paths.clipped)),
      offsets(to_device(device, paths.offsets)), arcs(to_device(device, paths.arcs)),
      alpha(to_device(device, paths.alpha)) {}

RunTables::RunTables(compute::Device& device, std::uint32_t capacity_)
    : capacity(capacity_), runs(device.allocate(capacity * sizeof(Run))),
      record(device.allocate(sizeof(FrameRecord))) {}

std::vector<Run> RunTables::read(compute::Device& device) const {
    const std::uint32_t total = read_back<FrameRecord>(device, *record, 1)[0].run_total;
    require(total <= capacity, "what writes runs");
    return read_back<Run>(device, *runs, total);
}

void compact(compute::Stages& stages, const PathTables& paths, const RunTables& to) {
    stages.compact({.table = paths.table(),
                    .atlas = paths.atlas(),
                    .viewport = Paths::viewport,
                    .half_width = 1,
                    .runs = {*to.runs, *to.record, to.capacity}});
    stages.device().finish();
}

} // namespace lineatlas::bench
