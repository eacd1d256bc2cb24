/* filter: changes visible strokes along their paths (§4.5): closes short holes, drops short runs,
 * lets strokes overshoot or fall short of their ends, and cuts gaps into them beside nearer lines.
 * A change never goes from one path to another.
 *
 * It works on intervals of arc length, not on samples: the visible share of the sample at an end
 * says where the end lies, so lengths are exact. One work-item per run; the work-item of a path's
 * first run does the whole path. Three steps: count the resulting runs (and scan the counts), write
 * them, set the visibility of their samples. */

#include "kernels.h"
#include "shared/run.h"

/* Anything shorter than this, in pixels, is rounding of arc lengths. */
#define SHORTEST 0.01f
/* Samples that may fade out before an end. */
#define FADING_SAMPLES 8u

/* What all functions here need. `out` null: runs are only counted. */
typedef struct Work {
    Frame frame;
    __global const Run* runs;
    uint run_count;
    __global const RunCuts* cuts; /* or null */
    __global const uchar* alpha;
    uint capacity;    /* of the atlas */
    uint first, last; /* segments of the path */
    uint first_run, last_run;
    bool seam;   /* the path is closed, and drawn where its last segment meets its first */
    bool joined; /* and it is visible there */
    float
        seam_room; /* how far strokes may grow towards the seam: to the middle of the hidden part */
    float half_length;
    __global Run* out;
    uint count;
} Work;

/* A stroke: a visible interval of a path. */
typedef struct Stroke {
    float start, end; /* arc lengths */
    uint start_kind, end_kind;
    uint first_run, last_run;
    float start_overshoot, end_overshoot;
} Stroke;

static float2 segment_span(const Frame frame, const uint i) {
    const float start = segment_arc(frame, i);
    return float2(start, start + arc_pixels(frame.arcs[i + 1] - frame.arcs[i]));
}

/* The kind that an end of a run has as an end of a stroke. */
static uint stroke_end_kind(const uint kind) {
    return kind == LA_END_PATH || kind == LA_END_CLIPPED ? kind : LA_END_HIDDEN;
}

/* The outermost samples of a run. */
static uint2 end_samples(__global const Run* run) {
    const float start = run->start_sample, end = run->end_sample;
    return uint2(start > 0.0f ? (uint)(start + 0.5f) : 0u,
                 end < (float)run->samples ? (uint)(end - 0.5f) - 1u : run->samples - 1u);
}

static bool has_samples(__global const Run* run) {
    return (run->flags & LA_RUN_SOLID) == 0;
}

/* The interval of run r. Where visibility ends, the sample there is visible in part, and its
 * visible share says where in the sample the end lies. */
static Stroke run_interval(const Work* work, const uint r) {
    __global const Run* run = work->runs + r;
    const float2 span = segment_span(work->frame, run->segment);
    const float l = (float)run->samples;
    float start = 0.0f, end = l;
    __global const uchar* own = work->alpha + run->address;
    const bool starts = !shown_across(work->frame.segments, work->runs, work->run_count, r, false);
    const bool ends = !shown_across(work->frame.segments, work->runs, work->run_count, r, true);
    const uint2 outermost = end_samples(run);
    const uint a = outermost.x, b = outermost.y;
    const bool solid = !has_samples(run);
    const float share_a = solid ? 1.0f : (float)own[a] * (1.0f / 255.0f);
    const float share_b = solid ? 1.0f : (float)own[b] * (1.0f / 255.0f);
    if (solid) {
        start = run->start_sample;
        end = run->end_sample;
    } else if (starts && ends && a == b) {
        start = (float)a + 0.5f - 0.5f * share_a;
        end = (float)a + 0.5f + 0.5f * share_a;
    } else {
        if (starts) start = (float)(a + 1u) - share_a;
        if (ends) end = (float)b + share_b;
    }
    const float per_sample = (span.y - span.x) / l;
    Stroke interval;
    interval.start = starts ? span.x + start * per_sample : span.x;
    interval.end = ends ? span.x + end * per_sample : span.y;
    interval.start_kind = stroke_end_kind(run->flags >> LA_RUN_START_SHIFT & LA_END_MASK);
    interval.end_kind = stroke_end_kind(run->flags >> LA_RUN_END_SHIFT & LA_END_MASK);
    interval.first_run = interval.last_run = r;
    interval.start_overshoot = interval.end_overshoot = 0.0f;
    return interval;
}

