// intervals: visible pieces of n segments in paths (paths.hpp), their ends narrowed down before an
// empty depth buffer. Bytes: per segment its offset (4); per sample 1; per interval itself (76,
// read and written again by the last step: 152), its segment (32), its clipped segment (48) and an
// arc length (4); what is read of the depth is left out.

#include "common.hpp"
#include "paths.hpp"

namespace lineatlas::bench {
namespace {

double bytes_of(const Paths& paths, std::uint32_t intervals) {
    return 4.0 * static_cast<double>(paths.offsets.size()) +
           static_cast<double>(paths.alpha.size()) + 236.0 * intervals;
}

Job prepare(compute::Backend& backend, std::uint32_t n) {
    const Paths paths = make_paths(n);
    const glm::ivec2 depth_size{Paths::viewport};
    const SharedBuffer vertices = to_device(backend, std::vector<glm::vec3>(2));
    const SharedBuffer segments = to_device(backend, paths.segments);
    const SharedBuffer clipped = to_device(backend, paths.clipped);
    const SharedBuffer offsets = to_device(backend, paths.offsets);
    const SharedBuffer arcs = to_device(backend, paths.arcs);
    const SharedBuffer alpha = to_device(backend, paths.alpha);
    const SharedBuffer depth =
        to_device(backend, std::vector<float>(std::size_t(depth_size.x * depth_size.y), 1.0F));
    // A run is an interval, and each end at a joint may add one.
    const auto capacity = static_cast<std::uint32_t>(3 * paths.runs.size());
    const auto samples = static_cast<std::uint32_t>(paths.alpha.size());
    const SharedBuffer intervals = backend.allocate(capacity * sizeof(Interval));
    const SharedBuffer total = backend.allocate(sizeof(std::uint32_t));
    const AtlasLayout layout = make_atlas_layout(AtlasLayoutKind::wrap, 7, 16384);
    const auto run = [=, &backend] {
        backend.intervals({.table = {*vertices, *vertices, *segments, 0, n},
                           .clipped = {*clipped, *offsets, *arcs},
                           .alpha = *alpha,
                           .layout = layout,
                           .capacity = samples,
                           .viewport = Paths::viewport,
                           .depth = *depth,
                           .depth_size = depth_size,
                           .depth_scale = 1,
                           .tolerance = 1e-4F,
                           .hidden_too = false,
                           .intervals = *intervals,
                           .interval_capacity = capacity,
                           .total = *total});
        backend.finish();
    };
    run();
    const std::uint32_t count = read_back<std::uint32_t>(backend, *total, 1)[0];
    require(count >= paths.runs.size() && count <= capacity, "intervals");
    return {.run = run, .bytes = bytes_of(paths, count)};
}

} // namespace

Rows intervals_rows(const Backends& backends) {
    return own_rows(backends, "intervals", prepare);
}

} // namespace lineatlas::bench
