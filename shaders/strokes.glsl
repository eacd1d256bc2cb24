// strokes: the quad of one visible run (§4.4), shared by the geometry-shader and vertex-shader forms.

const uint end_butt = 0u;
const uint end_mitre = 1u;
const uint end_round = 2u;

uniform vec2 viewport;     // pixels
uniform float half_width;  // of the stroke, pixels

// A quad reaches this far beyond the stroke's edge, for antialiasing.
const float fringe = 1.0;

struct Run {
    vec4 ends;      // window position of start and end
    vec4 mitres;    // from the spine to the left corner at start and end, for half-width 1
    vec4 params;    // arc length at start and end, sample position at start and end
    uvec4 indices;  // atlas address, sample count, flags, segment
};

struct Corner {
    vec4 position;  // clip space
    vec2 local;     // pixels along the run from its start, and across it to the left
};

uint end_style(Run run, uint end) { return run.indices.z >> (2u * end) & 3u; }

// end: 0 start, 1 end; side: +1 left, -1 right.
Corner stroke_corner(Run run, uint end, float side) {
    vec2 way = run.ends.zw - run.ends.xy;
    float run_length = length(way);
    vec2 along = run_length > 0.0 ? way / run_length : vec2(1.0, 0.0);
    vec2 left = vec2(-along.y, along.x);
    vec2 point = end == 0u ? run.ends.xy : run.ends.zw;
    float reach = half_width + fringe;
    uint style = end_style(run, end);
    vec2 offset = left * side * reach;
    if (style == end_mitre) offset = (end == 0u ? run.mitres.xy : run.mitres.zw) * side * reach;
    if (style == end_round) offset += along * (end == 0u ? -reach : reach);
    vec2 from_start = point + offset - run.ends.xy;

    Corner corner;
    corner.position = vec4((point + offset) / viewport * 2.0 - 1.0, 0.0, 1.0);
    corner.local = vec2(dot(from_start, along), dot(from_start, left));
    return corner;
}
