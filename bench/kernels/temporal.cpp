// temporal: n segments in paths (paths.hpp). Of every fourth path less was inside the last picture.
// Bytes: per segment its two offsets (8), its range read and written (8) and its offset copied (8);
// per segment with samples the clipped segment (48); per sample the sample and that of the last
// frame read (2), the result written (1) and copied (2).

#include <algorithm>

#include "paths.hpp"

namespace lineatlas::bench {
namespace {

double bytes_of(const Paths& paths) {
    double bytes = 24.0 * static_cast<double>(paths.segments.size()) +
                   5.0 * static_cast<double>(paths.alpha.size());
    for (std::size_t i = 0; i < paths.segments.size(); ++i) {
        if (paths.offsets[i + 1] != paths.offsets[i]) bytes += 48;
    }
    return bytes;
}

/// The range of each segment that was inside the last picture.
std::vector<std::uint32_t> make_ranges(const Paths& paths) {
    constexpr std::uint32_t whole = 65535U << 16U, less = 60000U << 16U;
    std::vector<std::uint32_t> ranges;
    for (const Segment& segment : paths.segments) {
        ranges.push_back(segment.path % 4 == 0 ? less : whole);
    }
    return ranges;
}

/// The samples of the last frame: a little off those of this frame, as after a slow move.
std::vector<std::uint8_t> make_before(const Paths& paths) {
    Random random{10};
    std::vector<std::uint8_t> before = paths.alpha;
    for (std::uint8_t& alpha : before) {
        const auto off = static_cast<std::uint8_t>(random.below(90));
        alpha = alpha == 0 ? off : static_cast<std::uint8_t>(alpha - off);
    }
    return before;
}

Job prepare(compute::Stages& stages, std::uint32_t n) {
    compute::Device& device = stages.device();
    const Paths paths = make_paths(n);
    const PathTables on{device, paths};
    const std::vector<std::uint8_t> before_values = make_before(paths);
    const std::vector<std::uint32_t> range_values = make_ranges(paths);
    const SharedBuffer before = to_device(device, before_values);
    const SharedBuffer offsets = to_device(device, paths.offsets);
    const SharedBuffer ranges = to_device(device, range_values);
    const auto reset = [=, &device, alpha = paths.alpha] {
        write(device, *on.alpha, alpha);
        write(device, *before, before_values);
        write(device, *ranges, range_values);
    };
    const auto run = [=, &stages] {
        stages.temporal({.segment_count = on.count,
                         .atlas = on.atlas(),
                         .history = {*before, *offsets, *ranges},
                         .use = LA_HISTORY_CAMERA});
        stages.device().finish();
    };
    run();
    const auto result = [&device, on] {
        return read_back<std::uint8_t>(device, *on.alpha, on.samples);
    };
    require(result() != paths.alpha, "temporal");
    return {.run = run, .bytes = bytes_of(paths), .reset = reset, .result = result};
}

} // namespace

Rows temporal_rows(const Devices& devices) {
    return own_rows(devices, "temporal", prepare);
}

} // namespace lineatlas::bench
