#include "outline_parts.hpp"

#include <algorithm>
#include <cstddef>

#include "compute/transfer.hpp"

namespace lineatlas {
namespace {

/// A part from one place of a segment to another, in the units of intervals.
struct Part {
    float from, to;
};

/// The parts of one segment, ascending and joined where they overlap.
std::vector<Part> joined(std::span<const Part> parts) {
    std::vector<Part> sorted{parts.begin(), parts.end()};
    std::ranges::sort(sorted, {}, &Part::from);
    std::vector<Part> result;
    for (const Part part : sorted) {
        if (!result.empty() && part.from <= result.back().to)
            result.back().to = std::max(result.back().to, part.to);
        else
            result.push_back(part);
    }
    return result;
}

glm::vec2 place(const Interval& interval, float sample) {
    const glm::vec2 start{interval.start[0], interval.start[1]};
    const glm::vec2 end{interval.end[0], interval.end[1]};
    if (sample == interval.start_sample) return start;
    if (sample == interval.end_sample) return end;
    const float share =
        (sample - interval.start_sample) / (interval.end_sample - interval.start_sample);
    return start + (end - start) * share;
}

} // namespace

void add_outline_parts(compute::Device& device, const compute::OutlineTable& table,
                       std::span<const Interval> intervals, const TableOrder& order,
                       std::uint32_t first_segment, std::uint32_t segment_count,
                       std::vector<OutlinePart>& result) {
    const auto offsets =
        compute::read_back<la_uint>(device, table.part_offsets, std::size_t{segment_count} + 1);
    if (offsets.back() == 0) return;
    const auto parts = compute::read_back<Part>(device, table.parts, offsets.back());
    std::vector<OutlinePart> found;
    for (const Interval& interval : intervals) {
        if ((interval.flags & LA_INTERVAL_VISIBLE) == 0) continue;
        const std::span<const Part> of_segment{parts.begin() + offsets[interval.segment],
                                               parts.begin() + offsets[interval.segment + 1]};
        for (const Part part : joined(of_segment)) {
            const float from = std::max(part.from, interval.start_sample);
            const float to = std::min(part.to, interval.end_sample);
            if (!(from < to)) continue;
            found.push_back({.segment = interval.segment,
                             .start = place(interval, from),
                             .end = place(interval, to)});
        }
    }
    order.restore(found);
    for (OutlinePart& part : found) {
        part.segment += first_segment;
        result.push_back(part);
    }
}

} // namespace lineatlas