/* True if a stroke may go on beyond an end. Then its length is not known. */
static bool is_cut_off(const uint kind) {
    return kind == LA_END_CLIPPED || kind == LA_END_JOIN;
}

/* Whether the path is drawn all the way between two of its segments. */
static bool connected(const Frame frame, const uint from, const uint to) {
    for (uint i = from; i < to; ++i) {
        if (!goes_on(frame, i)) return false;
    }
    return true;
}

/* Length of stroke that run r draws between two arc lengths, times its opacity. */
static float ink_of(const Work* work, const uint r, const float low, const float high) {
    __global const Run* run = work->runs + r;
    const float2 span = segment_span(work->frame, run->segment);
    const float per_sample = (span.y - span.x) / (float)run->samples;
    __global const uchar* own = work->alpha + run->address;
    const int last = (int)run->samples - 1;
    const float from = (low - span.x) / per_sample, to = (high - span.x) / per_sample;
    float sum = 0.0f;
    for (int j = clamp((int)from, 0, last); j <= last && (float)j < to; ++j) {
        const float opacity =
            has_samples(run) ? fmin((float)own[j] * (1.0f / LA_FULLY_SHOWN), 1.0f) : 1.0f;
        sum += (fmin((float)(j + 1), to) - fmax((float)j, from)) * opacity;
    }
    return fmax(sum, 0.0f) * per_sample;
}

/* Length of stroke times opacity within `reach` of a place, from run r on forwards or backwards. */
static float ink_near(const Work* work, uint r, const float place, const bool forward,
                      const float reach) {
    const float low = forward ? place : place - reach;
    const float high = forward ? place + reach : place;
    const uint last = forward ? work->last_run : work->first_run;
    float sum = 0.0f, around = 0.0f;
    for (uint left = work->last_run - work->first_run + 1; left > 0; --left) {
        const Stroke own = run_interval(work, r);
        const float from = fmax(own.start, low - around), to = fmin(own.end, high - around);
        if (to < from) break;
        sum += ink_of(work, r, from, to);
        if (r == last) {
            if (!work->joined) break;
            around += forward ? 2.0f * work->half_length : -2.0f * work->half_length;
            r = forward ? work->first_run : work->last_run;
            continue;
        }
        const uint a = forward ? r : r - 1;
        if (!connected(work->frame, work->runs[a].segment, work->runs[a + 1].segment)) break;
        r = forward ? r + 1 : r - 1;
    }
    return sum;
}

/* The overshoot beside so much ink, at most `most` pixels. It grows with the square of the ink: a
 * crumb comes and goes with every texel, and a long overshoot of it would flash up. */
static float overshoot_beside(const float ink, const float most) {
    return fmin(ink * ink / most, most);
}

/* Where the overshoot of run r's end starts. Samples that fade out there count by their opacity. If
 * the overshoot started at the last sample, however faint, it would move with each sample that
 * comes or goes. `end`: the run's end, the result if no sample near it is shown in full. */
