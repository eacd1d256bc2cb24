// intervals: visible intervals of n segments in paths (paths.hpp). Their ends are refined against
// an empty depth buffer. Bytes: per segment its offset (4); per sample 1; per interval the interval
// (76, written and then changed by the last step: 152), its segment (32), its clipped segment (48)
// and an arc length (4). Reads of the depth buffer do not count.

#include "paths.hpp"

namespace lineatlas::bench {
namespace {

double bytes_of(const Paths& paths, std::uint32_t intervals) {
    return 4.0 * static_cast<double>(paths.offsets.size()) +
           static_cast<double>(paths.alpha.size()) + 236.0 * intervals;
}

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Paths paths = make_paths(n);
    const PathTables on{device, paths};
    const glm::ivec2 depth_size{Paths::viewport};
    const SharedBuffer depth =
        to_device(device, std::vector<float>(std::size_t(depth_size.x * depth_size.y), 1.0F));
    // A run gives one interval, and one more for each end at a join.
    const std::uint32_t capacity = 3 * on.runs;
    const SharedBuffer intervals = device.allocate(capacity * sizeof(Interval));
    const SharedBuffer total = device.allocate(sizeof(std::uint32_t));
    const auto run = [=, &stages] {
        stages.intervals({.table = on.table(),
                          .atlas = on.atlas(),
                          .viewport = Paths::viewport,
                          .depth = {*depth, depth_size, 1, 1e-4F},
                          .hidden_too = false,
                          .into = {*intervals, capacity, *total}});
        stages.device().finish();
    };
    run();
    const std::uint32_t count = read_back<std::uint32_t>(device, *total, 1)[0];
    require(count >= on.runs && count <= capacity, "intervals");
    return {.run = run, .bytes = bytes_of(paths, count), .result = [&device, intervals, count] {
                return members(read_back<Interval>(device, *intervals, count), &Interval::segment);
            }};
}

} // namespace

Rows intervals_rows(const Devices& devices) {
    return own_rows(devices, "intervals", prepare);
}

} // namespace lineatlas::bench
