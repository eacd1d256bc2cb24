// strokes: the quad of one run (§4.4), shared by the geometry-shader and vertex-shader forms and by the
// fragment shader. Numbers as in kernels/segment_table.h.

const uint end_clipped = 0u;
const uint end_join = 1u;
const uint end_round = 2u;
const uint end_hidden = 3u;
const uint end_path = 4u;

const uint join_mitre = 0u;
const uint join_round = 1u;
const uint join_bevel = 2u;

const uint cap_butt = 0u;
const uint cap_round = 1u;
const uint cap_taper = 2u;
const uint cap_texture = 3u;

uniform vec2 viewport;      // pixels
uniform vec4 tile;          // the part of it that is drawn: lower left corner and size, pixels
uniform float half_width;   // of the stroke where it is widest, pixels
uniform uint join_kind;
uniform float mitre_limit;  // largest length of a mitre over the stroke's width
uniform uvec2 cap_kinds;    // where visibility ends, and where the path does

// A quad reaches this far beyond the stroke's edge, for antialiasing.
const float fringe = 1.0;

struct Run {
    vec4 ends;      // window position of start and end
    vec4 corners;   // at joins from the spine to the left corners, for half-width 1; else 0
    vec4 params;    // arc length at start and end, sample position at start and end
    uvec4 indices;  // atlas address, sample count, flags, segment
    vec4 stroke;    // arc lengths of the whole stroke's ends; window depth of start and end
};

struct Corner {
    vec4 position;  // clip space
    vec2 local;     // pixels along the run from its start, and across it to the left
};

uint run_end(uint flags, uint end) { return flags >> (3u * end) & 7u; }
uint stroke_end(uint flags, uint end) { return flags >> (6u + 3u * end) & 7u; }
uint cap_of(uint end_kind) { return end_kind == end_path ? cap_kinds.y : cap_kinds.x; }

// How far the quad reaches straight beyond an end of the stroke.
float beyond_end(uint kind) {
    float reach = half_width + fringe;
    if (kind == end_clipped) return 0.0;
    if (kind == end_round) return reach;
    return cap_of(kind) == cap_round ? reach : fringe;
}

// end: 0 start, 1 end; side: +1 left, -1 right.
Corner stroke_corner(Run run, uint end, float side) {
    vec2 way = run.ends.zw - run.ends.xy;
    float run_length = length(way);
    vec2 along = run_length > 0.0 ? way / run_length : vec2(1.0, 0.0);
    vec2 left = vec2(-along.y, along.x);
    vec2 point = end == 0u ? run.ends.xy : run.ends.zw;
    uint kind = run_end(run.indices.z, end);
    vec2 offset;
    if (kind == end_join) {
        offset = (end == 0u ? run.corners.xy : run.corners.zw) * (side * (half_width + fringe));
    } else {
        float beyond = beyond_end(kind);
        offset = left * (side * (half_width + fringe)) + along * (end == 0u ? -beyond : beyond);
    }
    vec2 from_start = point + offset - run.ends.xy;

    Corner corner;
    corner.position = vec4((point + offset - tile.xy) / tile.zw * 2.0 - 1.0, 0.0, 1.0);
    corner.local = vec2(dot(from_start, along), dot(from_start, left));
    return corner;
}