static float overshoot_start(const Work* work, const uint r, const bool at_end, const float end) {
    if (shown_across(work->frame.segments, work->runs, work->run_count, r, at_end)) return end;
    __global const Run* run = work->runs + r;
    if (!has_samples(run)) return end;
    const float2 span = segment_span(work->frame, run->segment);
    const float per_sample = (span.y - span.x) / (float)run->samples;
    __global const uchar* own = work->alpha + run->address;
    const uint2 outermost = end_samples(run);
    const uint count = min(outermost.y - outermost.x + 1u, FADING_SAMPLES);
    float length = 0.0f, opacity_after = 0.0f;
    for (uint k = 0; k < count; ++k) {
        const uint j = at_end ? outermost.y - k : outermost.x + k;
        const float share = (float)own[j] * (1.0f / 255.0f);
        const float opacity = fmin((float)own[j] * (1.0f / LA_FULLY_SHOWN), 1.0f);
        length = fmax(share, fmin(opacity, opacity_after)) + opacity * length;
        if (own[j] >= LA_FULLY_SHOWN)
            return span.x + (at_end ? (float)j + length : (float)(j + 1u) - length) * per_sample;
        opacity_after = opacity;
    }
    return end;
}

/* Sets how far either end of an interval overshoots. It never overshoots across a gap beside a
 * nearer line. */
static void set_overshoot(const Work* work, Stroke* interval, const float most) {
    interval->start_overshoot = interval->end_overshoot = 0.0f;
    if (!(most > 0.0f)) return;
    const uint first = interval->first_run, last = interval->last_run;
    const float start = overshoot_start(work, first, false, interval->start);
    const float end = overshoot_start(work, last, true, interval->end);
    const float before = overshoot_beside(ink_near(work, first, start, true, most), most);
    const float after = overshoot_beside(ink_near(work, last, end, false, most), most);
    interval->start_overshoot = fmax(before - (start - interval->start), 0.0f);
    interval->end_overshoot = fmax(after - (interval->end - end), 0.0f);
    for (uint r = first; work->cuts != 0 && r <= last; ++r) {
        for (int k = 0; k < LA_MOST_CUTS; ++k) {
            const float2 cut = float2(work->cuts[r].from[k], work->cuts[r].to[k]);
            if (!(cut.y > cut.x)) continue;
            if (cut.x < interval->start)
                interval->start_overshoot =
                    clamp(interval->start - cut.y, 0.0f, interval->start_overshoot);
            if (cut.y > interval->end)
                interval->end_overshoot =
                    clamp(cut.x - interval->end, 0.0f, interval->end_overshoot);
        }
    }
}

/* The number of samples of segment i, or 0 if the atlas is too small for them. Then the host
 * enlarges the atlas and does the frame again. */
static uint samples_of(const Work* work, const uint i) {
    const uint s = work->frame.offsets[i];
    const uint l = work->frame.offsets[i + 1] - s;
    return is_in_atlas(work->capacity, s, l) ? l : 0u;
}

/* Runs for a part of the path between two arc lengths, from segment i on. `stroke`: the whole
 * stroke's ends as arc lengths of this part. */
static void emit_part(Work* work, uint i, const float start, const float end, const uint start_kind,
                      const uint end_kind, const float2 stroke, const uint stroke_kinds) {
    const Frame frame = work->frame;
    bool begins = true, ends = false;
    while (!ends) {
        const float2 span = segment_span(frame, i);
        ends = end <= span.y + SHORTEST || i == work->last || !goes_on(frame, i);
        const float lo = begins ? start : span.x;
        const float hi = ends && end != span.y ? end : span.y;
        /* Rounding may leave a sliver of the segment where a stroke starts at a joint. */
        if (begins && !ends && span.y - start <= SHORTEST) {
            ++i;
            continue;
        }
        if (work->out != 0) {
            __global Run* run = work->out + work->count;
            const uint l = samples_of(work, i);
            const uint counted = max(l, 1u);
            const float per_pixel = (float)counted / (span.y - span.x);
            const float from = lo == span.x ? 0.0f : (lo - span.x) * per_pixel;
            const float to = hi == span.y ? (float)counted : (hi - span.x) * per_pixel;
            const float2 direction = window_direction(frame.clipped + i, frame.viewport);
            float2 start_corner = float2(0.0f, 0.0f), end_corner = start_corner;
            uint run_start = start_kind, run_end = end_kind;
            if (!begins || start_kind == LA_END_JOIN)
                run_start = segment_end(frame, i, 0, direction, &start_corner);
            if (!ends || end_kind == LA_END_JOIN)
                run_end = segment_end(frame, i, 1, direction, &end_corner);
            place_run(frame, i, from, to, counted, run);
            vstore2(start_corner, 0, run->start_corner);
            vstore2(end_corner, 0, run->end_corner);
            run->stroke_start = stroke.x;
            run->stroke_end = stroke.y;
            run->address = l > 0 ? frame.offsets[i] : 0u;
            run->flags = run_start << LA_RUN_START_SHIFT | run_end << LA_RUN_END_SHIFT |
                         stroke_kinds | (l == 0 ? LA_RUN_SOLID : 0u);
        }
        ++work->count;
        begins = false;
        ++i;
    }
}

