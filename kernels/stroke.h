/* A run as `strokes` draws it, and how much of a pixel its mark covers: shaders/strokes.frag says
 * the same for GL. Included once, by strokes.cl, with LANES pixels of a row at once. */
#include "kernels.h"
#include "shared/lanes.h"

#define FAR_AWAY 1e9f

/* A run as coverage_at() needs it. */
typedef struct Stroke {
    float2 start, end; /* window positions */
    float2 along;      /* direction */
    float length;
    float2 start_side;   /* direction of the line at which it starts, to the left */
    float2 end_side;     /* of the line at which it ends */
    float before, after; /* pixels that it covers beyond these two lines */
    float round_from;    /* round beyond these, pixels along it */
    float round_to;
    float cut_from, cut_to; /* cut square there */
    float first_sample;     /* position in samples at the start */
    float sample_step;      /* samples per pixel */
    float last_sample;      /* number of the segment's last sample */
    float first_turn;       /* repeats of the mark before the start */
    float turn_step;        /* repeats per pixel */
    float reach;            /* half the width, and the fringe */
    float most;             /* coverage in its middle: a thin line never covers a pixel */
    float opacity;
    bool has_round, has_cut; /* ends of that kind */
    bool is_even;            /* its visibility is 1 all along */
    bool is_solid;           /* the atlas has no samples of it */
    bool is_marked;          /* its mark is not solid */
    bool is_thinned;         /* `density` leaves out shares of it that change along it */
    uint bin;                /* its bin of priority in `density` */
    float next_bin;          /* the share of it that counts in the next bin */
} Stroke;

static uint end_kind(const uint flags, const uint shift) {
    return flags >> shift & LA_END_MASK;
}

static bool has_round_end(const StrokesParameters* args, const uint kind) {
    if (kind == LA_END_ROUND) return true;
    if (kind == LA_END_JOIN) return (args->end_kinds & LA_STROKES_ROUND_JOINS) != 0;
    if (kind == LA_END_HIDDEN) return (args->end_kinds & LA_STROKES_ROUND_CAPS) != 0;
    return kind == LA_END_PATH && (args->end_kinds & LA_STROKES_ROUND_PATHS) != 0;
}

/* Visibility of a stroke from that of a sample, 0 to 255 (shaders/mark.glsl). */
static bool shows_in_full(const uchar alpha, const uint hidden) {
    return hidden != 0 ? alpha == 0 : alpha >= LA_FULLY_SHOWN;
}

/* Whether all samples that any pixel of the run looks at are shown in full: most are. */
static bool is_even_along(__global const Run* run, __global const uchar* alpha, const uint hidden) {
    const float last = (float)(run->samples - 1u);
    const uint from = (uint)clamp(run->start_sample - 1.5f, 0.0f, last);
    const uint to = (uint)clamp(run->end_sample + 1.5f, 0.0f, last);
    __global const uchar* own = alpha + run->address;
    for (uint i = from; i <= to; ++i) {
        if (!shows_in_full(own[i], hidden)) return false;
    }
    return true;
}

/* The weight of a cell. Beyond the grid, that of the nearest cell. */
static float cell_weight(const StrokesParameters* args, __global const float* weights,
                         const uint bin, const int x, const int y) {
    const int2 cells = to_int2(args->cells);
    const int row = (int)bin * cells.y + clamp(y, 0, cells.y - 1);
    return weights[row * cells.x + clamp(x, 0, cells.x - 1)];
}

/* The smallest and the largest weight of a bin that a run's pixels read. If the run passes many
 * cells, the range that weights may have. */
static float2 weights_along(const StrokesParameters* args, __global const Run* run,
                            __global const float* weights, const uint bin) {
    const float2 a = vload2(0, run->start) * args->per_cell - 0.5f;
    const float2 b = vload2(0, run->end) * args->per_cell - 0.5f;
    const int left = convert_int_rtn(fmin(a.x, b.x)), right = convert_int_rtn(fmax(a.x, b.x)) + 1;
    const int below = convert_int_rtn(fmin(a.y, b.y)), above = convert_int_rtn(fmax(a.y, b.y)) + 1;
    if ((right - left) + (above - below) > 8) return float2(0.0f, 1.0f);
    float2 range = float2(1.0f, 0.0f);
    for (int y = below; y <= above; ++y) {
        for (int x = left; x <= right; ++x) {
            const float weight = cell_weight(args, weights, bin, x, y);
            range = float2(fmin(range.x, weight), fmax(range.y, weight));
        }
    }
    return range;
}

/* The stroke's priority for `density`. */
static void find_bin(__global const Run* run, Stroke* s) {
    const uint priority = run->flags >> LA_RUN_BIN_SHIFT & LA_RUN_BIN_MASK;
    s->bin = priority / LA_BIN_STEPS;
    s->next_bin = (float)(priority % LA_BIN_STEPS) * (1.0f / LA_BIN_STEPS);
}

