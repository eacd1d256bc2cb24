// strokes: the quad of one run and what its fragments share (§4.4).

#define VARYING out
#include "flags.h"
#include "stroke_varyings.glsl"

const uint join_mitre = 0u;
const uint join_round = 1u;
const uint join_bevel = 2u;

const uint cap_round = 1u;
const uint cap_taper = 2u;
const uint cap_texture = 3u;

uniform vec2 viewport;      // pixels
uniform vec4 tile;          // the part of it that is drawn: lower left corner and size, pixels
uniform float half_width;   // of the stroke where it is widest, pixels
uniform uint join_kind;
uniform float mitre_limit;  // largest length of a mitre over the stroke's width
uniform uvec2 cap_kinds;    // where visibility ends, and where the path does
uniform float cap_length;   // of tapered and textured caps, pixels

uniform uint only_pen;      // PENS: runs of other pens are left out

uniform bool focus_in_scene;
uniform vec4 focus_point;   // pixels, or in the scene
uniform vec2 focus_range;   // radius and falloff, in the same units
uniform float far_opacity;
uniform mat4 world_from_clip;

// A quad reaches this far beyond the stroke's edge: coverage is 0 there (stroke_coverage).
const float fringe = 0.5;
// The place of an end that a run or stroke does not have.
const float far_away = 1e9;

struct Run {
    vec4 ends;      // window position of start and end
    vec4 corners;   // at joins the way from the spine to the left corners, for half-width 1; else 0
    vec4 params;    // arc length at start and end, sample position at start and end
    uvec4 indices;  // atlas address, sample count, flags, segment
    vec4 stroke;    // arc lengths of the whole stroke's ends; window depth of start and end
};

// A run's own axes on the screen.
struct Axes {
    float run_length;
    vec2 along, left;
};

Axes axes_of(Run run) {
    vec2 way = run.ends.zw - run.ends.xy;
    float run_length = length(way);
    vec2 along = run_length > 0.0 ? way / run_length : vec2(1.0, 0.0);
    return Axes(run_length, along, vec2(-along.y, along.x));
}

uint run_end(uint flags, uint end) {
    return flags >> (end == 0u ? LA_RUN_START_SHIFT : LA_RUN_END_SHIFT) & LA_END_MASK;
}
uint stroke_end(uint flags, uint end) {
    return flags >> (end == 0u ? LA_STROKE_START_SHIFT : LA_STROKE_END_SHIFT) & LA_END_MASK;
}
uint cap_of(uint end_kind) { return end_kind == LA_END_PATH ? cap_kinds.y : cap_kinds.x; }

bool is_cap(uint kind) { return kind >= LA_END_HIDDEN; }
bool is_round(uint kind) {
    return kind == LA_END_ROUND || (kind == LA_END_JOIN && join_kind == join_round) ||
           (is_cap(kind) && cap_of(kind) == cap_round);
}
bool is_cut(uint kind) { return is_cap(kind) && cap_of(kind) != cap_round; }

// How far the quad reaches straight beyond an end of the run.
float beyond_end(uint kind) {
    if (is_round(kind)) return half_width + fringe;
#ifdef EXACT_ENDS
    if (is_cut(kind)) return fringe;
#endif
    return 0.0; // cut by the viewport, or faded out
}

// Places one corner of the quad. end: 0 start, 1 end; side: +1 left, -1 right.
void set_corner(Run run, Axes axes, uint end, float side) {
    vec2 point = end == 0u ? run.ends.xy : run.ends.zw;
    uint kind = run_end(run.indices.z, end);
    vec2 offset;
    if (kind == LA_END_JOIN) {
        offset = (end == 0u ? run.corners.xy : run.corners.zw) * (side * (half_width + fringe));
    } else {
        float beyond = beyond_end(kind);
        offset = axes.left * (side * (half_width + fringe)) + axes.along * (end == 0u ? -beyond : beyond);
    }
    vec2 from_start = point + offset - run.ends.xy;
    gl_Position = vec4((point + offset - tile.xy) / tile.zw * 2.0 - 1.0, 0.0, 1.0);
    local = vec2(dot(from_start, axes.along), dot(from_start, axes.left));
}