/* Runs for one piece of a stroke. The piece may reach beyond the path: straight on if the path is
 * open, and around if it is closed. i: any segment at or before the start of the piece that is
 * connected with it. */
static void emit_piece(Work* work, uint i, const float start, const float end, uint start_kind,
                       uint end_kind) {
    if (end - start < SHORTEST) return;
    const Frame frame = work->frame;
    const uint kinds = start_kind << LA_STROKE_START_SHIFT | end_kind << LA_STROKE_END_SHIFT;
    /* All of a loop without an end is the middle of its stroke. */
    const bool endless = start_kind == LA_END_JOIN && end_kind == LA_END_JOIN;
    const float2 stroke = endless ? float2(-LA_ENDLESS, LA_ENDLESS) : float2(start, end);
    const float around = 2.0f * work->half_length;
    const float to = end;
    float from = start;
    if (work->seam && from < -work->half_length - SHORTEST) {
        uint tail = work->last; /* the part before the seam lies at the end of the path */
        while (tail > work->first && segment_span(frame, tail).x > from + around &&
               goes_on(frame, tail - 1))
            --tail;
        const bool all = to < -work->half_length + SHORTEST;
        emit_part(work, tail, fmax(from + around, segment_span(frame, tail).x),
                  all ? to + around : work->half_length, start_kind, all ? end_kind : LA_END_JOIN,
                  stroke + around, kinds);
        if (all) return;
        from = -work->half_length;
        start_kind = LA_END_JOIN;
    }
    if (work->seam && to > work->half_length + SHORTEST) {
        const bool all = from > work->half_length - SHORTEST;
        if (!all) {
            while (i < work->last && segment_span(frame, i).y < from && goes_on(frame, i)) ++i;
            emit_part(work, i, from, work->half_length, start_kind, LA_END_JOIN, stroke, kinds);
        }
        uint head = work->first;
        from = all ? from - around : -work->half_length;
        while (head < work->last && segment_span(frame, head).y < from && goes_on(frame, head))
            ++head;
        emit_part(work, head, from, to - around, all ? start_kind : LA_END_JOIN, end_kind,
                  stroke - around, kinds);
        return;
    }
    while (i < work->last && segment_span(frame, i).y < from && goes_on(frame, i)) ++i;
    emit_part(work, i, from, to, start_kind, end_kind, stroke, kinds);
}

/* The next gap beside a nearer line that ends behind `from`; with x > y: none. */
static float2 next_cut(const Work* work, const Stroke interval, const float from) {
    float2 next = float2(INFINITY, -INFINITY);
    if (work->cuts == 0) return next;
    for (uint r = interval.first_run; r <= interval.last_run; ++r) {
        for (int k = 0; k < LA_MOST_CUTS; ++k) {
            const float2 cut = float2(work->cuts[r].from[k], work->cuts[r].to[k]);
            if (cut.y > cut.x && cut.y > from && cut.x < next.x) next = cut;
        }
    }
    return next;
}