/* What `density` leaves of the stroke. */
static void thin_out(const StrokesParameters* args, __global const Run* run,
                     __global const float* weights, Stroke* s) {
    s->is_thinned = false;
    if (args->cells.v[0] == 0) return;
    find_bin(run, s);
    float2 range = weights_along(args, run, weights, s->bin);
    if (s->next_bin > 0.0f) {
        const float2 next = weights_along(args, run, weights, s->bin + 1u);
        range = range + (next - range) * s->next_bin;
    }
    s->is_thinned = range.x != range.y;
    if (!s->is_thinned) s->opacity *= range.x;
}

/* Sets all of a stroke except what depends on its samples and on `density`. */
INLINED void shape_stroke(const StrokesParameters* args, __global const Run* run, Stroke* s) {
    s->start = vload2(0, run->start);
    s->end = vload2(0, run->end);
    const float2 way = s->end - s->start;
    s->length = sqrt(way.x * way.x + way.y * way.y);
    const float per_pixel = s->length > 0.0f ? 1.0f / s->length : 0.0f;
    s->along = s->length > 0.0f ? way / s->length : float2(1.0f, 0.0f);
    s->reach = args->half_width + LA_STROKE_FRINGE;
    s->most = fmin(1.0f, 2.0f * args->half_width);
    s->opacity = args->opacity;
    const uint flags = run->flags;
    const uint start = end_kind(flags, LA_RUN_START_SHIFT);
    const uint end = end_kind(flags, LA_RUN_END_SHIFT);
    const bool start_round = has_round_end(args, start), end_round = has_round_end(args, end);
    const bool exact = (args->end_kinds & LA_STROKES_EXACT_ENDS) != 0;
    const bool start_cut = exact && start >= LA_END_HIDDEN && !start_round;
    const bool end_cut = exact && end >= LA_END_HIDDEN && !end_round;
    const float2 left = float2(-s->along.y, s->along.x);
    s->start_side = start == LA_END_JOIN ? vload2(0, run->start_corner) : left;
    s->end_side = end == LA_END_JOIN ? vload2(0, run->end_corner) : left;
    s->before = start == LA_END_JOIN ? 0.0f
                : start_round        ? s->reach
                : start_cut          ? LA_STROKE_FRINGE
                                     : 0.0f;
    s->after = end == LA_END_JOIN ? 0.0f : end_round ? s->reach : end_cut ? LA_STROKE_FRINGE : 0.0f;
    s->has_round = start_round || end_round;
    s->round_from = start_round ? 0.0f : -FAR_AWAY;
    s->round_to = end_round ? s->length : FAR_AWAY;
    s->has_cut = start_cut || end_cut;
    s->cut_from = start_cut ? 0.0f : -FAR_AWAY;
    s->cut_to = end_cut ? s->length : FAR_AWAY;
    s->is_solid = exact && (flags & LA_RUN_SOLID) != 0;
    s->first_sample = run->start_sample;
    s->sample_step = (run->end_sample - run->start_sample) * per_pixel;
    s->last_sample = (float)(run->samples - 1u);
    s->is_marked = args->mark_length > 0;
    s->first_turn = run->start_arc * args->per_repeat;
    s->turn_step = (run->end_arc - run->start_arc) * per_pixel * args->per_repeat;
}

INLINED void make_stroke(const StrokesParameters* args, __global const Run* run,
                         __global const uchar* alpha, __global const float* weights, Stroke* s) {
    shape_stroke(args, run, s);
    s->is_even = s->is_solid || is_even_along(run, alpha, args->hidden);
    thin_out(args, run, weights, s);
}

/* The same for a run whose `box` holds the numbers that take long to compute. */
INLINED void make_known_stroke(const StrokesParameters* args, __global const Run* run,
                               const StrokeBox box, Stroke* s) {
    shape_stroke(args, run, s);
    s->is_even = (box.flags & LA_STROKE_EVEN) != 0;
    s->is_thinned = (box.flags & LA_STROKE_THINNED) != 0;
    s->opacity = box.opacity;
    find_bin(run, s);
}

/* The run's visibility at places along it, in pixels: linear between the middles of samples. */
static lanes_float visibility_at(const StrokesParameters* args, const Stroke* s,
                                 __global const uchar* own, const lanes_float along) {
    const lanes_float position = s->first_sample + along * s->sample_step;
    const lanes_float none = 0.0f, all = 1.0f, last = s->last_sample;
    const lanes_float x = fmin(fmax(position - 0.5f, none), last);
    const lanes_int before = FLOOR_TO_INT(x);
    const lanes_int last_one = (int)s->last_sample, after = min(before + 1, last_one);
    const lanes_float a = TO_FLOAT(GATHER_INTS(own, before));
    const lanes_float b = TO_FLOAT(GATHER_INTS(own, after));
    const lanes_float alpha = a + (b - a) * (x - TO_FLOAT(before));
    const lanes_float visible = fmin(alpha * (1.0f / LA_FULLY_SHOWN), all);
    return args->hidden != 0 ? 1.0f - visible : visible;
}

