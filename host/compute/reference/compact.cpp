#include <algorithm>
#include <vector>

#include "runs.hpp"
#include "stages.hpp"

namespace lineatlas::compute::reference {
namespace {

/// The run of samples [a, end) of segment i.
Run make_sampled_run(const FrameTables& frame, const AtlasLayout& layout, std::uint32_t i,
                     std::uint32_t a, std::uint32_t end) {
    const std::uint32_t l = frame.samples(i);
    // A run fades out half a sample beyond its last one: alpha is interpolated.
    const float start_sample = a == 0 ? 0.0F : static_cast<float>(a) - 0.5F;
    const float end_sample = end == l ? static_cast<float>(l) : static_cast<float>(end) + 0.5F;
    const End between{LA_END_HIDDEN};
    Run run = make_run(frame, i, start_sample, end_sample, l,
                       a == 0 ? segment_end(frame, i, false) : between,
                       end == l ? segment_end(frame, i, true) : between);
    run.address = layout.address(frame.offsets[i]);
    return run;
}

/// Whether segment i is a path of its own and shorter than a pixel; see compact.cl.
bool is_dot(const FrameTables& frame, std::uint32_t i) {
    const Segment& segment = frame.segments[i];
    return (segment.from_start | segment.to_end) == 0 &&
           (segment.tag & LA_TAG_KIND_MASK) != LA_KIND_SILHOUETTE &&
           static_cast<float>(frame.arcs[i + 1] - frame.arcs[i]) < LA_ARC_UNITS_PER_PIXEL;
}

} // namespace

void compact_runs(const CompactRunsInput& in, std::span<Run> runs, FrameRecord& record) {
    const FrameTables frame{.segments = in.segments,
                            .clipped = in.clipped,
                            .offsets = in.offsets,
                            .arcs = in.arcs,
                            .viewport = in.viewport,
                            .half_width = in.half_width};
    std::vector<Run> result;
    for (std::uint32_t i = 0; i < in.segments.size(); ++i) {
        const std::uint32_t s = in.offsets[i];
        const std::uint32_t l = in.offsets[i + 1] - s;
        if (in.hidden && is_dot(frame, i)) continue;
        if (in.hidden && l == 0 && frame.is_drawn(i)) { // dropped as hidden whole
            result.push_back(make_run(frame, i, 0, 1, 1, segment_end(frame, i, false),
                                      segment_end(frame, i, true)));
            result.back().flags |= LA_RUN_SOLID;
        }
        if (l == 0 || l > in.capacity || s > in.capacity - l) continue;
        const std::span own = in.alpha.subspan(in.layout.address(s), l);
        const auto wanted = [&](std::uint8_t alpha) { return (alpha == 0) == in.hidden; };
        for (auto a = own.begin(); a != own.end();) {
            a = std::find_if(a, own.end(), wanted);
            if (a == own.end()) break;
            const auto end = std::find_if_not(a, own.end(), wanted);
            result.push_back(make_sampled_run(frame, in.layout, i,
                                              static_cast<std::uint32_t>(a - own.begin()),
                                              static_cast<std::uint32_t>(end - own.begin())));
            a = end;
        }
    }
    if (result.size() <= runs.size()) std::ranges::copy(result, runs.begin()); // else none, as told
    record = make_record(result.size(), runs.size(), in.offsets[in.segments.size()]);
}

std::uint32_t compact_samples(std::span<const std::uint8_t> alpha,
                              std::span<std::uint32_t> packed) {
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < alpha.size(); ++i) {
        if (alpha[i] != 0) packed[count++] = i;
    }
    return count;
}

} // namespace lineatlas::compute::reference