/* Gives a stroke its final length and emits its runs. */
static void emit(Work* work, const Stroke interval, const StrokeFilter filter) {
    const Frame frame = work->frame;
    float start = interval.start, end = interval.end;
    uint start_kind = interval.start_kind, end_kind = interval.end_kind;
    const float start_grow = interval.start_overshoot - filter.undershoot;
    const float end_grow = interval.end_overshoot - filter.undershoot;
    if (start_kind == LA_END_PATH) start -= interval.start_overshoot;
    if (end_kind == LA_END_PATH) end += interval.end_overshoot;
    if (start_kind == LA_END_HIDDEN)
        start -=
            interval.first_run == work->first_run ? fmin(start_grow, work->seam_room) : start_grow;
    if (end_kind == LA_END_HIDDEN)
        end += interval.last_run == work->last_run ? fmin(end_grow, work->seam_room) : end_grow;

    /* Back to the start of the stroke, and no farther than the path is drawn. */
    uint i = work->runs[interval.first_run].segment;
    while (i > work->first && segment_span(frame, i).x > start && goes_on(frame, i - 1)) --i;
    const float drawn_from = segment_span(frame, i).x;
    const bool open_start = i == work->first && frame.clipped[i].t0 <= 0.0f;
    if (start < drawn_from && !open_start) {
        start = drawn_from;
        start_kind = LA_END_CLIPPED;
    }
    uint last = work->runs[interval.last_run].segment;
    while (last < work->last && segment_span(frame, last).y < end && goes_on(frame, last)) ++last;
    const float drawn_to = segment_span(frame, last).y;
    const bool open_end = last == work->last && frame.clipped[last].t1 >= 1.0f;
    if (end > drawn_to && !open_end) {
        end = drawn_to;
        end_kind = LA_END_CLIPPED;
    }

    float2 cut = next_cut(work, interval, start);
    float shortest = SHORTEST;
    while (cut.x < end && cut.y > cut.x) {
        shortest = fmax(filter.drop_runs, SHORTEST);
        if (is_cut_off(start_kind) || cut.x - start >= shortest)
            emit_piece(work, i, start, cut.x, start_kind, LA_END_HIDDEN);
        start = cut.y;
        start_kind = LA_END_HIDDEN;
        cut = next_cut(work, interval, start);
    }
    if (is_cut_off(end_kind) || end - start >= shortest)
        emit_piece(work, i, start, end, start_kind, end_kind);
}

/* A share from 0 to 1 that looks random and is always the same for a path. */
static float path_share(const uint path) {
    uint h = path * 0x9E3779B1u;
    h ^= h >> 16;
    h *= 0x85EBCA6Bu;
    h ^= h >> 13;
    return (float)(h >> 8) * (1.0f / 16777216.0f);
}

/* True if a stroke is long enough to be drawn. A stroke that is cut off
 * counts as long enough, because its length is not known. */
static bool is_drawn(const Work* work, const Stroke* stroke, const float drop_runs) {
    const uint tag = work->frame.segments[work->first].tag;
    const float length = stroke->end - stroke->start, height = work->frame.viewport.y;
    if ((1u << (tag & LA_TAG_KIND_MASK) & LA_KINDS_OF_SHAPE) != 0)
        return length >= fmax(drop_runs, LA_LEAST_SHAPE * height);
    if (is_cut_off(stroke->start_kind) || is_cut_off(stroke->end_kind)) return true;
    const bool between_changes =
        stroke->start_kind == LA_END_HIDDEN && stroke->end_kind == LA_END_HIDDEN;
    const bool is_rough = between_changes && (tag & LA_TAG_UNDESIGNED) != 0;
    return length >= (is_rough ? fmax(drop_runs, LA_LEAST_ROUGH * height) : drop_runs);
}