/* The mark at places along the path, in repeats from its middle. */
static lanes_float mark_at(const StrokesParameters* args, __global const float* mark,
                           const lanes_float turns) {
    const lanes_float none = 0.0f, one = 1.0f;
    /* A very short stroke may have more repeats than an int holds, at places where it is not
     * drawn. */
    const lanes_float in_turn = fmin(fmax(turns - TO_FLOAT(FLOOR_TO_INT(turns)), none), one);
    const lanes_float x = in_turn * (float)args->mark_length - 0.5f;
    const lanes_int before = FLOOR_TO_INT(x);
    const lanes_float share = x - TO_FLOAT(before);
    /* The table has the last value before the first one, and the first value behind the last
     * one. */
    const lanes_int first = before + 1, second = before + 2;
    const lanes_float a = GATHER_LANES(mark, first), b = GATHER_LANES(mark, second);
    return a + (b - a) * share;
}

/* The share of lines of a priority that is drawn at places of the window, in cells. */
static lanes_float bin_weight(const StrokesParameters* args, __global const float* weights,
                              const uint bin, const lanes_float x, const lanes_float y) {
    const int2 cells = to_int2(args->cells);
    const lanes_int column = FLOOR_TO_INT(x), row = FLOOR_TO_INT(y);
    const lanes_float right = x - TO_FLOAT(column), up = y - TO_FLOAT(row);
    const lanes_int none = 0, last_x = cells.x - 1, last_y = cells.y - 1;
    const lanes_int x0 = min(max(column, none), last_x), x1 = min(max(column + 1, none), last_x);
    const lanes_int y0 = (min(max(row, none), last_y) + (int)bin * cells.y) * cells.x;
    const lanes_int y1 = (min(max(row + 1, none), last_y) + (int)bin * cells.y) * cells.x;
    const lanes_int at00 = y0 + x0, at10 = y0 + x1, at01 = y1 + x0, at11 = y1 + x1;
    const lanes_float w00 = GATHER_LANES(weights, at00), w10 = GATHER_LANES(weights, at10);
    const lanes_float w01 = GATHER_LANES(weights, at01), w11 = GATHER_LANES(weights, at11);
    const lanes_float below = w00 + (w10 - w00) * right, above = w01 + (w11 - w01) * right;
    return below + (above - below) * up;
}

/* The share of the line that is drawn at places along it, in pixels. */
static lanes_float density_at(const StrokesParameters* args, const Stroke* s,
                              __global const float* weights, const lanes_float along) {
    const lanes_float x = (along * s->along.x + s->start.x) * args->per_cell - 0.5f;
    const lanes_float y = (along * s->along.y + s->start.y) * args->per_cell - 0.5f;
    const lanes_float weight = bin_weight(args, weights, s->bin, x, y);
    if (s->next_bin == 0.0f) return weight;
    return weight + (bin_weight(args, weights, s->bin + 1u, x, y) - weight) * s->next_bin;
}

/* How much of each of LANES pixels in a row the stroke covers, 0 to 1. x, y: the middles of the
 * pixels. rounds false: the stroke has no round ends. rest false: it is even, not cut, not marked
 * and not thinned. */
INLINED lanes_float coverage_at(const StrokesParameters* args, const Stroke* s, const lanes_float x,
                                const float y, const bool rounds, const bool rest,
                                __global const uchar* own, __global const float* mark,
                                __global const float* weights) {
    const lanes_float dx = x - s->start.x, ex = x - s->end.x;
    const float dy = y - s->start.y, ey = y - s->end.y;
    /* If two runs meet on a line, each pixel belongs to one of them: both compute its side
     * alike. */
    const lanes_mask inside = (s->start_side.x * dy - dx * s->start_side.y <= s->before) &
                              (s->end_side.x * ey - ex * s->end_side.y > -s->after);
    const lanes_float across = s->along.x * dy - dx * s->along.y;
    const lanes_float along = dx * s->along.x + s->along.y * dy;
    /* Constants of their own: Oclgrind's min and max take no scalar beside a vector. */
    const lanes_float none = 0.0f, one = 1.0f, most = s->most, length = s->length;
    lanes_float distance = fabs(across);
    if (rounds) {
        const lanes_float outside = fmax(s->round_from - along, along - s->round_to);
        const lanes_float beyond = fmax(outside, none);
        distance = SQUARE_ROOT(beyond * beyond + across * across);
    }
    lanes_float covered = fmin(fmax(s->reach - distance, none), most);
    covered = covered * s->opacity;
    if (rest) {
        if (s->has_cut) {
            const lanes_float over = fmax(s->cut_from - along, along - s->cut_to);
            covered = covered * fmin(fmax(0.5f - over, none), one);
        }
        const lanes_float within = fmin(fmax(along, none), length);
        if (!s->is_even) covered = covered * visibility_at(args, s, own, within);
        if (s->is_thinned) covered = covered * density_at(args, s, weights, within);
        if (s->is_marked)
            covered = covered * mark_at(args, mark, s->first_turn + along * s->turn_step);
    }
    return SELECT(none, covered, inside);
}

/* Coverage over what is there, both of 255, rounded to whole numbers as in pictures. So a stroke
 * over others is the same in whatever pieces they were drawn. */
static lanes_float over(const lanes_float below, const lanes_float covered) {
    const float to_whole = 8388608.0f;
    return (below + covered * (255.0f - below) + to_whole) - to_whole;
}