// The edge of a bevel runs between the outer corners of the two quads. outwards: +1 at the run's end.
vec3 bevel(uint kind, vec2 corner, Axes axes, float outwards) {
    float stretch = length(corner); // 1 / cos of half the turn
    bool bevelled = join_kind == join_bevel || (join_kind == join_mitre && stretch > mitre_limit);
    if (kind != LA_END_JOIN || !bevelled) return vec3(0.0);
    vec2 outer = vec2(dot(corner, axes.along), dot(corner, axes.left)) / stretch;
    return vec3(outer.x * outwards < 0.0 ? -outer : outer, 1.0 - 1.0 / stretch);
}

// Arc lengths of the stroke's ends that have this cap.
vec2 ends_with_cap(Run run, uint cap) {
    uint start = stroke_end(run.indices.z, 0u), end = stroke_end(run.indices.z, 1u);
    return vec2(is_cap(start) && cap_of(start) == cap ? run.stroke.x : -far_away,
                is_cap(end) && cap_of(end) == cap ? run.stroke.y : far_away);
}

// A place in the window as seen from the focus.
vec4 from_focus(vec2 place, float depth) {
    if (!focus_in_scene) return vec4(place - focus_point.xy, 0.0, 1.0);
    vec4 world = world_from_clip * vec4(vec3(place / viewport, depth) * 2.0 - 1.0, 1.0);
    return vec4(world.xyz - focus_point.xyz * world.w, world.w);
}

// Whether all of the run is so far from the focus that nothing of it is drawn.
bool fades_out(Run run) {
#ifdef FOCUS
    if (far_opacity > 0.0) return false;
    vec4 start = from_focus(run.ends.xy, run.stroke.z), end = from_focus(run.ends.zw, run.stroke.w);
    vec3 a = start.xyz / start.w, b = end.xyz / end.w;
    return max(length(a), length(b)) - distance(a, b) > focus_range.x + focus_range.y;
#else
    return false;
#endif
}

// Whether another pen draws the run, or nothing of it is drawn.
bool is_left_out(Run run) {
#ifdef PENS
    if ((run.indices.z >> LA_RUN_PEN_SHIFT & LA_RUN_PEN_MASK) != only_pen) return true;
#endif
    return fades_out(run);
}

void set_run(Run run, Axes axes) {
    uint flags = run.indices.z;
    uint start = run_end(flags, 0u), end = run_end(flags, 1u);
    float run_length = axes.run_length;
    float per_pixel = run_length > 0.0 ? 1.0 / run_length : 0.0;

    run_samples = uvec4(run.indices.x, run.indices.y - 1u, floatBitsToUint(run.params.z),
                        floatBitsToUint((run.params.w - run.params.z) * per_pixel));
    run_line = vec4(is_round(start) ? 0.0 : -far_away, is_round(end) ? run_length : far_away,
                    run.params.x, (run.params.y - run.params.x) * per_pixel);
    run_cuts = vec4(is_cut(start) ? 0.0 : -far_away, is_cut(end) ? run_length : far_away, run_length,
                    (flags & LA_RUN_SOLID) != 0u ? 1.0 : 0.0);
    run_window = vec4(run.ends.xy, axes.along);
    run_priority = flags >> LA_RUN_BIN_SHIFT & LA_RUN_BIN_MASK;
    start_bevel = bevel(start, run.corners.xy, axes, -1.0);
    end_bevel = bevel(end, run.corners.zw, axes, 1.0);

    float stroke_length = run.stroke.y - run.stroke.x;
    // No taper is longer than half the stroke, so the tapers of both ends meet in a point at most.
    stroke_taper = vec3(ends_with_cap(run, cap_taper), 1.0 / min(cap_length, 0.5 * stroke_length + 1e-3));
    stroke_dry = ends_with_cap(run, cap_texture);
    stroke_share = stroke_length > 0.0
                       ? vec2(run.params.x - run.stroke.x, run_line.w) / stroke_length
                       : vec2(0.5, 0.0);
    focus_start = from_focus(run.ends.xy, run.stroke.z);
    focus_way = (from_focus(run.ends.zw, run.stroke.w) - focus_start) * per_pixel;
}
