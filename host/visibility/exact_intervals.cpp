#include "exact_intervals.hpp"

#include "outline_parts.hpp"

namespace lineatlas {

ExactIntervals::ExactIntervals(compute::Stages& stages, const PlacedLines& lines)
    : stages_(stages), lines_(stages), intervals_(stages.device()) {
    lines_.make_tables(lines.tables.most_fixed_segments());
}

std::vector<Interval> ExactIntervals::find(const PlacedLines& lines, const LineView& view,
                                           const Wanted& wanted, const ProgressPart& progress) {
    const std::size_t chunks = lines.tables.chunks.size();
    intervals_.begin_frame(true);
    lines_.find(
        view, chunks, progress, [&](std::size_t chunk) { return lines.chunk(chunk); },
        [](const char*, const auto& action) { action(); },
        [&](std::size_t chunk, const compute::SegmentTable& segments,
            const compute::SpanTable& spans) {
            do {
                stages_.span_intervals({.table = segments,
                                        .clipped = lines_.clipped(),
                                        .spans = spans,
                                        .viewport = view.viewport(),
                                        .hidden_too = wanted.hidden,
                                        .into = intervals_.room()});
                intervals_.read_total();
            } while (intervals_.grow());
            const SegmentRange range = lines.tables.chunks[chunk].range;
            if (wanted.outlines != nullptr) {
                add_outline_parts(stages_.device(), lines_.outline(wanted.outline_depth),
                                  intervals_.read_table(), lines_.order(), range.first,
                                  segments.segment_count, *wanted.outlines);
            }
            if (chunks > 1) intervals_.keep(range.first, lines_.order(), {});
        });
    std::vector<Interval> found = intervals_.read(lines_.order(), {});
    progress(1);
    return found;
}

} // namespace lineatlas