/* All strokes of the path whose runs are r_first to r_end - 1. */
static void filter_path(Work* work, const uint r_first, const uint r_end, StrokeFilter filter) {
    const Frame frame = work->frame;
    const uint tag = frame.segments[work->first].tag;
    filter.overshoot *=
        1.0f - filter.overshoot_variation * path_share(frame.segments[work->first].path);
    work->half_length = arc_pixels(frame.arcs[work->last + 1] - frame.arcs[work->first]) * 0.5f;
    work->seam = (tag & LA_TAG_CLOSED) != 0 && frame.clipped[work->last].t1 >= 1.0f &&
                 frame.clipped[work->first].t0 <= 0.0f &&
                 frame.arcs[work->last + 1] != frame.arcs[work->last] &&
                 frame.arcs[work->first + 1] != frame.arcs[work->first];

    /* The length that is hidden around the seam. */
    float seam_gap = INFINITY;
    if (work->seam) {
        seam_gap = run_interval(work, r_first).start + 2.0f * work->half_length -
                   run_interval(work, r_end - 1).end;
    }
    const bool joined = seam_gap <= SHORTEST || seam_gap < filter.fill_holes;
    work->joined = joined;
    work->seam_room = 0.5f * seam_gap;
    work->first_run = r_first;
    work->last_run = r_end - 1;

    bool has_stroke = false, has_current = false;
    Stroke stroke, current;
    stroke.end_overshoot = 0.0f;
    for (uint r = r_first; r <= r_end; ++r) {
        Stroke next;
        bool merges = false;
        if (r < r_end) {
            next = run_interval(work, r);
            if (r == r_first && joined) {
                next.start = -work->half_length;
                next.start_kind = LA_END_JOIN;
            }
            if (r + 1 == r_end && joined) {
                next.end = work->half_length;
                next.end_kind = LA_END_JOIN;
            }
            const float gap = has_current ? next.start - current.end : 0.0f;
            merges = has_current && (gap <= SHORTEST || gap < filter.fill_holes) &&
                     connected(frame, work->runs[r - 1].segment, work->runs[r].segment);
            if (merges) {
                current.end = next.end;
                current.end_kind = next.end_kind;
                current.last_run = r;
                continue;
            }
        }
        if (has_current) {
            if (is_drawn(work, &current, filter.drop_runs)) {
                set_overshoot(work, &current, filter.overshoot);
                const float grow =
                    stroke.end_overshoot + current.start_overshoot - 2.0f * filter.undershoot;
                const bool meets = has_stroke && current.start - stroke.end <= grow &&
                                   connected(frame, work->runs[stroke.last_run].segment,
                                             work->runs[current.first_run].segment);
                if (meets) {
                    stroke.end = current.end;
                    stroke.end_kind = current.end_kind;
                    stroke.last_run = current.last_run;
                    stroke.end_overshoot = current.end_overshoot;
                } else {
                    if (has_stroke) emit(work, stroke, filter);
                    stroke = current;
                    has_stroke = true;
                }
            }
        }
        if (r == r_end) break;
        current = next;
        has_current = true;
    }
    if (has_stroke) emit(work, stroke, filter);
}

/* out: null to count only. */
static Work make_work(const Frame frame, __global const Run* runs, const uint run_count,
                      __global const RunCuts* cuts, __global const uchar* alpha,
                      const uint capacity, __global Run* out) {
    Work work;
    work.frame = frame;
    work.runs = runs;
    work.run_count = run_count;
    work.cuts = cuts;
    work.alpha = alpha;
    work.capacity = capacity;
    work.out = out;
    work.count = 0;
    return work;
}

/* Segments of the path of run r, and the run after its last one; r itself if r is not its first. */
static uint path_runs_end(const Frame frame, __global const Run* runs, const uint run_count,
                          const uint r, uint* first, uint* last) {
    const uint segment = runs[r].segment;
    *first = segment - frame.segments[segment].from_start;
    *last = segment + frame.segments[segment].to_end;
    if (r > 0 && runs[r - 1].segment >= *first) return r;
    uint end = r + 1;
    while (end < run_count && runs[end].segment <= *last) ++end;
    return end;
}

