#include "intervals.hpp"

#include <algorithm>

namespace lineatlas::python {
namespace {

/// An index as a signed number: the library's 0xFFFFFFFF (none) becomes -1.
std::int32_t signed_index(std::uint32_t index) {
    return static_cast<std::int32_t>(index);
}

std::int32_t group_of(const Mesh& mesh, std::uint32_t triangle) {
    return triangle < mesh.triangle_group.size() ? signed_index(mesh.triangle_group[triangle]) : -1;
}

IntervalRow row_of(const Interval& interval, const ModelLines& subject, float height) {
    const Segment& segment = subject.lines.segments[interval.segment];
    const LineSource& source = subject.lines.sources[interval.segment];
    IntervalRow row{.p = {interval.start[0], height - interval.start[1]},
                    .q = {interval.end[0], height - interval.end[1]},
                    .p_depth = interval.start_depth,
                    .q_depth = interval.end_depth,
                    .p_world = {},
                    .q_world = {},
                    .alpha = interval.alpha,
                    .kind = static_cast<std::uint8_t>(segment.tag & LA_TAG_KIND_MASK),
                    .visible = (interval.flags & LA_INTERVAL_VISIBLE) != 0,
                    .segment = signed_index(interval.segment),
                    .path = signed_index(segment.path),
                    .edge = {signed_index(source.from), signed_index(source.to)},
                    .triangle = signed_index(source.triangle),
                    .crossing = signed_index(source.crossing),
                    .group = group_of(subject.model->mesh, source.triangle)};
    std::ranges::copy(interval.start_world, row.p_world);
    std::ranges::copy(interval.end_world, row.q_world);
    return row;
}

} // namespace

std::vector<IntervalRow> interval_rows(const FoundIntervals& found, int height) {
    std::vector<IntervalRow> rows;
    rows.reserve(found.intervals.size());
    for (const Interval& interval : found.intervals)
        rows.push_back(row_of(interval, *found.subject, static_cast<float>(height)));
    return rows;
}

void register_interval_row() {
    PYBIND11_NUMPY_DTYPE(IntervalRow, p, q, p_depth, q_depth, p_world, q_world, alpha, kind,
                         visible, segment, path, edge, triangle, crossing, group);
}

} // namespace lineatlas::python