/* Filters the path whose first run is r. Does nothing for any other run. */
static void filter_path_of(Work* work, const uint r, const StrokeFilter filter) {
    const uint end =
        path_runs_end(work->frame, work->runs, work->run_count, r, &work->first, &work->last);
    if (end > r) filter_path(work, r, end, filter);
}

/* counts[r]: runs that result of the path whose first run is r; 0 for every other run.
 */
KERNEL(filter_count, FilterParameters) {
    const uint r = (uint)get_global_id(0);
    if (r >= args.run_capacity) return;
    counts[r] = 0;
    const uint run_count = record->points[0];
    if (r >= run_count) return;
    const Frame frame = {segments,       clipped, offsets, arcs, to_float2(args.viewport),
                         args.half_width};
    Work work =
        make_work(frame, runs, run_count, args.use_cuts != 0 ? cuts : 0, alpha, args.capacity, 0);
    filter_path_of(&work, r, args.filter);
    counts[r] = work.count;
}

/* Writes the runs of every path from its offset on, and (the first work-item) their record. */
KERNEL(filter_write, FilterParameters) {
    const uint r = (uint)get_global_id(0);
    const uint total = run_offsets[args.run_capacity];
    if (r == 0) {
        write_record(filtered_record, total, args.filtered_capacity, record->sample_total);
        /* A table of runs that was too small left nothing to filter; the host enlarges both. */
        filtered_record->raw_run_total = record->run_total;
    }
    const uint run_count = record->points[0];
    if (r >= run_count || total > args.filtered_capacity) return;
    const Frame frame = {segments,       clipped, offsets, arcs, to_float2(args.viewport),
                         args.half_width};
    Work work = make_work(frame, runs, run_count, args.use_cuts != 0 ? cuts : 0, alpha,
                          args.capacity, filtered + run_offsets[r]);
    filter_path_of(&work, r, args.filter);
}

/* The first and last sample that a filtered run lies on. Beyond an end of the segment the sample at
 * that end counts. */
static int2 samples_under(__global const Run* run) {
    const int last = (int)run->samples - 1;
    return int2(clamp((int)floor(run->start_sample - 0.5f), 0, last),
                clamp((int)floor(run->end_sample - 0.5f) + 1, 0, last));
}

/* Makes hidden samples visible that a filtered run draws. A sample under two runs of a segment
 * belongs to the first of them. */
KERNEL(filter_show, CountParameters) {
    const uint r = (uint)get_global_id(0);
    if (r >= args.count || r >= filtered_record->points[0] || !has_samples(filtered + r)) return;
    __global uchar* own = alpha + filtered[r].address;
    const int2 range = samples_under(filtered + r);
    int first = range.x;
    if (r > 0 && filtered[r - 1].segment == filtered[r].segment && has_samples(filtered + r - 1))
        first = max(first, samples_under(filtered + r - 1).y + 1);
    for (int j = first; j <= range.y; ++j) {
        if (own[j] == 0) own[j] = 255;
    }
}

/* Makes partly visible samples at ends of visibility fully visible, because the stroke is cut at
 * its exact end instead. */
KERNEL(filter_show_ends, CountParameters) {
    const uint r = (uint)get_global_id(0);
    const uint run_count = record->points[0];
    if (r >= args.count || r >= run_count || !has_samples(runs + r)) return;
    __global uchar* own = alpha + runs[r].address;
    const uint2 outermost = end_samples(runs + r);
    if (!shown_across(segments, runs, run_count, r, false))
        own[outermost.x] = max(own[outermost.x], (uchar)LA_FULLY_SHOWN);
    if (!shown_across(segments, runs, run_count, r, true))
        own[outermost.y] = max(own[outermost.y], (uchar)LA_FULLY_SHOWN);
}
